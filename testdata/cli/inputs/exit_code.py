# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""exit_code.py CODE COMMAND...: fails unless the command exits with that code."""

import subprocess
import sys

code = subprocess.run(sys.argv[2:], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode
sys.exit(
    0
    if code == int(sys.argv[1])
    else f"{' '.join(sys.argv[2:])}: exit code {code}, not {sys.argv[1]}"
)
