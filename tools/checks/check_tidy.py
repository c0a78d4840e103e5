#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs clang-tidy-19, with the repository's .clang-tidy, over the C++ that changed.

    check_tidy.py [--build FOLDER] [--since REVISION] [--limit N] [--all] [FILE...]

What changed: the .cpp files that differ from REVISION, committed or not, and for each changed header one .cpp file that
includes it. REVISION is by default where this branch left origin/main or, if it is there, the commit before HEAD. At
most N files (24) are checked, about ten seconds each on one core; a message counts those left out. --all checks every
file; FILEs are checked instead. FOLDER, build/release by default, has the compile_commands.json of a configured and
built tree; so has the folder study/ in it, where the laboratory is built.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CLANG_TIDY = "clang-tidy-19"
GCC_ONLY = " -fno-gnu-unique"


def git(*arguments):
    done = subprocess.run(["git", "-C", ROOT, *arguments], capture_output=True, text=True, check=False)
    return done.stdout.strip() if done.returncode == 0 else None


def base_revision():
    head, fork = git("rev-parse", "HEAD"), git("merge-base", "HEAD", "origin/main")
    return fork if fork and fork != head else "HEAD~1"


def changed_files(revision):
    """The .h and .cpp files that changed; empty in a clone that does not reach back to the revision."""
    names = git("diff", "--name-only", "--diff-filter=d", revision) or ""
    return [name for name in names.splitlines() if name.endswith((".h", ".cpp")) and not name.startswith("testdata/")]


def includer(header, sources):
    """The first source that includes `header`, its own .cpp before others; or None."""
    own = header.removesuffix(".h") + ".cpp"
    include = re.compile(rf'^#include "{re.escape(header)}"$', re.M)
    for source in sorted(sources, key=lambda name: name != own):
        if include.search((ROOT / source).read_text()):
            return source
    return None


def tidy(source, build):
    command = [CLANG_TIDY, "-p", build, "--quiet", "--extra-arg=-Wno-unknown-warning-option"]
    # A test may take a value that it expects to be there: it fails if it is not.
    if source.endswith("_test.cpp"):
        command.append("--checks=-bugprone-unchecked-optional-access")
    done = subprocess.run([*command, source], cwd=ROOT, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--since")
    parser.add_argument("--limit", type=int, default=24)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("files", nargs="*")
    given = parser.parse_args()
    commands = json.loads((given.build / "compile_commands.json").read_text())
    if (of_study := given.build / "study/compile_commands.json").exists():
        commands += json.loads(of_study.read_text())
    sources = {os.path.relpath(entry["file"], ROOT) for entry in commands}
    changed = given.files or changed_files(given.since or base_revision())
    wanted = [includer(name, sources) if name.endswith(".h") else name for name in changed]
    wanted = [name for name in dict.fromkeys(wanted) if name in sources]
    if given.all:
        wanted = sorted(sources)
    elif not given.files and len(wanted) > given.limit:
        print(f"clang-tidy: {len(wanted) - given.limit} of {len(wanted)} changed files are left out")
        wanted = wanted[:given.limit]
    failed = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for entry in commands:
            entry["command"] = entry["command"].replace(GCC_ONLY, "")
        (pathlib.Path(folder) / "compile_commands.json").write_text(json.dumps(commands))
        for status, output in pool.map(lambda name: tidy(name, folder), wanted):
            if status:
                print(output)
            failed += status != 0
    print(f"clang-tidy: {len(wanted)} files, {failed} with findings")
    return failed != 0


if __name__ == "__main__":
    sys.exit(main())
