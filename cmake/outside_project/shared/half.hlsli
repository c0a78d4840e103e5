// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#define HALF(p) (0.5 * (p))
