/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* Included first everywhere: what wasi-libc lacks of POSIX and the sources of LLVM, libc++ and
   clipc name. posix.cpp has the functions. */
#pragma once
#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#ifndef DT_SOCK
#define DT_SOCK 12
#endif
#ifndef F_DUPFD_CLOEXEC
#define F_DUPFD_CLOEXEC 1030
#endif

#ifdef __cplusplus
extern "C" {
#endif
/* Resolves symbolic links, "." and "..". */
char* realpath(const char* path, char* resolved);
/* Files have no modes there: these do nothing. */
int chmod(const char* path, mode_t mode);
int fchmod(int file, mode_t mode);
int fchmodat(int folder, const char* path, mode_t mode, int flags);
mode_t umask(mode_t mask);
/* The functions that fail. */
int dup(int file);
int chown(const char* path, uid_t user, gid_t group);
int fchown(int file, uid_t user, gid_t group);
#ifdef __cplusplus
}
#endif
