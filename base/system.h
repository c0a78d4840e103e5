// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

// The functions that each system has in its own way: files, the standard streams, the terminal.
// system_posix.cpp and system_windows.cpp define them. Paths are UTF-8; files are descriptors, and
// their contents bytes. A function that fails sets errno.
namespace clipc::system {

enum class FileKind : std::uint8_t { kRegular, kFolder, kOther };

struct FileStatus {
  FileKind kind = FileKind::kOther;
  std::uint64_t size = 0;  // of a regular file, in bytes
  unsigned mode = 0;       // its permissions, as OpenNew takes them
  // The volume of the file and its number there, which are the same for every path to the file.
  std::pair<std::uint64_t, std::uint64_t> identity;
  std::int64_t modified = 0;  // when, in nanoseconds since 1970
};

// The status of a file; none if there is no such file.
std::optional<FileStatus> StatusOf(const std::string& path);
std::optional<FileStatus> StatusOf(int file);

// Whether the permissions of an existing file let this process write it.
bool MayWrite(const std::string& path);

// The path of the file that a symbolic link leads to; `path` itself if there is no such file.
std::string ResolveLinks(const std::string& path);

inline constexpr int kStandardInput = 0;
inline constexpr int kStandardOutput = 1;

// The functions that open return a descriptor, or -1. No other process inherits it.
int OpenToRead(const std::string& path);
// Opens an existing file and removes its contents.
int OpenToWrite(const std::string& path);
// Makes a new file and opens it; fails with EEXIST if there is a file of that name.
int OpenNew(const std::string& path, unsigned mode);
// Gives an open file the permissions `mode`, whatever permissions new files get.
void SetMode(int file, unsigned mode);

// The functions that read and write return the number of bytes, which is 0 at the end of the file,
// or -1 on failure.
std::ptrdiff_t Read(int file, char* to, std::size_t size);
std::ptrdiff_t Write(int file, const char* from, std::size_t size);
bool Close(int file);

// Gives the file `from` the name `to`, which at any moment has the old contents or the new ones.
bool Replace(const std::string& from, const std::string& to);
void Remove(const std::string& path);

// Makes the interrupts of a terminal (SIGINT, SIGTERM, Ctrl+C) something that the program asks for,
// in place of its end.
void CatchInterrupts();
bool IsInterrupted();
// Waits so long, or until an interrupt. Returns whether there was one since CatchInterrupts().
bool WaitForInterrupt(unsigned milliseconds);

// A number that no other running process has.
unsigned ProcessNumber();

// Whether standard error is a terminal that obeys escape sequences.
bool ErrorsAreOnTerminal();
// Whether standard output is shown to a person.
bool OutputIsOnTerminal();

// For main(): makes standard streams carry bytes as they are, and keeps the numbers of closed ones
// from other files.
void PrepareStandardStreams();

// For main(): the arguments after the program's name, in UTF-8.
std::span<const char* const> Arguments(int argc, char** argv);

}  // namespace clipc::system
