#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails where a source has over 500 lines or a header over 250, which hides a second idea, or one of the last commits has a subject
of over 72 letters or without its room. The columns of a line: check_format.py.
"""

import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINES = {".h": 250, ".hpp": 250, ".cpp": 500, ".c": 500, ".py": 500, ".js": 500, ".mjs": 500}
SUBJECT = 72
COMMITS = 5


def sources():
    for file in ROOT.rglob("*"):
        parts = file.relative_to(ROOT).parts
        if parts[0] not in ("build", ".git", "testdata") and "node_modules" not in parts:
            if file.suffix in LINES and file.is_file():
                yield "/".join(parts), file


def subjects():
    """The subjects of the last commits; none where there is no history, as in an archive."""
    log = ["git", "-C", ROOT, "log", f"-{COMMITS}", "--no-merges", "--format=%s"]
    if not (ROOT / ".git").exists():
        return []
    return subprocess.run(log, capture_output=True, text=True, check=True).stdout.splitlines()


def main():
    problems = []
    for name, file in sorted(sources()):
        count = file.read_text().count("\n")
        if count > LINES[file.suffix]:
            problems.append(f"{name}: {count} lines, at most {LINES[file.suffix]}")
    for subject in subjects():
        if len(subject) > SUBJECT:
            problems.append(f"{subject}: {len(subject)} letters, at most {SUBJECT}")
        elif not re.match(r"[\w./-]+: [^A-Z]", subject):
            problems.append(f"{subject}: not `room: what it does`")
    print("\n".join(problems) or "every file and every subject is short enough")
    return bool(problems)


if __name__ == "__main__":
    sys.exit(main())
