# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The limits that tools/bench/main.cpp holds, in the words of docs/speed.md; check_numbers.py compares the two."""

import re

# The words of the table in docs/speed.md, and the words that tools/bench/main.cpp reports with a limit.
SPOKEN = [
    ('processor time of a start, to a static "hello world"', "cold, to a static hello world"),
    ("start to exit, to `glslangValidator -D -V`", "cold, to glslangValidator -D -V"),
    (
        "with `--validate`, to `glslangValidator` on the GLSL",
        "cold with --validate, to glslangValidator on the GLSL",
    ),
    (
        "in one process, to glslang (HLSL to SPIR-V, legalised as its programs do) and SPIRV-Cross",
        "in one process, to glslang + SPIRV-Cross",
    ),
    (
        "a pixel shader in one process, to glslang and SPIRV-Cross",
        "a pixel shader in one process, to glslang + SPIRV-Cross",
    ),
    (
        "a compute shader in one process, to glslang and SPIRV-Cross",
        "a compute shader in one process, to glslang + SPIRV-Cross",
    ),
    ("with a pixel shader in HLSL, to without", "with a pixel shader in HLSL, to without"),
    ("`--target=hlsl`, to GLSL of the same shader", "--target=hlsl, to GLSL of the same shader"),
    (
        "an effect of 50 passes, to its 15 different shaders in one process",
        "an effect with 50 passes, to its 15 shaders",
    ),
    ("validation of each in a batch, milliseconds", "validation of one shader in a batch"),
    ("cost a byte at 10 MB, to that at 100 kB", "cost a byte at 10 MB, to that at 100 kB"),
    ("cost a byte at 10 MB, to that at 1 MB", "cost a byte at 10 MB, to that at 1 MB"),
    ("peak memory beyond 8 MiB, bytes for each byte of text", "peak memory beyond 8 MiB"),
]


def read(text):
    """The rows of the table in docs/speed.md, from the text of tools/bench/main.cpp."""

    def limit(what):
        found = re.search(
            rf'Report\("{re.escape(what)}",[^;]*?,\s*"[^"]*",\s*([\d.]+)(?: / (\d+))?\)', text
        )
        return f"{float(found[1]) / float(found[2] or 1):g}"

    return [[said, limit(what)] for said, what in SPOKEN]
