#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds the GLSL beside each shader of examples/gallery, compute and geometry against the GLSL that clipc writes now.

usage: check_gallery.py CLIPC [--write]

A shader's options stand in its line `// clipc OPTIONS`. --write replaces the GLSL: read the difference before you commit it.
"""

import difflib
import pathlib
import subprocess
import sys

EXAMPLES = pathlib.Path(__file__).resolve().parent
# The folders of shaders, and the suffix of the GLSL in each.
FOLDERS = {"gallery": ".vert", "compute": ".comp", "geometry": ".geom"}


def compiled(clipc, shader):
    lines = shader.read_text().splitlines()
    options = next(line.removeprefix("// clipc ") for line in lines if line.startswith("// clipc "))
    command = [clipc, *options.split(), "--validate", "-Werror", shader.name, "-o", "-"]
    return subprocess.run(
        command, cwd=shader.parent, stdout=subprocess.PIPE, check=True, text=True
    ).stdout


def main():
    clipc, write = pathlib.Path(sys.argv[1]).resolve(), "--write" in sys.argv
    shaders = sorted(
        path
        for folder in FOLDERS
        for path in (EXAMPLES / folder).iterdir()
        if path.suffix in {".hlsl", ".fx"}
    )
    differ = []
    for shader in shaders:
        glsl = compiled(clipc, shader)
        beside = shader.with_suffix(FOLDERS[shader.parent.name])
        if write:
            beside.write_text(glsl)
        elif not beside.exists() or beside.read_text() != glsl:
            old = beside.read_text() if beside.exists() else ""
            differ += difflib.unified_diff(
                old.splitlines(), glsl.splitlines(), beside.name, "now", lineterm=""
            )
    print("\n".join(differ) or f"{len(shaders)} shaders")
    return bool(differ) or not shaders


sys.exit(main())
