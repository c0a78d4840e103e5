// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The features of the system that LLVM's sources ask for, as far as clipc uses them: wasi-libc has
// files, and no processes, signals or threads.
#pragma once
#include <llvm/Config/llvm-config.h>
#include <pwd.h>
#include <signal.h>

#define BUG_REPORT_URL ""
#define ENABLE_BACKTRACES 0
#define ENABLE_CRASH_OVERRIDES 0
#define LLVM_ENABLE_CRASH_DUMPS 0
#define HAVE_DECL_ARC4RANDOM 0
#define HAVE_DECL_FE_ALL_EXCEPT 0
#define HAVE_DECL_STRERROR_S 0
#define HAVE_DLADDR 1
#define HAVE_DLFCN_H 1
#define HAVE_ERRNO_H 1
#define HAVE_FCNTL_H 1
#define HAVE_FUTIMENS 1
#define HAVE_ISATTY 1
#define HAVE_PREAD 1
#define HAVE_STRERROR_R 1
#define HAVE_SYSCONF 1
#define HAVE_SYS_MMAN_H 1
#define HAVE_SYS_STAT_H 1
#define HAVE_SYS_TIME_H 1
#define HAVE_STRUCT_STAT_ST_MTIM_TV_NSEC 1
#define HAVE_UNISTD_H 1
#define LLVM_WINDOWS_PREFER_FORWARD_SLASH 0
#define LTDL_SHLIB_EXT ".so"
#define PACKAGE_BUGREPORT ""
#define PACKAGE_NAME "LLVM"
#define PACKAGE_STRING "LLVM " LLVM_VERSION_STRING
#define PACKAGE_VERSION LLVM_VERSION_STRING
#define PACKAGE_VENDOR ""

// Locks of files fail; there is one user, and no signal is hidden.
#define F_RDLCK 0
#define F_WRLCK 1
#define F_UNLCK 2
#define F_SETLK 6
#define F_SETLKW 7
#define MNT_LOCAL 1
#define SIG_SETMASK 2
inline int sigfillset(sigset_t*) { return 0; }
inline int sigprocmask(int, const sigset_t*, sigset_t*) { return 0; }
inline int pthread_sigmask(int, const sigset_t*, sigset_t*) { return 0; }
inline unsigned getuid() { return 0; }
inline int dup2(int, int) { return -1; }
