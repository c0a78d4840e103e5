#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Measures what it costs to compile permutations in parts, and says what a thousand nodes take by these numbers. Prints the block of
docs/many-machines.md.

usage: shards.py CLIPC [--write]     --write puts the block into the page

Instructions are counted by Valgrind, so they are the same on a busy machine. A second is the processor time of one run divided by
its instructions, times those counted. The shader has 60 lines, and every permutation has a different text.
"""

import json
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/many-machines.md"
BLOCK = re.compile(r"(<!-- numbers: shards -->\n)(.*?)(<!-- end of numbers -->)", flags=re.DOTALL)
PART = 100  # permutations of a part
MACROS = "ABCDE"  # each has ten values


def write_shader(folder):
    text = (ROOT / "tools/checks/instructions/vertex.hlsl").read_text()
    end = text.rindex("return output;")
    sum_of_all = " + ".join(f"{name} * {10.0**-i}" for i, name in enumerate(MACROS))
    (folder / "shader.hlsl").write_text(f"{text[:end]}output.fog += {sum_of_all};\n{text[end:]}")
    for macros in range(2, len(MACROS) + 1):
        defines = {name: list(range(10)) if i < macros else 0 for i, name in enumerate(MACROS)}
        shaders = [{"source": "shader.hlsl", "profile": "vs_5_0", "defines": defines}]
        manifest = {"version": 1, "shaders": shaders}
        (folder / f"{10**macros}.json").write_text(json.dumps(manifest))


def instructions(clipc, folder, *arguments):
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", clipc, *arguments]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True)
    return int(re.search(r"Collected\s*:\s*(\d+)", done.stderr)[1])


def seconds(clipc, folder, *arguments):
    def spent():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    before = spent()
    subprocess.run([clipc, *arguments], cwd=folder, check=True)
    return spent() - before


def measure(clipc, folder):
    """Returns the instructions of a run of PART permutations, of a part as large of each larger batch, and of the merge of 1,000
    and 10,000 permutations; and the seconds of an instruction."""
    (folder / "out").mkdir()
    alone = instructions(clipc, folder, f"--batch={PART}.json", "-o", "out")
    parts, merges = {}, {}
    for whole in (1_000, 10_000, 100_000):
        shard = f"--shard=1/{whole // PART}"
        parts[whole] = instructions(clipc, folder, f"--batch={whole}.json", shard, "-o", "out")
    for whole in (1_000, 10_000):
        out = folder / f"parts{whole}"
        out.mkdir()
        for part in range(1, 11):
            subprocess.run(
                [clipc, f"--batch={whole}.json", f"--shard={part}/10", "-o", out],
                cwd=folder,
                check=True,
            )
        indexes = sorted(str(path) for path in out.glob("index.*-of-10.json"))
        merges[whole] = instructions(clipc, folder, "--shard=merge", *indexes)
    runs = [seconds(clipc, folder, f"--batch={PART}.json", "-o", "out") for _ in range(21)]
    return alone, parts, merges, sorted(runs)[10] / alone


def table(alone, parts, merges, second):
    merge = (merges[10_000] - merges[1_000]) / 9_000
    names = (parts[100_000] - parts[1_000]) / 99_000
    part, merged = parts[100_000] * second, merge * 100_000 * second
    single = alone / PART * 100_000 * second
    rows = [
        ("100 permutations as a part of 1,000, to a run of 100", f"{parts[1_000] / alone:.2f}"),
        ("as a part of 10,000", f"{parts[10_000] / alone:.2f}"),
        ("as a part of 100,000", f"{parts[100_000] / alone:.2f}"),
        ("instructions for the name of a permutation of another part", f"{names:,.0f}"),
        ("instructions of the merge, a permutation", f"{merge:,.0f}"),
        ("100,000 permutations on one processor", f"{single:.1f} s"),
        ("each of 1,000 parts of them", f"{part:.2f} s"),
        ("their merge", f"{merged:.1f} s"),
        ("1,000 nodes in all, to one processor", f"1/{single / (part + merged):.0f}"),
    ]
    return "".join(
        [
            "| what | measured |\n",
            "|---|---|\n",
            *(f"| {what} | {value} |\n" for what, value in rows),
        ]
    )


def main():
    clipc = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        write_shader(folder)
        made = table(*measure(clipc, folder))
    if "--write" in sys.argv:
        PAGE.write_text(BLOCK.sub(lambda found: found[1] + made + found[3], PAGE.read_text()))
    print(made, end="")


if __name__ == "__main__":
    main()
