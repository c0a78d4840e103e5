#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares the output of clipc with shaders of the same meaning that were written by hand: instructions of SPIR-V, after
glslang and spirv-opt -O. clipc's never has more, and declares no input, output or buffer more.

usage: check_instructions.py CLIPC REPOSITORY_ROOT [--bloat]

--bloat adds an unused multiplication to each of clipc's shaders and expects every comparison to fail."""

import pathlib
import re
import subprocess
import sys
import tempfile


def run(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True, **options).stdout


def counted(glsl, folder):
    """Instructions inside functions, and interface variables, of the optimised SPIR-V."""
    source, spirv, small = folder / "x.vert", folder / "x.spv", folder / "y.spv"
    source.write_text(glsl)
    run(
        "glslangValidator",
        "-G",
        "--auto-map-locations",
        "--auto-map-bindings",
        "-o",
        str(spirv),
        str(source),
    )
    run("spirv-opt", "-O", str(spirv), "-o", str(small))
    text = run("spirv-dis", "--no-indent", str(small))
    body = text[text.index("OpFunction ") :]
    instructions = [
        line
        for line in body.splitlines()
        if re.search(r"\bOp\w+", line) and not re.search(r"OpLabel|OpLine|OpNoLine", line)
    ]
    variables = re.findall(r"= OpVariable \S+ (Input|Output|Uniform)\b", text)
    return len(instructions), len(variables)


def main():
    clipc, root = sys.argv[1], pathlib.Path(sys.argv[2])
    bloat = "--bloat" in sys.argv
    problems, lines = [], []
    hands = sorted((root / "study/hand").glob("*.vert"))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for path in hands:
            hand = path.read_text()
            arguments = re.search(r"^// clipc: (.*)$", hand, re.M)[1].split()
            ours = folder / "ours.vert"
            run(clipc, *arguments, "-o", str(ours), cwd=root)
            text = ours.read_text()
            if bloat:
                text = text.replace("gl_Position = ", "gl_Position = 0.5 * ", 1)
            (mine, my_variables), (other, other_variables) = (
                counted(text, folder),
                counted(hand, folder),
            )
            lines.append(
                f"{path.stem:12} {mine:4} instructions, by hand {other:4}; {my_variables:2} variables, by hand {other_variables:2}"
            )
            if mine > other or my_variables > other_variables:
                problems.append(
                    f"{path.stem}: {mine} instructions and {my_variables} variables, by hand {other} and {other_variables}"
                )
    print("\n".join(lines))
    if bloat:
        print(f"{len(problems)} of {len(hands)} bloated shaders were noticed")
        return len(problems) != len(hands)
    print("\n".join(problems))
    return bool(problems) or not hands


sys.exit(main())
