# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Prints a function whose body starts with many copies of a text. usage: nested.py COUNT TEXT"""

import sys

print("void f() {", sys.argv[2] * int(sys.argv[1]))
