/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* With it std::filesystem::copy_file, which nothing calls, is written without streams: they and
   the locales that they name would be a tenth of the module. */
#pragma once
#include <errno.h>
#include <sys/types.h>

static inline ssize_t sendfile(int to, int from, off_t* offset, size_t count) {
  (void)to, (void)from, (void)offset, (void)count;
  errno = ENOTSUP;
  return -1;
}
