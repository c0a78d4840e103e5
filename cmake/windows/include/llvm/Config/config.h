// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The features of Windows that LLVM's sources ask for, as far as clipc uses them.
#pragma once
#include <llvm/Config/llvm-config.h>

#define BUG_REPORT_URL ""
#define ENABLE_BACKTRACES 0
#define ENABLE_CRASH_OVERRIDES 0
#define LLVM_ENABLE_CRASH_DUMPS 0
#define HAVE_DECL_ARC4RANDOM 0
#define HAVE_DECL_FE_ALL_EXCEPT 1
#define HAVE_DECL_STRERROR_S 1
#define HAVE_ERRNO_H 1
#define HAVE_FCNTL_H 1
#define HAVE_ISATTY 1
#define HAVE_SYS_STAT_H 1
#define HAVE_SYS_TIME_H 1
#define HAVE_UNISTD_H 1
#define HAVE__CHSIZE_S 1
#define LLVM_WINDOWS_PREFER_FORWARD_SLASH 1
#define LTDL_SHLIB_EXT ".dll"
#define PACKAGE_BUGREPORT ""
#define PACKAGE_NAME "LLVM"
#define PACKAGE_STRING "LLVM " LLVM_VERSION_STRING
#define PACKAGE_VERSION LLVM_VERSION_STRING
#define PACKAGE_VENDOR ""
#define stricmp _stricmp
#define strdup _strdup
