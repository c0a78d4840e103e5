// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdio>
#include <cstdlib>

// Checks an invariant of clipc itself, never a property of the user's shader. In every build, a
// condition that is false prints its place and aborts.
#define CLIPC_CHECK(condition)                                                                    \
  ((condition) ? void(0)                                                                          \
               : (std::fprintf(stderr, "%s:%d: clipc invariant broken: %s\n", __FILE__, __LINE__, \
                               #condition),                                                       \
                  std::abort()))
