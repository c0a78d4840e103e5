#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares the machine code of clipc's shaders with that of two reference compilers, on a corpus that is not part of this repository.

usage: compare_machine_code.py CLIPC CLIPC_DRAW LIST [-j JOBS] [--families polaris10,navi21] [--list FILE]

LIST is that of compare_corpus.py: path, entry, profile, include folders (a;b), defines (A=1;B), separated by tabs; the profile says
whether it is a vertex or a pixel shader. The reference compilers are
glslang's HLSL front end, legalised, and SPIRV-Cross's GLSL of that, which glslang compiles again. A shader counts where all three
give SPIR-V that Mesa's driver for these AMD processors takes, without such a processor; of equal SPIR-V of clipc the first counts.
Prints for each processor and reference compiler the instructions in sum, and how many shaders are more than 2 % longer or shorter; --list
writes a line for each: processor, compiler, instructions of clipc and of the reference compiler, path, entry."""

import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import tempfile

REFERENCES = ("glslang", "spirv-cross")
BINDINGS = [
    "--auto-map-bindings",
    "--auto-map-locations",
    "--shift-sampler-binding",
    "100",
    "--shift-texture-binding",
    "200",
    "--shift-ssbo-binding",
    "400",
    "--shift-image-binding",
    "600",
    "--shift-uav-binding",
    "800",
]


def run(*command):
    try:
        return subprocess.run(
            [str(word) for word in command],
            capture_output=True,
            text=True,
            errors="replace",
            timeout=60,
        )
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(command, 1, "", "timeout")


def make(arguments, folder, number, line):
    """Returns the three files of a shader, or none."""
    path, entry, profile, includes, defines = (line.rstrip("\n").split("\t") + [""] * 5)[:5]
    stage = "frag" if profile.startswith("ps") else "vert"
    ours, compiler, text, crossed = (
        folder / f"{number}.{end}" for end in ("clipc.spv", "glslang.spv", stage, "spirv-cross.spv")
    )
    flags = [word for name in filter(None, includes.split(";")) for word in ("-I", name)]
    flags += [f"-D{name}" for name in filter(None, defines.split(";"))]
    if run(
        arguments.clipc,
        "-w",
        "-T",
        profile,
        "-E",
        entry,
        "--target=vulkan",
        *([] if stage == "frag" else ["--lower=none"]),
        *flags,
        path,
        "-o",
        ours,
    ).returncode:
        return None
    flags = [word if word.startswith("-D") else "-I" + word for word in flags if word != "-I"]
    if run(
        "glslangValidator",
        "-D",
        "-V",
        "-S",
        stage,
        "-e",
        entry,
        "--source-entrypoint",
        entry,
        "--hlsl-offsets",
        *BINDINGS,
        *flags,
        path,
        "-o",
        compiler,
    ).returncode:
        return None
    if run(
        "spirv-cross", "--vulkan-semantics", "--version", "450", compiler, "--output", text
    ).returncode:
        return None
    if run("glslangValidator", "-V", text, "-o", crossed).returncode:
        return None
    return ours, compiler, crossed


def count(arguments, family, files):
    """Returns the instructions of each file that the driver takes."""
    environment = dict(os.environ, RADV_FORCE_FAMILY=family, RADV_DEBUG="nonggc")
    counts = {}
    # A driver that a shader makes crash takes the files after it along: those are counted one by one.
    for group in [files] + [[file] for file in files]:
        group = [file for file in group if file not in counts]
        if not group:
            continue
        done = subprocess.run(
            [arguments.draw, "machine-code", *map(str, group)],
            capture_output=True,
            text=True,
            env=environment,
            check=False,
        )
        if done.returncode == 77:
            sys.exit("no Vulkan device counts instructions: " + done.stderr)
        counts.update(
            {
                pathlib.Path(name): int(number)
                for name, number in re.findall(r"^(\S+) (\d+) \d+$", done.stdout, re.M)
            }
        )
    return counts


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("clipc")
    parser.add_argument("draw")
    parser.add_argument("shaders", metavar="LIST")
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--families", default="polaris10,navi21")
    parser.add_argument("--list")
    arguments = parser.parse_args()
    lines = pathlib.Path(arguments.shaders).read_text(encoding="utf-8").splitlines()
    rows = []
    with (
        tempfile.TemporaryDirectory() as name,
        concurrent.futures.ThreadPoolExecutor(arguments.j) as pool,
    ):
        made = list(
            pool.map(lambda item: make(arguments, pathlib.Path(name), *item), enumerate(lines))
        )
        distinct = {}
        for files, line in zip(made, lines):
            if files:
                distinct.setdefault(hashlib.sha256(files[0].read_bytes()).digest(), (files, line))
        triples = list(distinct.values())
        print(
            f"{len(lines)} shaders, {sum(map(bool, made))} that all three compile, {len(triples)} distinct"
        )
        groups = [triples[i : i + 20] for i in range(0, len(triples), 20)]
        for family in arguments.families.split(","):
            counts = {}
            for some in pool.map(
                lambda group, f=family: count(
                    arguments, f, [file for files, _ in group for file in files]
                ),
                groups,
            ):
                counts.update(some)
            counted = [
                (files, line) for files, line in triples if all(file in counts for file in files)
            ]
            for index, compiler in enumerate(REFERENCES, 1):
                pairs = [(counts[files[0]], counts[files[index]]) for files, _ in counted]
                ours, theirs = map(sum, zip(*pairs))
                longer = sum(a > 1.02 * b for a, b in pairs)
                shorter = sum(b > 1.02 * a for a, b in pairs)
                print(
                    f"{family}, {compiler}: {len(pairs)} shaders, {ours} to {theirs} instructions, {ours / theirs:.4f} in sum; "
                    f"{longer} longer, {shorter} shorter by more than 2 %"
                )
                rows += [
                    (family, compiler, *pair, *line.split("\t")[:2])
                    for pair, (_, line) in zip(pairs, counted)
                ]
    if arguments.list:
        pathlib.Path(arguments.list).write_text(
            "".join("\t".join(map(str, row)) + "\n" for row in rows), encoding="utf-8"
        )


main()
