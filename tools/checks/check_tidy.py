#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs clang-tidy-19, with the repository's .clang-tidy, over the lines of C++ that changed.

    check_tidy.py [--build FOLDER] [--since REVISION] [--limit N] [--all]

What changed: the lines that differ from REVISION, committed or not, in files that a build compiles and in headers
beside such files. REVISION is by default where this branch left origin/main or, if it is there, the commit before
HEAD. At most N files (24) are checked, about ten seconds each on one core; a message counts those left out. --all
checks every line of every file that is compiled. FOLDER, build/release by default, has the compile_commands.json of a
configured and built tree; so has the folder study/ in it, where the laboratory is built.
"""

import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
GCC_ONLY = " -fno-gnu-unique"
QUIETLY = [
    "-clang-tidy-binary",
    "clang-tidy-19",
    "-quiet",
    "-extra-arg=-Wno-unknown-warning-option",
]


def git(*arguments):
    command = ["git", "-C", ROOT, *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 else ""


def base_revision():
    head, fork = git("rev-parse", "HEAD"), git("merge-base", "HEAD", "origin/main")
    return fork.strip() if fork and fork != head else "HEAD~1"


def commands_of_files(entries):
    """The entries with those of a unity build's units replaced by one for each file of the unit."""
    for entry in entries:
        entry["command"] = entry["command"].replace(GCC_ONLY, "")
        if not re.search(r"/Unity/unity_\w+\.cxx$", entry["file"]):
            yield entry
            continue
        unit = pathlib.Path(entry["file"]).read_text()
        for file in re.findall(r'^#include "(.*)"$', unit, re.M):
            yield entry | {"file": file, "command": entry["command"].replace(entry["file"], file)}


def compile_commands(build):
    files = [build / "compile_commands.json", build / "study/compile_commands.json"]
    entries = sum((json.loads(file.read_text()) for file in files if file.exists()), [])
    return list({entry["file"]: entry for entry in commands_of_files(entries)}.values())


def changed_files(revision, sources):
    """The files to check; none in a clone that does not reach back to the revision."""
    folders = {os.path.dirname(source) for source in sources}
    for name in git("diff", "--name-only", "--diff-filter=d", revision).splitlines():
        if name in sources or name.endswith(".h") and os.path.dirname(name) in folders:
            yield name


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--since")
    parser.add_argument("--limit", type=int, default=24)
    parser.add_argument("--all", action="store_true")
    given = parser.parse_args()
    commands = compile_commands(given.build)
    if not commands:
        sys.exit(f"clang-tidy: {given.build} has no compile_commands.json")
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "compile_commands.json").write_text(json.dumps(commands))
        if given.all:
            return subprocess.run(
                ["run-clang-tidy-19", "-p", folder, *QUIETLY], check=False
            ).returncode
        revision = given.since or base_revision()
        changed = list(
            changed_files(revision, {os.path.relpath(entry["file"], ROOT) for entry in commands})
        )
        checked = changed[: given.limit]
        if changed != checked:
            print(f"clang-tidy: {len(changed) - len(checked)} of {len(changed)} files are left out")
        print(f"clang-tidy: {len(checked)} files", flush=True)
        if not checked:
            return 0
        difference = git("diff", "-U0", revision, "--", *checked)
        tool = [
            "clang-tidy-diff-19.py",
            "-p1",
            "-path",
            folder,
            "-j",
            str(os.cpu_count()),
            *QUIETLY,
        ]
        return subprocess.run(tool, input=difference, text=True, cwd=ROOT, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
