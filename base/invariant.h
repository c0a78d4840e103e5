// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdio>
#include <cstdlib>

// An invariant of clipc itself, never a property of the user's shader: prints the place and aborts,
// in every build.
#define CLIPC_CHECK(condition)                                                                    \
  ((condition) ? void(0)                                                                          \
               : (std::fprintf(stderr, "%s:%d: clipc invariant broken: %s\n", __FILE__, __LINE__, \
                               #condition),                                                       \
                  std::abort()))
