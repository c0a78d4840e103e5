# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""On a terminal a line shows the progress, and in its place is at the end what was done.

usage: progress.py CLIPC
"""

import os
import pty
import re
import subprocess
import sys

master, slave = pty.openpty()
words = [sys.argv[1], "-D", "A={1,2,3}", "bad.hlsl", "-o", "out"]
subprocess.run(words, stderr=slave, check=True, env={**os.environ, "TERM": "xterm"})
os.close(slave)
shown = b""
try:
    while part := os.read(master, 1 << 16):
        shown += part
except OSError:  # all is read, and nobody writes any more
    pass
shown = re.sub(rb"\x1b\[\?25[hl]", b"", shown)  # Wine hides the cursor while it writes
assert b"[1/3] bad.hlsl A=1" in shown, shown
assert re.search(rb"\r\x1b\[Kclipc: 3 compiled, 3 files, [\d.]+ s\r+\n$", shown), shown
