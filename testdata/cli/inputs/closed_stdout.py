# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""closed_stdout.py CODE COMMAND...: runs the command with standard output closed; fails unless it exits with that code."""

import os
import subprocess
import sys

code = subprocess.run(sys.argv[2:], preexec_fn=lambda: os.close(1)).returncode
sys.exit(0 if code == int(sys.argv[1]) else f"exit code {code}, not {sys.argv[1]}")
