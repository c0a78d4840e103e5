// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Debian's llvm-config.h, which is for Linux, changed to what LLVM's own build would write for
// Windows. No #pragma once: the other file has a guard, and this one may come again after it.
#include_next <llvm/Config/llvm-config.h>
#undef LLVM_ON_UNIX
#undef LLVM_ENABLE_ZLIB
#undef LLVM_ENABLE_ZSTD
#undef LLVM_ENABLE_LIBXML2
#undef LLVM_ENABLE_CURL
#undef LLVM_ENABLE_HTTPLIB
#undef LLVM_ENABLE_PLUGINS
#undef LLVM_DEFAULT_TARGET_TRIPLE
#undef LLVM_HOST_TRIPLE
#define LLVM_DEFAULT_TARGET_TRIPLE "x86_64-w64-windows-gnu"
#define LLVM_HOST_TRIPLE "x86_64-w64-windows-gnu"
