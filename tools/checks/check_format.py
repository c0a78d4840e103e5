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
SUFFIXES = (".c", ".cpp", ".h")
EXCLUDED = {"testdata", "tools/fuzz/corpus", "build", ".git"}
RAW_STRING = re.compile(r'R"(\w*)\(.*?\)\1"', re.S)


def files_of_the_repository():
    for folder, folders, files in os.walk(ROOT):
        at = pathlib.Path(folder)
        folders[:] = sorted(name for name in folders if (at / name).relative_to(ROOT).as_posix() not in EXCLUDED)
        yield from (at / name for name in sorted(files) if name.endswith(SUFFIXES))


def long_lines(text):
    """The numbers of the lines over the limit that do not lie in a raw string."""
    lines_of_raw_strings = set()
    for match in RAW_STRING.finditer(text):
        first = text.count("\n", 0, match.start()) + 1
        lines_of_raw_strings.update(range(first, first + match[0].count("\n") + 1))
    for number, line in enumerate(text.splitlines(), 1):
        if len(line) > COLUMNS and number not in lines_of_raw_strings:
            yield number


def formatted(path):
    return subprocess.run([CLANG_FORMAT, path], cwd=ROOT, capture_output=True, text=True, check=True).stdout


def check(path, write, has_clang_format):
    """The problems of one file, as text."""
    name, text = path.relative_to(ROOT), path.read_text()
    wanted = formatted(path) if has_clang_format else text
    if wanted != text and write:
        path.write_text(wanted)
        text = wanted
    found = [f"{name}:{number}: the line is over {COLUMNS} columns" for number in long_lines(text)]
    for number, (line, other) in enumerate(zip(text.splitlines(), wanted.splitlines()), 1):
        if line != other:
            return found + [f"{name}:{number}: {CLANG_FORMAT} writes this differently; run tools/checks/check_format.py --write"]
    if text != wanted:
        found.append(f"{name}: {CLANG_FORMAT} writes the end of the file differently")
    return found


def main():
    write = "--write" in sys.argv
    named = [pathlib.Path(argument).resolve() for argument in sys.argv[1:] if not argument.startswith("-")]
    has_clang_format = shutil.which(CLANG_FORMAT) is not None
    if not has_clang_format:
        print(f"{CLANG_FORMAT} is not installed: only the length of the lines is checked")
    files = named or list(files_of_the_repository())
    with concurrent.futures.ThreadPoolExecutor() as pool:
        problems = sum(pool.map(lambda path: check(path, write, has_clang_format), files), [])
    if not has_clang_format and os.environ.get("CI") == "true":
        problems.append(f"{CLANG_FORMAT} is not installed, and CI=true")
    print("\n".join(problems) or f"{len(files)} files in the house's format")
    return bool(problems)


if __name__ == "__main__":
    sys.exit(main())
