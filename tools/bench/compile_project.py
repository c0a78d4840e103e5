#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles every shader of a project in one batch, of every stage.

usage: compile_project.py CLIPC LIST OUT [OPTION]...

LIST has a line per entry point, separated by tabs: path, entry, profile, include folders (a;b), defines (A=1;B). Writes the manifest
OUT/shaders.json and the batch's files to OUT/out. The options are clipc's for all shaders, such as --target=vulkan and --validate. Prints how
many entries compile of each stage, and of the others how many for each cause. Exit 1 if one fails, 2 after a crash.
"""

import collections
import json
import pathlib
import subprocess
import sys

SECONDS = 600


def shader(line, number):
    path, entry, profile, folders, defines = (*line.split("\t"), "", "")[:5]
    pairs = (define.partition("=") for define in defines.split(";") if define)
    return {
        "source": path,
        "name": f"{pathlib.Path(path).stem}.{entry}.{number}",
        "entry": entry,
        "profile": profile,
        "options": [word for folder in folders.split(";") if folder for word in ("-I", folder)],
        "defines": {name: value or "1" for name, _, value in pairs},
    }


def main(arguments):
    clipc, entries, out, *options = arguments
    lines = pathlib.Path(entries).read_text(encoding="utf-8").splitlines()
    folder = pathlib.Path(out)
    (folder / "out").mkdir(parents=True, exist_ok=True)
    manifest = folder / "shaders.json"
    shaders = [shader(line, number) for number, line in enumerate(lines)]
    manifest.write_text(json.dumps({"version": 1, "shaders": shaders}, indent=1), encoding="utf-8")
    command = [clipc, f"--batch={manifest}", "-o", folder / "out", "-k", "-w", *options]
    code = subprocess.run(command, capture_output=True, timeout=SECONDS, check=False).returncode
    if code not in (0, 1):
        print(f"clipc ended with {code}")
        return 2
    index = json.loads((folder / "out" / "index.json").read_text(encoding="utf-8"))
    counts, causes = collections.Counter(), collections.Counter()
    for entry in index["shaders"]:
        stage = entry["profile"][:2]
        is_compiled = entry["status"] == "compiled"
        counts[stage, is_compiled] += 1
        if not is_compiled:
            error = (entry.get("errors") or [{}])[0]
            causes[stage, error.get("name", ""), error.get("message", "")[:100]] += 1
    for stage in sorted({stage for stage, _ in counts}):
        print(f"{stage}: {counts[stage, True]} of {counts[stage, True] + counts[stage, False]}")
    for cause, count in causes.most_common():
        print(count, *cause)
    return 1 if causes else 0


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
