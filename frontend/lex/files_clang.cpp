// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The files that an #include may enter.
#include "frontend/lex/files_clang.h"

#include <memory>
#include <system_error>
#include <utility>

#include <llvm/ADT/SmallString.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/Path.h>

#include "frontend/lex/source_text.h"

namespace clipc {
namespace {

using llvm::vfs::File;
using llvm::vfs::Status;

std::error_code NoSuchFile() { return std::make_error_code(std::errc::no_such_file_or_directory); }

// The files on disk. LLVM makes them once, under a guard that ThreadSanitizer does not see, since
// LLVM is not compiled with it; this one it sees.
llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> RealFiles() {
  static const auto files = llvm::vfs::getRealFileSystem();
  return files;
}

// A file whose text is in memory; `name` is the one that the disk has.
class TextFile : public File {
 public:
  TextFile(const Status& status, std::string name, std::unique_ptr<llvm::MemoryBuffer> text)
      : status_(Status::copyWithNewSize(status, text->getBufferSize())),
        name_(std::move(name)),
        text_(std::move(text)) {}

  llvm::ErrorOr<Status> status() override { return status_; }
  llvm::ErrorOr<std::string> getName() override { return name_; }
  llvm::ErrorOr<std::unique_ptr<llvm::MemoryBuffer>> getBuffer(const llvm::Twine&, int64_t, bool,
                                                               bool) override {
    return std::move(text_);
  }
  std::error_code close() override { return {}; }

 private:
  Status status_;
  std::string name_;
  std::unique_ptr<llvm::MemoryBuffer> text_;
};

// The file with its text as UTF-8.
llvm::ErrorOr<std::unique_ptr<File>> AsUtf8(std::unique_ptr<File> file) {
  const auto status = file->status();
  auto name = file->getName();
  if (!status || !name || status->getSize() > kMaxSourceBytes) return file;
  auto buffer = file->getBuffer(status->getName(), static_cast<int64_t>(status->getSize()));
  if (!buffer) return buffer.getError();
  if (const llvm::StringRef bytes = (*buffer)->getBuffer(); IsUtf16(bytes)) {
    std::string text = bytes.str();
    ConvertUtf16(text);
    *buffer = llvm::MemoryBuffer::getMemBufferCopy(text, status->getName());
  }
  return std::make_unique<TextFile>(*status, std::move(*name), std::move(*buffer));
}

class RegularFiles : public llvm::vfs::ProxyFileSystem {
 public:
  explicit RegularFiles(const std::string& sandbox)
      : ProxyFileSystem(RealFiles()), has_sandbox_(!sandbox.empty()) {
    llvm::SmallString<256> real;
    if (!has_sandbox_ || llvm::sys::fs::real_path(sandbox, real)) return;
    root_ = llvm::sys::path::convert_to_slash(real);
    if (!root_.ends_with('/')) root_ += '/';
  }

  llvm::ErrorOr<Status> status(const llvm::Twine& path) override {
    auto found = ProxyFileSystem::status(path);
    if (!found || found->isDirectory()) return found;
    if (!found->isRegularFile() || !MayRead(path)) return NoSuchFile();
    return found;
  }

  llvm::ErrorOr<std::unique_ptr<File>> openFileForRead(const llvm::Twine& path) override {
    if (auto found = status(path); !found) return found.getError();
    auto file = ProxyFileSystem::openFileForRead(path);
    if (!file) return file;
    // The path may lead elsewhere by now; the name of an open file is where it lies.
    auto name = (*file)->getName();
    if (has_sandbox_ && (!name || !MayRead(*name))) return NoSuchFile();
    return AsUtf8(std::move(*file));
  }

 private:
  bool MayRead(const llvm::Twine& path) const {
    if (!has_sandbox_) return true;
    llvm::SmallString<256> real;
    return !root_.empty() && !llvm::sys::fs::real_path(path, real) &&
           llvm::sys::path::convert_to_slash(real).starts_with(root_);
  }

  bool has_sandbox_;
  std::string root_;  // with a slash at its end; empty: there is no such folder
};

}  // namespace

llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> RegularFilesIn(const std::string& sandbox) {
  return new RegularFiles(sandbox);
}

}  // namespace clipc
