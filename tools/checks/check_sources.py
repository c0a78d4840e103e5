#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails when docs/errata.md names a test that does not exist, or a test of a source document is not named there."""

import pathlib
import re
import sys

TEST = re.compile(r"^TEST(?:_F)?\((\w+), (\w+)\)", re.MULTILINE)


def tests(root):
    """Suite.Test of every GoogleTest in runtime/ and tools/scenes/, and the names of the lit tests in testdata/seeds/."""
    found = set()
    for folder in ("runtime", "tools/scenes"):
        for file in (root / folder).rglob("*_test.cpp"):
            found |= {f"{suite}.{test}" for suite, test in TEST.findall(file.read_text())}
    return found | {file.name for file in (root / "testdata" / "seeds").glob("*.hlsl")}


def main():
    root = pathlib.Path(__file__).resolve().parents[2]
    there = tests(root)
    named = set(re.findall(r"`(\w+\.\w+)`", (root / "docs" / "errata.md").read_text()))
    of_documents = {test for test in there if re.match(r"(fail_)?seed\d{3}", test, re.IGNORECASE)}
    for test in sorted(named - there):
        print(f"docs/errata.md names {test}, which is not a test")
    for test in sorted(of_documents - named):
        print(f"{test} is not in docs/errata.md")
    if not of_documents:
        print("no tests of the source documents at all")
    return bool(named - there or of_documents - named or not of_documents)


if __name__ == "__main__":
    sys.exit(main())
