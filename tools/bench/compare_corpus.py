#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares clipc's GLSL with its reference evaluator on a corpus of shaders that are not part of this repository.

usage: compare_corpus.py CLIPC_DRAW LIST [-j JOBS] [--target glsl450]
       compare_corpus.py --reference CLIPC_REFERENCE_COMPILER LIST [-j JOBS]

LIST has a line per shader, separated by tabs: path, entry, profile, include folders (a;b), defines (A=1;B). Every shader
that clipc accepts runs on random vertices and constants through Mesa's software OpenGL, or Vulkan for that target, and through the
evaluator. With --reference it is what glslang's HLSL front end makes of the shader that runs; its known bugs (docs/reference-compilers.md) are counted:
tools/reference-compiler/run builds that program and runs this.
A shader that differs is tried again with twice the tolerance (tools/draw/compare.h), and listed whatever comes out.
"""

import argparse
import collections
import concurrent.futures
import subprocess
import sys

VERDICTS = {0: "equal", 1: "different"}


def compare(arguments, line):
    path, entry, profile, includes, defines = (line.rstrip("\n").split("\t") + [""] * 5)[:5]
    command = (
        [arguments.program, path]
        if arguments.reference
        else [
            arguments.program,
            "compare",
            path,
            "--target",
            arguments.target,
            "--lower",
            "clip-distance",
            "--direct3d",
        ]
    )
    command += ["-T", profile, "-E", entry]
    for flag, values in (("-I", includes), ("-D", defines)):
        for value in filter(None, values.split(";")):
            command += [flag, value]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=60)
        # A loop counts to a random number, or all random indices lie outside.
        if "step limit" in done.stderr or "nothing was compared" in done.stderr:
            done = subprocess.run(
                command + ["--ints", "0..3"],
                capture_output=True,
                text=True,
                errors="replace",
                timeout=60,
            )
        verdict = VERDICTS.get(done.returncode, "not compared")
        if verdict == "different":
            # A normalised difference of quotients was off by 35 units: both round as they may.
            again = subprocess.run(
                command + ["--ulps", "64"],
                capture_output=True,
                text=True,
                errors="replace",
                timeout=60,
            )
            verdict = "equal within 64 units" if again.returncode == 0 else verdict
    except subprocess.TimeoutExpired:
        return "timeout", path, entry, []
    text = (done.stdout + done.stderr).strip().splitlines()
    if verdict == "not compared" and text and "glslang" in text[0]:
        verdict = "not compiled by the reference compiler"
    return verdict, path, entry, text


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("program")
    parser.add_argument("list")
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--target", default="glsl450")
    parser.add_argument("--reference", action="store_true")
    arguments = parser.parse_args()
    with open(arguments.list, encoding="utf-8") as file:
        lines = file.readlines()
    counts, bugs = collections.Counter(), collections.Counter()
    with concurrent.futures.ThreadPoolExecutor(arguments.j) as pool:
        for done, (verdict, path, entry, text) in enumerate(
            pool.map(lambda line: compare(arguments, line), lines), 1
        ):
            counts[verdict] += 1
            bugs.update(
                line for line in text if line.startswith("known bug of the reference compiler: ")
            )
            if sys.stderr.isatty():
                print(f"\r{done} of {len(lines)}", end="", file=sys.stderr)
            if verdict == "equal":
                continue
            print(f"{verdict}: {path} {entry}")
            for line in (
                text[-6:] if verdict in ("different", "equal within 64 units") else text[:1]
            ):
                print(f"    {line[:200]}")
    for bug, count in sorted(bugs.items()):
        print(f"{count} times {bug}")
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(counts.items())))
    return counts["different"] != 0


sys.exit(main())
