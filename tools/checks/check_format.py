#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails where a C or C++ file is not written as clang-format-19 writes it, or a line is too long.

    check_format.py [--write] [FILE...]

Files: every .c, .cpp and .h of the repository, except below testdata/ and the fuzzers' corpora; or those named.
--write formats the files. clang-format does not wrap comments (ReflowComments: false), so this check also refuses every
line over 100 columns, except inside a raw string, where a line break would change the text. Where clang-format-19 is
not installed, only the length is checked and a message says so; under CI=true its absence is an error.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CLANG_FORMAT = "clang-format-19"
COLUMNS = 100
SUFFIXES = (".c", ".cpp", ".h", ".hpp")
EXCLUDED = {"testdata", "tools/fuzz/corpus", "build", ".git"}
RAW_STRING = re.compile(r'R"(\w*)\(.*?\)\1"', re.S)


def files_of_the_repository():
    for folder, folders, files in os.walk(ROOT):
        at = pathlib.Path(folder)
        folders[:] = [
            name for name in folders if (at / name).relative_to(ROOT).as_posix() not in EXCLUDED
        ]
        yield from (at / name for name in files if name.endswith(SUFFIXES))


def long_lines(text):
    """The numbers of the lines over the limit that do not lie in a raw string."""
    lines_of_raw_strings = set()
    for match in RAW_STRING.finditer(text):
        first = text.count("\n", 0, match.start()) + 1
        lines_of_raw_strings.update(range(first, first + match[0].count("\n") + 1))
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > COLUMNS and number not in lines_of_raw_strings:
            yield number


def clang_format(files, write):
    """What clang-format says of the files."""
    how = ["-i"] if write else ["--dry-run", "-Werror"]
    command = [CLANG_FORMAT, *how, *files]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False).stderr


def main():
    write = "--write" in sys.argv
    named = [pathlib.Path(name).resolve() for name in sys.argv[1:] if not name.startswith("-")]
    files = sorted(path.relative_to(ROOT) for path in named or files_of_the_repository())
    problems = ""
    if shutil.which(CLANG_FORMAT):
        with concurrent.futures.ThreadPoolExecutor() as pool:
            shares = [files[i :: os.cpu_count()] for i in range(os.cpu_count())]
            said = pool.map(lambda share: clang_format(share, write), filter(None, shares))
            problems += "".join(said)
    else:
        print(f"{CLANG_FORMAT} is not installed: only the length of the lines is checked")
        if os.environ.get("CI") == "true":
            problems += f"{CLANG_FORMAT} is not installed, and CI=true\n"
    for name in files:
        for number in long_lines((ROOT / name).read_text()):
            problems += f"{name}:{number}: the line is over {COLUMNS} columns\n"
    print(
        problems + "tools/checks/check_format.py --write formats"
        if problems
        else f"{len(files)} files in the house's format"
    )
    return bool(problems)


if __name__ == "__main__":
    sys.exit(main())
