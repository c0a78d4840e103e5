// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include <llvm/ADT/IntrusiveRefCntPtr.h>
#include <llvm/Support/VirtualFileSystem.h>

// For the *_clang.cpp files, which alone include Clang.
namespace clipc {

// The file system with regular files only: `#include "/dev/zero"` finds no file. UTF-16 with a byte
// order mark is read as UTF-8, as by dxc. When `sandbox` is
// not empty, it has only the files in that folder: what counts is where a file lies once links are
// followed, at the time when it is opened.
llvm::IntrusiveRefCntPtr<llvm::vfs::FileSystem> RegularFilesIn(const std::string& sandbox);

}  // namespace clipc
