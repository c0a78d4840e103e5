# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""On a terminal the messages end with the number of errors and warnings.

usage: counts.py CLIPC SHADER
"""

import os
import pty
import re
import subprocess
import sys

master, slave = pty.openpty()
words = [*sys.argv[1:], "-E", "nothing", "-MT", "x", "-o", os.devnull]
subprocess.run(words, stderr=slave, check=False, env={**os.environ, "TERM": "xterm"})
os.close(slave)
shown = b""
try:
    while part := os.read(master, 1 << 16):  # the terminal hands on what was written bit by bit
        shown += part
except OSError:  # all is read, and nobody writes any more
    pass
shown = re.sub(rb"\x1b\[\?25[hl]", b"", shown)  # Wine hides the cursor while it writes
assert shown.rstrip().endswith(b"1 error and 1 warning generated."), shown[-80:]
