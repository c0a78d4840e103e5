// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The floor of a cold start: a static program that does nothing but write a line.
#include <unistd.h>

int main() { return ::write(1, "hello\n", 6) == 6 ? 0 : 1; }
