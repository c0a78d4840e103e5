#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Hashes everything that clipc writes for many shaders, so that a change meant to keep its output can be shown to keep it.

    hash_outputs.py CLIPC --out HASHES [--list LIST] [--tree FOLDER] [--all | --quick] [-j N]
    hash_outputs.py CLIPC --against HASHES ...        prints the shaders and options whose output differs

Shaders: every HLSL file below FOLDER/testdata and FOLDER/examples (FOLDER: this checkout, or another one whose shaders stay
the same while this one's are edited), with the profile, entry and defines of its first RUN line; and those of LIST, which has
a line per shader, separated by tabs: path, entry, profile, include folders (a;b), defines (A=1;B).

Options: each of seven targets; and for a shader whose text has clip planes, or with --all for every one, each lowering in each
plane space, and all variants; with --quick none of these. A line of HASHES has, for one shader under one choice of options, the
hash of what is written (exit code, GLSL, fragment shader, variants, table, reflection) and the hash of the messages.
"""

import argparse
import concurrent.futures
import hashlib
import itertools
import pathlib
import re
import subprocess
import sys
import tempfile

TARGETS = ["essl100", "glsl120", "glsl330", "glsl450", "essl300", "essl310", "vulkan"]
LOWERINGS = ["clip-distance", "level9", "near-plane", "discard", "none"]
SPACES = ["clip", "xyw1", "object"]
KEPT = re.compile(r"(?:^|\s)(-[TE]\s*\S+|-D\s*\S+|-Z\w+|--position-input[= ]\S+|-I\s*\S+)")


def options_of(file):
    """The options of a lit test's first %clipc line that choose what is compiled, or a plain profile."""
    run = next(
        (
            line
            for line in file.read_text(errors="replace").splitlines()
            if "RUN:" in line and "%clipc" in line
        ),
        "",
    )
    kept = " ".join(KEPT.findall(run.split("|")[0]))
    return kept.replace("%S", str(file.parent)).split() or ["-T", "vs_5_0"]


def listed(file):
    """(name, path, options) of every shader of a list."""
    for line in file.read_text().splitlines():
        path, entry, profile, includes, defines = (line.split("\t") + [""] * 4)[:5]
        options = ["-T", profile, "-E", entry]
        for flag, values in (("-I", includes), ("-D", defines)):
            options += itertools.chain(*([flag, value] for value in values.split(";") if value))
        yield f"{path} {entry} {defines}", path, options


def shaders(tree, list_file):
    """(name, path, options) of every shader."""
    for folder in ("testdata", "examples"):
        for file in sorted((tree / folder).rglob("*.hlsl")):
            path = file.relative_to(tree)
            yield str(path), str(path), options_of(file)
    if list_file:
        yield from listed(list_file)


def choices(path, tree, every, quick):
    text = (tree / path).read_text(errors="replace")
    if quick:
        yield []
        return
    for target in TARGETS:
        yield ["--target=" + target]
        if every or "clipplanes" in text:
            for lowering, space in itertools.product(LOWERINGS, SPACES):
                yield ["--target=" + target, "--lower=" + lowering, "--plane-space=" + space]
            yield ["--target=" + target, "--variants"]


def digest(clipc, tree, path, options, chosen):
    with tempfile.TemporaryDirectory() as scratch:
        outputs = [
            "-o",
            f"{scratch}/out.vert",
            f"--table={scratch}/out.json",
            f"--reflect={scratch}/out.reflect.json",
        ]
        done = subprocess.run(
            [clipc, path, *options, *chosen, *outputs], cwd=tree, capture_output=True, timeout=60
        )
        written = hashlib.sha256(f"{done.returncode}\n".encode())
        for file in sorted(pathlib.Path(scratch).iterdir()):
            written.update(file.name.encode() + b"\n" + file.read_bytes())
        messages = hashlib.sha256(done.stderr.replace(scratch.encode(), b"OUT"))
    return f"{written.hexdigest()[:16]}\t{messages.hexdigest()[:16]}"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("clipc", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--against", type=pathlib.Path)
    parser.add_argument("--list", type=pathlib.Path)
    parser.add_argument(
        "--tree", type=pathlib.Path, default=pathlib.Path(__file__).resolve().parents[2]
    )
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("-j", type=int, default=2)
    given = parser.parse_args()
    clipc, tree = given.clipc.resolve(), given.tree.resolve()
    work = [
        (name, path, options, chosen)
        for name, path, options in shaders(tree, given.list)
        for chosen in choices(path, tree, given.all, given.quick)
    ]
    with concurrent.futures.ThreadPoolExecutor(given.j) as pool:
        hashes = list(pool.map(lambda item: digest(clipc, tree, *item[1:]), work, chunksize=16))
    lines = [
        f"{name}\t{' '.join(chosen)}\t{found}" for (name, _, _, chosen), found in zip(work, hashes)
    ]
    if given.out:
        given.out.write_text("\n".join(lines) + "\n")
    if not given.against:
        return 0
    before, after = (
        {tuple(fields[:2]): fields[2:] for fields in (line.split("\t") for line in text)}
        for text in (given.against.read_text().splitlines(), lines)
    )
    differences = 0
    for shader, old in before.items():
        new = after.get(shader, ["missing"] * 2)
        differ = [
            what for what, one, other in zip(("output", "messages"), old, new) if one != other
        ]
        if differ:
            print(" and ".join(differ), "differ:", *shader)
        differences += bool(differ)
    print(f"{len(before)} compared, {differences} different", file=sys.stderr)
    return differences != 0


if __name__ == "__main__":
    sys.exit(main())
