# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""SPIR-V is not written to a terminal, but GLSL is, and SPIR-V to a pipe.

usage: to_terminal.py CLIPC SHADER
"""

import os
import pty
import subprocess
import sys

clipc, shader = sys.argv[1:]


def run_on_terminal(*words):
    """(exit code, the start of what the terminal shows)"""
    master, slave = pty.openpty()
    done = subprocess.run([clipc, shader, *words], stdout=slave, stderr=slave, check=False)
    os.close(slave)
    shown = os.read(master, 1 << 10)
    os.close(master)
    return done.returncode, shown


code, shown = run_on_terminal("-spirv")
assert code == 2 and b"SPIR-V is not text" in shown, (code, shown)
code, shown = run_on_terminal()
assert code == 0 and b"#version" in shown, (code, shown)
piped = subprocess.run([clipc, shader, "-spirv"], stdout=subprocess.PIPE, check=True).stdout
assert piped.startswith(b"\x03\x02\x23\x07"), piped[:9]
