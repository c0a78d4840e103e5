# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Several processes write the same output again and again; each succeeds.

usage: at_once.py CLIPC SHADER OUTPUT
"""

import subprocess
import sys

clipc, shader, output = sys.argv[1:]
for _ in range(3):
    running = [subprocess.Popen([clipc, shader, "-o", output]) for _ in range(8)]
    assert [process.wait() for process in running] == [0] * 8
