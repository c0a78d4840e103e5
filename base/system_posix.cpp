// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#ifndef _WIN32
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string_view>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#ifndef __wasi__
#include <csignal>
#endif

#include "base/system.h"

namespace clipc::system {
namespace {

FileStatus From(const struct stat& status) {
  FileStatus result;
  if (S_ISREG(status.st_mode)) result.kind = FileKind::kRegular;
  if (S_ISDIR(status.st_mode)) result.kind = FileKind::kFolder;
  result.size = static_cast<std::uint64_t>(status.st_size);
  result.mode = status.st_mode & 07777;
  result.identity = {status.st_dev, status.st_ino};
#ifdef __APPLE__
  const timespec& modified = status.st_mtimespec;
#else
  const timespec& modified = status.st_mtim;
#endif
  result.modified = std::int64_t{modified.tv_sec} * 1'000'000'000 + modified.tv_nsec;
  return result;
}

volatile int g_is_interrupted = 0;  // as std::sig_atomic_t

}  // namespace

std::optional<FileStatus> StatusOf(const std::string& path) {
  struct stat status{};
  return stat(path.c_str(), &status) == 0 ? std::optional(From(status)) : std::nullopt;
}

std::optional<FileStatus> StatusOf(int file) {
  struct stat status{};
  return fstat(file, &status) == 0 ? std::optional(From(status)) : std::nullopt;
}

bool MayWrite(const std::string& path) { return access(path.c_str(), W_OK) == 0; }

std::string ResolveLinks(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(realpath(path.c_str(), nullptr),
                                                         &std::free);
  return real ? real.get() : path;
}

int OpenToRead(const std::string& path) { return open(path.c_str(), O_RDONLY | O_CLOEXEC); }

int OpenToWrite(const std::string& path) {
  return open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
}

int OpenNew(const std::string& path, unsigned mode) {
  return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, static_cast<mode_t>(mode));
}

void SetMode(int file, unsigned mode) { fchmod(file, static_cast<mode_t>(mode)); }

std::ptrdiff_t Read(int file, char* to, std::size_t size) {
  for (;;) {
    const ssize_t got = read(file, to, size);
    if (got >= 0 || errno != EINTR) return got;
  }
}

std::ptrdiff_t Write(int file, const char* from, std::size_t size) {
  for (;;) {
    const ssize_t wrote = write(file, from, size);
    if (wrote >= 0 || errno != EINTR) return wrote;
  }
}

bool Close(int file) { return close(file) == 0; }

bool Replace(const std::string& from, const std::string& to) {
  return std::rename(from.c_str(), to.c_str()) == 0;
}

void Remove(const std::string& path) { unlink(path.c_str()); }

#ifdef __wasi__
void CatchInterrupts() {}  // there are none
#else
void CatchInterrupts() {
  struct sigaction action{};
  action.sa_handler = [](int) { g_is_interrupted = 1; };
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}
#endif

bool IsInterrupted() { return g_is_interrupted != 0; }

// A signal that comes just before nanosleep() is seen after it.
bool WaitForInterrupt(unsigned milliseconds) {
  const timespec time = {static_cast<std::time_t>(milliseconds / 1000),
                         static_cast<long>(milliseconds % 1000 * 1'000'000)};
  if (!IsInterrupted()) nanosleep(&time, nullptr);
  return IsInterrupted();
}

unsigned ProcessNumber() { return static_cast<unsigned>(getpid()); }

bool ErrorsAreOnTerminal() {
  const char* terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && terminal && std::string_view(terminal) != "dumb";
}

bool OutputIsOnTerminal() { return isatty(STDOUT_FILENO) != 0; }

// The next file that is opened would get the number of a closed standard stream, and with it
// messages or GLSL. A null device that is open for the wrong direction keeps the number, and using
// it is an error.
void PrepareStandardStreams() {
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(number, F_GETFD) < 0) open("/dev/null", number == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

std::span<const char* const> Arguments(int argc, char** argv) { return {argv + 1, argv + argc}; }

}  // namespace clipc::system
#endif
