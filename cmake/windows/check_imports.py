#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails when a program or library needs a DLL that not every Windows has.

usage: check_imports.py OBJDUMP FILE...
"""

import re
import subprocess
import sys

# The DLLs of Windows itself since Windows 7; the Universal C Runtime since Windows 10.
SYSTEM = re.compile(
    r"(kernel32|advapi32|shell32|ole32|user32|msvcrt|ntdll|psapi|version|ucrtbase|api-ms-win-[\w-]+)\.dll",
    re.IGNORECASE,
)


def main():
    objdump, *files = sys.argv[1:]
    problems = 0
    for file in files:
        text = subprocess.run(
            [objdump, "-p", file], capture_output=True, text=True, check=True
        ).stdout
        names = re.findall(r"DLL Name: (\S+)", text)
        foreign = [name for name in names if not SYSTEM.fullmatch(name)]
        print(f"{file}: {', '.join(names)}")
        if foreign or not names:
            print(f"{file} needs {', '.join(foreign) or 'nothing, which cannot be'}")
            problems += 1
    return problems != 0


if __name__ == "__main__":
    sys.exit(main())
