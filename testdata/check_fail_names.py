# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails when a test's name and its RUN lines disagree: a name starts with `fail_` exactly when the compile fails.

lit makes sure that `not %clipc` fails and that a bare `%clipc` succeeds; this script makes sure that the name says so:
the first RUN line of a fail_ file starts with `not`, and no RUN line of another file does. A `split-file` RUN line is not a compile.
"""

import pathlib
import re
import sys

SUFFIXES = {".hlsl", ".test"}
RUN = re.compile(r"RUN:\s*(.*)")


def commands(text):
    """The test's commands, with lines that end in a backslash joined."""
    joined = ""
    for line in text.splitlines():
        if match := RUN.search(line):
            joined += match[1].rstrip()
            if joined.endswith("\\"):
                joined = joined[:-1] + " "
            else:
                yield from re.split(r"\s*&&\s*|\s*;\s*", joined)
                joined = ""


def problem(name, text):
    """What is wrong with the test, or None."""
    compiles = [command for command in commands(text) if "%clipc" in command]
    fails = [
        command
        for command in compiles
        if re.match(r"(.*\|\s*)?(env\s+(\S+=\S+\s+)*)?not\s", command)
    ]
    if name.startswith("fail_"):
        if not compiles:
            return "has no RUN line with %clipc"
        if compiles[0] not in fails:
            return "is called fail_, but its first compile is not run under `not`"
    elif fails:
        return f"runs `{fails[0]}`, but its name does not start with fail_"
    return None


def main():
    root = pathlib.Path(sys.argv[1])
    problems = 0
    for path in sorted(root.rglob("*")):
        if path.suffix not in SUFFIXES or "inputs" in path.parts:
            continue
        if found := problem(path.name, path.read_text(errors="replace")):
            print(f"{path}: {found}")
            problems += 1
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
