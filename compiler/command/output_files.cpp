// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/output_files.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/spelling.h"
#include "base/system.h"

namespace clipc {
namespace {

Problem CannotWrite(const std::string& path) {
  return {fmt::format("cannot write `{}`: {}", path == "-" ? "standard output" : path,
                      ReasonOf(errno))};
}

bool WriteAll(int file, const std::string& contents) {
  for (std::size_t done = 0; done < contents.size();) {
    const std::ptrdiff_t wrote =
        system::Write(file, contents.data() + done, contents.size() - done);
    if (wrote < 0) return false;
    done += static_cast<std::size_t>(wrote);
  }
  return true;
}

bool WriteAndClose(int file, const std::string& contents) {
  const bool wrote = WriteAll(file, contents);
  const int error = errno;
  const bool closed = system::Close(file);
  if (!wrote) errno = error;
  return wrote && closed;
}

bool HasContents(const std::string& path, std::string_view contents) {
  const int file = system::OpenToRead(path);
  if (file < 0) return false;
  std::array<char, 65536> buffer;
  std::ptrdiff_t got = 0;
  while ((got = system::Read(file, buffer.data(), buffer.size())) > 0) {
    const std::string_view part(buffer.data(), static_cast<std::size_t>(got));
    if (!contents.starts_with(part)) break;
    contents.remove_prefix(part.size());
  }
  system::Close(file);
  return got == 0 && contents.empty();
}

// A new file beside `path`, open for writing; -1 and errno on failure.
int CreateBeside(const std::string& path, unsigned mode, std::string& name) {
  for (int attempt = 0; attempt < 100; ++attempt) {
    name = fmt::format("{}.tmp-{}-{}", path, system::ProcessNumber(), attempt);
    const int file = system::OpenNew(name, mode);
    if (file >= 0 || errno != EEXIST) return file;
  }
  return -1;
}

}  // namespace

OutputFiles::~OutputFiles() {
  for (const File& file : files_) {
    if (!file.temporary.empty()) system::Remove(file.temporary);
  }
}

void OutputFiles::Add(std::string path, std::string contents) {
  files_.push_back({std::move(path), std::move(contents), {}});
}

Result<> OutputFiles::Prepare(File& file) {
  if (file.path == "-") return {};
  constexpr unsigned kNewFile = 0666;
  unsigned mode = kNewFile;
  if (const auto status = system::StatusOf(file.path)) {
    if (status->kind == system::FileKind::kFolder) {
      errno = EISDIR;
      return CannotWrite(file.path);
    }
    if (status->kind != system::FileKind::kRegular) return {};
    // Renaming needs no permission to write the file itself; a file without it is not replaced.
    if (!system::MayWrite(file.path)) return CannotWrite(file.path);
    file.is_kept = unchanged_ == Unchanged::kKept && status->size == file.contents.size() &&
                   HasContents(file.path, file.contents);
    if (file.is_kept) return {};
    // Renaming must replace the file that a symbolic link stands for, not the link.
    file.path = system::ResolveLinks(file.path);
    mode = status->mode;
  }
  std::string name;
  const int descriptor = CreateBeside(file.path, mode, name);
  if (descriptor < 0) return CannotWrite(file.path);
  file.temporary = std::move(name);
  if (mode != kNewFile) system::SetMode(descriptor, mode);  // without the umask: as the old file
  if (!WriteAndClose(descriptor, file.contents)) return CannotWrite(file.path);
  return {};
}

Result<> OutputFiles::Commit() {
  for (File& file : files_) {
    if (Result<> done = Prepare(file); !done) return done;
  }
  // Writing, which may fail, comes before renaming, which hardly can.
  for (const File& file : files_) {
    if (file.is_kept || !file.temporary.empty()) continue;
    const bool is_stdout = file.path == "-";
    const int descriptor = is_stdout ? system::kStandardOutput : system::OpenToWrite(file.path);
    if (descriptor < 0) return CannotWrite(file.path);
    if (!(is_stdout ? WriteAll(descriptor, file.contents)
                    : WriteAndClose(descriptor, file.contents))) {
      return CannotWrite(file.path);
    }
  }
  for (File& file : files_) {
    if (file.temporary.empty()) continue;
    if (!system::Replace(file.temporary, file.path)) return CannotWrite(file.path);
    file.temporary.clear();
  }
  return {};
}

}  // namespace clipc
