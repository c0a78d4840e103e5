#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds the GLSL beside each shader of examples/gallery, pixel, compute, geometry and tessellation against the GLSL that clipc writes now.

usage: check_gallery.py CLIPC [--write]

The options of each shader of a file stand in a line `// clipc OPTIONS`, -T first. --write replaces the GLSL: read the difference before you commit it.
"""

import difflib
import pathlib
import subprocess
import sys

EXAMPLES = pathlib.Path(__file__).resolve().parent
FOLDERS = ["gallery", "pixel", "compute", "geometry", "tessellation"]
# The suffix of the GLSL, by the stage of the profile.
SUFFIXES = {
    "vs": ".vert",
    "ps": ".frag",
    "cs": ".comp",
    "gs": ".geom",
    "hs": ".tesc",
    "ds": ".tese",
}


def compiled(clipc, shader):
    """The GLSL of each shader of the file, by its suffix."""
    lines = [line.split()[2:] for line in shader.read_text().splitlines() if "// clipc" in line]
    return {
        SUFFIXES[options[1][:2]]: subprocess.run(
            [clipc, *options, "--validate", "-Werror", shader.name, "-o", "-"],
            cwd=shader.parent,
            stdout=subprocess.PIPE,
            check=True,
            text=True,
        ).stdout
        for options in lines
    }


def main():
    clipc, write = pathlib.Path(sys.argv[1]).resolve(), "--write" in sys.argv
    shaders = sorted(
        path
        for folder in FOLDERS
        for path in (EXAMPLES / folder).iterdir()
        if path.suffix in {".hlsl", ".fx"}
    )
    differ = []
    count = 0
    for shader in shaders:
        for suffix, glsl in compiled(clipc, shader).items():
            count += 1
            beside = shader.with_suffix(suffix)
            if write:
                beside.write_text(glsl)
            elif not beside.exists() or beside.read_text() != glsl:
                old = beside.read_text() if beside.exists() else ""
                differ += difflib.unified_diff(
                    old.splitlines(), glsl.splitlines(), beside.name, "now", lineterm=""
                )
    print("\n".join(differ) or f"{count} shaders")
    return bool(differ) or not count


sys.exit(main())
