// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Names of files are passed to the functions that take UTF-16, so that neither the code page nor,
// by the prefix "\\?\", the limit of 260 characters matters.
#ifdef _WIN32
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <io.h>
#include <share.h>
#include <sys/stat.h>
// clang-format off: the second needs the first
#include <windows.h>
#include <shellapi.h>
// clang-format on

#include "base/system.h"

namespace clipc::system {
namespace {

constexpr unsigned kReadOnly = 0444;
constexpr unsigned kReadAndWrite = 0666;

std::wstring ToUtf16(std::string_view text) {
  const int size = static_cast<int>(text.size());
  std::wstring wide(text.size(), L'\0');  // UTF-16 has no more units than UTF-8 has bytes
  wide.resize(static_cast<std::size_t>(
      MultiByteToWideChar(CP_UTF8, 0, text.data(), size, wide.data(), size)));
  return wide;
}

std::string ToUtf8(std::wstring_view wide) {
  std::string text(3 * wide.size(), '\0');
  text.resize(static_cast<std::size_t>(
      WideCharToMultiByte(CP_UTF8, 0, wide.data(), static_cast<int>(wide.size()), text.data(),
                          static_cast<int>(text.size()), nullptr, nullptr)));
  return text;
}

// The path as Windows' functions take it. /dev/null becomes NUL, because makefiles for several
// systems write to it.
std::wstring Wide(const std::string& path) {
  if (path == "/dev/null") return L"NUL";
  std::wstring wide = ToUtf16(path);
  constexpr std::size_t kAlwaysTaken = 240;
  std::wstring full(GetFullPathNameW(wide.c_str(), 0, nullptr, nullptr), L'\0');
  full.resize(
      GetFullPathNameW(wide.c_str(), static_cast<DWORD>(full.size()), full.data(), nullptr));
  if (full.size() < kAlwaysTaken || full.starts_with(L"\\\\?\\")) return wide;
  return full.starts_with(L"\\\\") ? L"\\\\?\\UNC" + full.substr(1) : L"\\\\?\\" + full;
}

int ErrnoOf(DWORD error) {
  switch (error) {
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_INVALID_NAME:
    case ERROR_BAD_NETPATH: return ENOENT;
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
    case ERROR_WRITE_PROTECT: return EACCES;
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL: return ENOSPC;
    case ERROR_FILENAME_EXCED_RANGE: return ENAMETOOLONG;
    default: return EIO;
  }
}

std::optional<FileStatus> StatusOfHandle(HANDLE file) {
  FileStatus result;
  if (GetFileType(file) != FILE_TYPE_DISK) return result;
  BY_HANDLE_FILE_INFORMATION about;
  if (!GetFileInformationByHandle(file, &about)) {
    errno = ErrnoOf(GetLastError());
    return std::nullopt;
  }
  const DWORD attributes = about.dwFileAttributes;
  result.kind = attributes & FILE_ATTRIBUTE_DIRECTORY ? FileKind::kFolder : FileKind::kRegular;
  result.size = std::uint64_t{about.nFileSizeHigh} << 32 | about.nFileSizeLow;
  result.mode = attributes & FILE_ATTRIBUTE_READONLY ? kReadOnly : kReadAndWrite;
  result.identity = {about.dwVolumeSerialNumber,
                     std::uint64_t{about.nFileIndexHigh} << 32 | about.nFileIndexLow};
  // In 100 nanoseconds since 1601.
  constexpr std::int64_t k1970 = 116'444'736'000'000'000;
  const auto modified =
      static_cast<std::int64_t>(std::uint64_t{about.ftLastWriteTime.dwHighDateTime} << 32 |
                                about.ftLastWriteTime.dwLowDateTime);
  result.modified = (modified - k1970) * 100;
  return result;
}

std::atomic<bool> g_is_interrupted = false;

// Opens a file or folder to ask for its status. Returns INVALID_HANDLE_VALUE and sets errno on
// failure.
HANDLE OpenToAsk(const std::string& path) {
  HANDLE file =
      CreateFileW(Wide(path).c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                  nullptr, OPEN_EXISTING, FILE_FLAG_BACKUP_SEMANTICS, nullptr);
  if (file == INVALID_HANDLE_VALUE) errno = ErrnoOf(GetLastError());
  return file;
}

int Open(const std::string& path, int flags, int mode = 0) {
  const int file = _wsopen(Wide(path).c_str(), flags | _O_BINARY | _O_NOINHERIT, _SH_DENYNO, mode);
  if (file >= 0 || errno != EACCES) return file;
  // Windows refuses to open a folder for want of permission.
  const auto status = system::StatusOf(path);
  errno = status && status->kind == FileKind::kFolder ? EISDIR : EACCES;
  return -1;
}

}  // namespace

std::optional<FileStatus> StatusOf(const std::string& path) {
  HANDLE file = OpenToAsk(path);
  if (file == INVALID_HANDLE_VALUE) return std::nullopt;
  const auto status = StatusOfHandle(file);
  CloseHandle(file);
  return status;
}

std::optional<FileStatus> StatusOf(int file) {
  // NOLINTNEXTLINE(performance-no-int-to-ptr): the library's way to say it
  const auto handle = reinterpret_cast<HANDLE>(_get_osfhandle(file));
  if (handle == INVALID_HANDLE_VALUE) {
    errno = EBADF;
    return std::nullopt;
  }
  // Standard input under Wine may be a file that can be read but has no status.
  return StatusOfHandle(handle).value_or(FileStatus{});
}

bool MayWrite(const std::string& path) { return _waccess(Wide(path).c_str(), 2) == 0; }

std::string ResolveLinks(const std::string& path) {
  HANDLE file = OpenToAsk(path);
  if (file == INVALID_HANDLE_VALUE) return path;
  std::wstring wide(GetFinalPathNameByHandleW(file, nullptr, 0, 0), L'\0');
  wide.resize(GetFinalPathNameByHandleW(file, wide.data(), static_cast<DWORD>(wide.size()), 0));
  CloseHandle(file);
  return wide.empty() ? path : ToUtf8(wide);  // begins with "\\?\"
}

int OpenToRead(const std::string& path) { return Open(path, _O_RDONLY); }
int OpenToWrite(const std::string& path) { return Open(path, _O_WRONLY | _O_TRUNC); }

int OpenNew(const std::string& path, unsigned mode) {
  return Open(path, _O_WRONLY | _O_CREAT | _O_EXCL, mode & 0222 ? _S_IREAD | _S_IWRITE : _S_IREAD);
}

void SetMode(int, unsigned) {}  // OpenNew has given the one bit that there is

std::ptrdiff_t Read(int file, char* to, std::size_t size) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  return _read(file, to, static_cast<unsigned>(size < kMost ? size : kMost));
}

std::ptrdiff_t Write(int file, const char* from, std::size_t size) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  return _write(file, from, static_cast<unsigned>(size < kMost ? size : kMost));
}

bool Close(int file) { return _close(file) == 0; }

// A file cannot be replaced while another process reads or replaces it, so Replace tries again for
// about a second.
bool Replace(const std::string& from, const std::string& to) {
  const std::wstring wide_from = Wide(from);
  const std::wstring wide_to = Wide(to);
  constexpr int kAttempts = 200;
  for (int attempt = 1;; ++attempt) {
    if (MoveFileExW(wide_from.c_str(), wide_to.c_str(), MOVEFILE_REPLACE_EXISTING)) return true;
    const DWORD error = GetLastError();
    const bool may_pass = error == ERROR_ACCESS_DENIED || error == ERROR_SHARING_VIOLATION;
    if (!may_pass || attempt == kAttempts || !MayWrite(to)) {
      errno = ErrnoOf(error);
      return false;
    }
    Sleep(5);
  }
}

void Remove(const std::string& path) { _wunlink(Wide(path).c_str()); }

void CatchInterrupts() {
  SetConsoleCtrlHandler(
      [](DWORD) -> BOOL {
        g_is_interrupted = true;
        return TRUE;
      },
      TRUE);
}

bool IsInterrupted() { return g_is_interrupted; }

bool WaitForInterrupt(unsigned milliseconds) {
  if (!IsInterrupted()) Sleep(milliseconds);
  return IsInterrupted();
}

unsigned ProcessNumber() { return GetCurrentProcessId(); }

bool ErrorsAreOnTerminal() {
  const char* terminal = std::getenv("TERM");
  HANDLE errors = GetStdHandle(STD_ERROR_HANDLE);
  DWORD mode = 0;
  if ((terminal && std::string_view(terminal) == "dumb") || !GetConsoleMode(errors, &mode))
    return false;
  constexpr DWORD kObeyEscapes = 0x0004;  // ENABLE_VIRTUAL_TERMINAL_PROCESSING
  return SetConsoleMode(errors, mode | kObeyEscapes) != 0;
}

bool OutputIsOnTerminal() {
  DWORD mode = 0;
  return GetConsoleMode(GetStdHandle(STD_OUTPUT_HANDLE), &mode) != 0;
}

void PrepareStandardStreams() {
  for (const int number : {0, 1, 2}) _setmode(number, _O_BINARY);
  // The C library would hold back messages for a pipe until the end, after everything that Write()
  // has written.
  std::setvbuf(stderr, nullptr, _IONBF, 0);
}

std::span<const char* const> Arguments(int argc, char** argv) {
  int count = 0;
  wchar_t** wide = CommandLineToArgvW(GetCommandLineW(), &count);
  if (!wide) return {argv + 1, argv + argc};
  // The arguments live as long as the program.
  auto& texts = *new std::vector<std::string>;
  auto& arguments = *new std::vector<const char*>;
  for (int i = 1; i < count; ++i) texts.push_back(ToUtf8(wide[i]));
  for (const std::string& text : texts) arguments.push_back(text.c_str());
  LocalFree(wide);
  return arguments;
}

}  // namespace clipc::system
#endif
