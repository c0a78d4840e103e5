#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Counts the instructions of calls of clipc, start and end of the process included, and fails where one differs from
instructions.csv by more than 5 %: what is not counted gets slower without anybody seeing it.

    check_instructions.py CLIPC BUILD           BUILD is `release` or `profiled`, a column of instructions.csv
    check_instructions.py CLIPC BUILD --write   renews the column
    check_instructions.py CLIPC BUILD --starts  prints the constructors that take over 1,000

No constructor of a static object, ours or a library's, may take over 10,000 instructions. Needs valgrind.
"""

import argparse
import csv
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
TABLE = HERE / "instructions.csv"
TOLERANCE = 0.05
MOST_OF_A_CONSTRUCTOR = 10_000
SKIPPED = 77
VERTEX = ["-T", "vs_5_0", "{}/vertex.hlsl", "-o", "{}/out"]
PIXEL = ["-T", "ps_5_0", "{}/pixel.hlsl", "-o", "{}/out"]
CALLS = {
    "--version": ["--version"],
    "a vertex shader of 60 lines": VERTEX,
    "a pixel shader of 60 lines": PIXEL,
    "the vertex shader with --reflect": [*VERTEX, "--reflect={}/out.json"],
    "the pixel shader with --reflect": [*PIXEL, "--reflect={}/out.json"],
    "the vertex shader to SPIR-V": [*VERTEX, "-spirv"],
    "the pixel shader to SPIR-V": [*PIXEL, "-spirv"],
}
# Names of what a compiler makes for the constructors and the destructors of a file's static objects.
CONSTRUCTOR = re.compile(r"_GLOBAL__sub_I_|__static_initialization_and_destruction|__tcf_")


def count(clipc, arguments, scratch):
    """Runs one call. Returns its instructions, and those of each constructor with what it calls."""
    for shader in ("vertex.hlsl", "pixel.hlsl"):
        shutil.copy(HERE / "instructions" / shader, scratch)
    notes = pathlib.Path(scratch, "notes")
    command = [argument.format(scratch) for argument in arguments]
    run = subprocess.run(
        ["valgrind", "--tool=callgrind", f"--callgrind-out-file={notes}", clipc, *command],
        capture_output=True,
        text=True,
    )
    if run.returncode:
        sys.exit(f"{' '.join(command)}: exit code {run.returncode}\n{run.stderr}")
    total = int(re.search(r"Collected\s*:\s*(\d+)", run.stderr)[1])
    listing = subprocess.run(
        ["callgrind_annotate", "--inclusive=yes", "--threshold=100", notes],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    constructors = {}
    for line in listing.splitlines():
        found = re.match(r"\s*([\d,]+)\s*(?:\([^)]*\))?\s+(\S.*)", line)
        if found and CONSTRUCTOR.search(found[2]):
            constructors[found[2]] = int(found[1].replace(",", ""))
    return total, constructors


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("clipc")
    parser.add_argument("build", choices=["release", "profiled"])
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--starts", action="store_true")
    arguments = parser.parse_args()
    if not shutil.which("valgrind"):
        print("no valgrind: nothing was counted")
        return SKIPPED
    rows = {row["call"]: row for row in csv.DictReader(TABLE.open())} if TABLE.exists() else {}
    failed = False
    for call, options in CALLS.items():
        with tempfile.TemporaryDirectory() as scratch:
            total, constructors = count(arguments.clipc, options, scratch)
        row = rows.setdefault(call, {"call": call, "release": 0, "profiled": 0})
        known = int(row[arguments.build] or 0)
        if arguments.write:
            row[arguments.build] = total
        elif not known:
            print(f"{call}: {total} instructions; {TABLE.name} has none to compare with")
        elif abs(total - known) > TOLERANCE * known:
            failed = True
            print(
                f"{call}: {total} instructions, {known} in {TABLE.name}; --write renews it, if that is meant"
            )
        else:
            print(f"{call}: {total} instructions, {total / known:.3f} of those in {TABLE.name}")
        for name, cost in sorted(constructors.items(), key=lambda pair: -pair[1]):
            if arguments.starts and cost > 1_000:
                print(f"    {cost:9} {name}")
            if cost > MOST_OF_A_CONSTRUCTOR:
                failed = True
                print(
                    f"{call}: {cost} instructions in the constructor {name}; at most {MOST_OF_A_CONSTRUCTOR}"
                )
    if arguments.write:
        with TABLE.open("w", newline="") as file:
            writer = csv.DictWriter(file, ["call", "release", "profiled"], lineterminator="\n")
            writer.writeheader()
            writer.writerows(rows.values())
    return failed


if __name__ == "__main__":
    sys.exit(main())
