/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* wasi-libc has none; nothing of clipc asks how full a disk is. */
#pragma once
#include <errno.h>
#include <sys/types.h>

struct statvfs {
  unsigned long f_bsize, f_frsize, f_flag, f_flags;
  fsblkcnt_t f_blocks, f_bfree, f_bavail;
};
static inline int statvfs(const char* path, struct statvfs* to) {
  (void)path, (void)to;
  errno = ENOSYS;
  return -1;
}
static inline int fstatvfs(int file, struct statvfs* to) {
  (void)file;
  return statvfs("", to);
}
