// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The files that an #include may enter.
#include "frontend/lex/files_clang.h"

#include <memory>
#include <system_error>
#include <utility>

#include <llvm/ADT/SmallString.h>
#include <llvm/Support/FileSystem.h>
#include <llvm/Support/Path.h>

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
    if (!file || !has_sandbox_) return file;
    // The path may lead elsewhere by now; the name of an open file is where it lies.
    auto name = (*file)->getName();
    if (!name || !MayRead(*name)) return NoSuchFile();
    return file;
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
