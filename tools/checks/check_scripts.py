#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails where Python or JavaScript is not written as ruff and prettier write it, or ruff or eslint finds a mistake.

    check_scripts.py [--write]

Files: every .py file of the repository, and every .js, .mjs, .ts and .css file in it. --write formats them. The tools
are packages for node, pinned in web/page/package-lock.json; `./test --all` and web/build.sh install them into
build/web/page. Where they are not there, nothing is checked: exit code 77. Their options: ruff.toml, .prettierrc.json and
web/eslint.config.mjs.
"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parents[2]
MODULES = ROOT / "build/web/page/node_modules"
RUFF = ROOT / "tools/checks/ruff.mjs"
ESLINT = [MODULES / "eslint/bin/eslint.js", "--config", ROOT / "web/eslint.config.mjs"]
PRETTIER = [MODULES / "prettier/bin/prettier.cjs", "--log-level=warn"]
SCRIPTS, STYLES = (".js", ".mjs"), (".ts", ".css")


def files_of_the_repository(suffixes):
    for folder, folders, files in os.walk(ROOT):
        skipped = re.compile(r"build(-.*)?|node_modules|\.git")
        folders[:] = [name for name in folders if not skipped.fullmatch(name)]
        for name in files:
            if name.endswith(suffixes):
                yield os.path.relpath(os.path.join(folder, name), ROOT)


def node(command, files, text=None):
    """What a tool of node says of the files; empty if it finds nothing."""
    done = subprocess.run(
        ["node", *command, *sorted(files)],
        cwd=ROOT,
        input=text,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        check=False,
    )
    return done.stdout or (f"{command[0]} fails\n" if done.returncode else "")


def main():
    write = "--write" in sys.argv
    tools = [RUFF, ESLINT[0], PRETTIER[0], MODULES / "@astral-sh/ruff-wasm-nodejs"]
    if not shutil.which("node") or not all(tool.exists() for tool in tools):
        print("node or the packages of web/page are not there; `./test --all` installs them")
        return 77
    work = {
        "options": tomllib.loads((ROOT / "ruff.toml").read_text()),
        "write": write,
        "files": sorted(files_of_the_repository(".py")),
    }
    scripts = list(files_of_the_repository(SCRIPTS))
    styles = list(files_of_the_repository(STYLES))
    found = node([RUFF, MODULES], [], json.dumps(work))
    found += node([*PRETTIER, "--write" if write else "--check"], scripts + styles)
    found += node(ESLINT, scripts)
    count = len(work["files"]) + len(scripts) + len(styles)
    print(found or f"{count} scripts and styles in the house's format")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
