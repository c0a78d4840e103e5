// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/output_files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

namespace clipc {
namespace {

std::string Problem(const std::string& path) {
  return fmt::format("cannot write `{}`: {}", path == "-" ? "standard output" : path,
                     std::strerror(errno));
}

bool WriteAll(int file, const std::string& contents) {
  for (std::size_t done = 0; done < contents.size();) {
    const ssize_t wrote = write(file, contents.data() + done, contents.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote < 0) return false;
    done += static_cast<std::size_t>(wrote);
  }
  return true;
}

bool WriteAndClose(int file, const std::string& contents) {
  const bool wrote = WriteAll(file, contents);
  const int error = errno;
  const bool closed = close(file) == 0;
  if (!wrote) errno = error;
  return wrote && closed;
}

// The file that a symbolic link stands for: renaming must replace that, not the link.
std::string BehindLinks(const std::string& path) {
  const std::unique_ptr<char, decltype(&free)> real(realpath(path.c_str(), nullptr), &free);
  return real ? real.get() : path;
}

// A new file beside `path`, open for writing; -1 and errno on failure.
int CreateBeside(const std::string& path, mode_t mode, std::string& name) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    name = fmt::format("{}.tmp-{}-{}", path, getpid(), attempt);
    const int file = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

}  // namespace

OutputFiles::~OutputFiles() {
  for (const File& file : files_) {
    if (!file.temporary.empty()) unlink(file.temporary.c_str());
  }
}

void OutputFiles::Add(std::string path, std::string contents) {
  files_.push_back({std::move(path), std::move(contents), {}});
}

std::string OutputFiles::Prepare(File& file) {
  if (file.path == "-") return {};
  struct stat status{};
  mode_t mode = 0666;
  if (stat(file.path.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) {
      errno = EISDIR;
      return Problem(file.path);
    }
    if (!S_ISREG(status.st_mode)) return {};
    // Renaming needs no permission to write the file itself; a file without it is not replaced.
    if (access(file.path.c_str(), W_OK) != 0) return Problem(file.path);
    file.path = BehindLinks(file.path);
    mode = status.st_mode & 07777;
  }
  std::string name;
  const int descriptor = CreateBeside(file.path, mode, name);
  if (descriptor < 0) return Problem(file.path);
  file.temporary = std::move(name);
  if (mode != 0666) fchmod(descriptor, mode);  // without the umask: as the old file
  return WriteAndClose(descriptor, file.contents) ? std::string() : Problem(file.path);
}

std::string OutputFiles::Commit() {
  for (File& file : files_) {
    if (std::string problem = Prepare(file); !problem.empty()) return problem;
  }
  // Writing, which may fail, comes before renaming, which hardly can.
  for (const File& file : files_) {
    if (!file.temporary.empty()) continue;
    const bool is_stdout = file.path == "-";
    const int descriptor =
        is_stdout ? STDOUT_FILENO : open(file.path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC);
    if (descriptor < 0) return Problem(file.path);
    if (!(is_stdout ? WriteAll(descriptor, file.contents)
                    : WriteAndClose(descriptor, file.contents))) {
      return Problem(file.path);
    }
  }
  for (File& file : files_) {
    if (file.temporary.empty()) continue;
    if (std::rename(file.temporary.c_str(), file.path.c_str()) != 0) return Problem(file.path);
    file.temporary.clear();
  }
  return {};
}

void FileSet::Add(const std::string& path) {
  struct stat status{};
  paths_.insert(path);
  if (stat(path.c_str(), &status) == 0) files_.emplace(status.st_dev, status.st_ino);
}

bool FileSet::Has(const std::string& path) const {
  struct stat status{};
  return paths_.contains(path) || (!files_.empty() && stat(path.c_str(), &status) == 0 &&
                                   files_.contains({status.st_dev, status.st_ino}));
}

bool IsDirectory(const std::string& path) {
  struct stat status{};
  return stat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

}  // namespace clipc
