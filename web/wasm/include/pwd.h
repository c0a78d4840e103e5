/* SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception */
/* LLVM expands `~` with it, which clipc never asks for: there are no users. */
#pragma once
struct passwd {
  char* pw_dir;
};
static inline struct passwd* getpwnam(const char* name) {
  (void)name;
  return 0;
}
static inline struct passwd* getpwuid(unsigned user) {
  (void)user;
  return 0;
}
static inline int getpwnam_r(const char* name, struct passwd* entry, char* buffer,
                             __SIZE_TYPE__ size, struct passwd** result) {
  (void)name, (void)entry, (void)buffer, (void)size;
  *result = 0;
  return 0;
}
static inline int getpwuid_r(unsigned user, struct passwd* entry, char* buffer, __SIZE_TYPE__ size,
                             struct passwd** result) {
  (void)user;
  return getpwnam_r("", entry, buffer, size, result);
}
