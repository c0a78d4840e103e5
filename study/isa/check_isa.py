#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Counts the machine instructions of clipc's vertex shaders on the AMD processor that RADV_FORCE_FAMILY names: the plane
spaces xyw1 and object take no more of them, and no more time, than clip; nothing takes more than a shader of this folder that was
written by hand, but for a multiplication more, which must be noticed. Shaders with other interfaces are counted too; a loop takes
less time where its bound is read before it.

usage: check_isa.py CLIPC CLIPC-DRAW REPOSITORY_ROOT"""

import pathlib
import re
import subprocess
import sys
import tempfile

LOOP = "testdata/passes/hoist-loop-bounds/uniforms.hlsl"


def main():
    clipc, draw, root = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    shaders = {}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def add(key, source):
            spirv = folder / f"{key.replace('/', '-')}.spv"
            subprocess.run(
                ["glslangValidator", "-V", "-S", "vert", "-o", str(spirv), str(source)],
                check=True,
                capture_output=True,
            )
            shaders[str(spirv)] = key

        for planes in (0, 1, 3, 6):
            for space in ("clip", "xyw1", "object"):
                glsl = folder / "x.vert"
                subprocess.run(
                    [
                        clipc,
                        f"-DPLANES={planes}",
                        f"--plane-space={space}",
                        "--target=vulkan",
                        "study/program/method.hlsl",
                        "-o",
                        str(glsl),
                    ],
                    check=True,
                    cwd=root,
                )
                add(f"{space}-{planes}", glsl)
        hands = sorted(pathlib.Path(__file__).parent.glob("*.vert"))
        for hand in hands:
            arguments = re.search(r"^// clipc: (.*)$", hand.read_text(), re.M)[1].split()
            ours = folder / "ours.vert"
            subprocess.run(
                [clipc, *arguments, "--target=vulkan", "-o", str(ours)], check=True, cwd=root
            )
            add(f"ours-{hand.stem}", ours)
            add(f"hand-{hand.stem}", hand)
            ours.write_text(ours.read_text().replace("gl_Position = ", "gl_Position = 0.7 * ", 1))
            add(f"more-{hand.stem}", ours)
        # Textures, buffers of all kinds, matrices and arrays between stages, push constants.
        interfaces = (
            "testdata/glsl/buffers/arrays_without_size.hlsl",
            "testdata/draw/atomics.hlsl",
            "testdata/check/entry/matrix_signature.hlsl",
            "testdata/glsl/vulkan/vulkan_attributes.hlsl",
            LOOP,
        )
        for name in interfaces:
            glsl = folder / "x.vert"
            subprocess.run(
                [clipc, "-T", "vs_5_1", "-w", "--target=vulkan", name, "-o", str(glsl)],
                check=True,
                cwd=root,
            )
            add(name, glsl)
        text = glsl.read_text()
        reread = text.replace("    int lights = globals.lights;\n", "").replace(
            "i < lights", "i < globals.lights"
        )
        glsl.write_text(reread)
        add("reread", glsl)
        ran = subprocess.run(
            [draw, "machine-code", *shaders], capture_output=True, text=True, check=False
        )
    if ran.returncode:
        print(ran.stderr)
        return ran.returncode
    counts = {}
    for path, instructions, cycles in re.findall(r"^(\S+) (\d+) (\d+)$", ran.stdout, re.M):
        counts[shaders[path]] = int(instructions), int(cycles)
    problems = []
    for planes in (1, 3, 6):
        row = {space: counts[f"{space}-{planes}"] for space in ("clip", "xyw1", "object")}
        print(
            f"{planes} planes: "
            + ", ".join(f"{space} {i} instructions, {c} cycles" for space, (i, c) in row.items())
        )
        for space in ("xyw1", "object"):
            if row[space][0] > row["clip"][0] or row[space][1] > row["clip"][1]:
                problems.append(
                    f"{space} with {planes} planes takes {row[space]}, clip {row['clip']}"
                )
        if not counts[f"clip-{planes}"][0] > counts["clip-0"][0]:
            problems.append("planes cost nothing at all: something was not compiled")
    for hand in (path.stem for path in hands):
        ours, by_hand, more = (counts[f"{who}-{hand}"][0] for who in ("ours", "hand", "more"))
        print(f"{hand}: {ours} instructions, by hand {by_hand}, with a multiplication more {more}")
        if not ours <= by_hand < more:
            problems.append(f"{hand} takes {ours} instructions, by hand {by_hand}, bloated {more}")
    print("\n".join(f"{name}: {counts[name]}" for name in (*interfaces, "reread")))
    if reread == text or not counts[LOOP][1] < counts["reread"][1]:
        problems.append("a loop takes no less time where its bound is read before it")
    print("\n".join(problems))
    return bool(problems)


sys.exit(main())
