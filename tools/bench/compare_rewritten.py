#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Shows on many shaders that the HLSL of --target=hlsl means what the HLSL with [clipplanes] does.

usage: compare_rewritten.py CLIPC CLIPC_DRAW LIST [--most N] [-j JOBS] [--plane-space SPACE] [-v]
       compare_rewritten.py CLIPC CLIPC_DRAW --tests FOLDER...

LIST is that of tools/bench/compare_corpus.py. Planes in a cbuffer of their own are written before the first line of each shader, and
`[clipplanes(...)]` before its entry function. With --tests the shaders are those of the folders that have the attribute, with the
options of their first RUN line, and stay as they are. Of the shaders that clipc then compiles,

- clipc leaves the file of LIST, which has no planes, as it is, byte for byte;
- clipc reads what it wrote, and both GLSL texts, drawn by Mesa with the same random vertices and constants, write the same positions and
  clip distances, bit for bit;
- glslang's HLSL front end reads it, SPIRV-Cross writes GLSL of that, and Mesa draws the same within the rounding of a dot product. A
  shader that this front end does not read without planes either is counted apart; so is one whose position it computes otherwise, if
  the distances are those of that position, and one whose constant buffers it lays out otherwise than Direct3D;
- lines of the input that the output does not have are counted: those of the attribute and of the function's name.

Needs glslangValidator and spirv-cross.
"""

import argparse
import collections
import concurrent.futures
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

PLANES = 5
VERTICES = 3
BUFFER = f"cbuffer ClipPassPlanes {{ float4 clip_pass_plane[{PLANES}]; }};\n"
ATTRIBUTE = f"[clipplanes({', '.join(f'clip_pass_plane[{i}]' for i in range(PLANES))})]\n"
INPUT = re.compile(r"layout\(location = (\d+)\) in (\w+) (\w+);")
BLOCK = re.compile(r"layout\(([^)]*)\) uniform (\w+)")
DISTANCES = re.compile(r"gl_ClipDistance\[(\d+)\];")
REFERENCE = ("glslangValidator", "-D", "-V", "-UVULKAN", "--amb", "-S", "vert")


def run(*command):
    try:
        return subprocess.run(
            [str(word) for word in command],
            capture_output=True,
            text=True,
            errors="replace",
            timeout=60,
        )
    except subprocess.TimeoutExpired as late:
        return subprocess.CompletedProcess(late.cmd, 124, "", "too late")


def with_planes(text, entry):
    """The text with planes on the entry's definition; None if it has none that is easy to find."""
    name = re.escape(entry.split("::")[-1])
    header = rf"^[ \t]*(?!return\b)[A-Za-z_][\w<>, \t]*[ \t\n]\s*{name}\s*\("
    for match in re.finditer(header, text, re.M):
        depth, at = 1, match.end()
        while at < len(text) and depth:
            depth += {"(": 1, ")": -1}.get(text[at], 0)
            at += 1
        brace, semicolon = text.find("{", at), text.find(";", at)
        if brace >= 0 and (semicolon < 0 or brace < semicolon):
            return BUFFER + text[: match.start()] + ATTRIBUTE + text[match.start() :]
    return None


def numbers(chance, count, mark):
    if mark:
        return ",".join(f"{chance.randint(0, 3)}{mark}" for _ in range(count))
    return ",".join(f"{chance.uniform(-2, 2):.6f}" for _ in range(count))


class Scene:
    """Random vertices, by location, and constants, by the name of their block."""

    def __init__(self, seed, buffers):
        self.seed, self.cbuffers = seed, buffers
        self.buffers = {}  # by the name in the HLSL, by that in the GLSL and by the binding
        for buffer in buffers:
            glsl = buffer.get("glsl", {})
            for key in (buffer["name"], glsl.get("block"), glsl.get("binding")):
                self.buffers[key] = buffer

    def rows(self, buffer):
        chance = random.Random(f"{self.seed} {buffer['name']}")
        return [(offset, numbers(chance, 4, "")) for offset in range(0, buffer["size"], 16)]

    def has_distances(self, drawn):
        """Whether the distances are those of the positions to the planes of BUFFER."""
        planes = [
            [float(word) for word in row.split(",")]
            for _, row in self.rows({"name": "ClipPassPlanes", "size": 16 * PLANES})
        ]
        positions = [values(row) for row in re.findall(r"gl_Position = (.*)", drawn)]
        distances = [values(row) for row in re.findall(r"gl_ClipDistance = (.*)", drawn)]
        return len(positions) == len(distances) and all(
            len(row) == PLANES
            and all(
                x != x or abs(x - sum(a * b for a, b in zip(position, plane))) <= 4e-6 * scale
                for x, plane in zip(row, planes)
            )
            for position, row in zip(positions, distances)
            for scale in [max([abs(value) for value in position if value == value] + [1]) * 8]
        )

    def draw(self, draw, path):
        """The position and the distances of each vertex; None if the driver has none."""
        text = path.read_text()
        command = [draw, "capture", path]
        for location, kind, name in INPUT.findall(text):
            chance = random.Random(f"{self.seed} {location}")
            mark = {"u": "u", "i": "i"}.get(kind[0], "")
            count = int(kind[-1]) if kind[-1].isdigit() else 1
            vertices = "/".join(numbers(chance, count, mark) for _ in range(VERTICES))
            command += ["--attribute", f"{name}={vertices}"]
        for layout, name in BLOCK.findall(text):
            # SPIRV-Cross renames some, and glslang has `_Global` for push constants too. Any numbers
            # are good for a block that clipc does not have.
            binding = int((re.search(r"binding = (\d+)", layout) or [0, "-1"])[1])
            known = self.buffers.get("$Globals" if name == "_Global" else name)
            buffer = known or self.buffers.get(binding)
            for offset, row in self.rows(buffer or {"name": name, "size": 4096}):
                command += ["--block", f"{name}@{offset}={row}"]
        drawn = run(*command)
        if drawn.returncode or "gl_ClipDistance" not in drawn.stdout:
            return None
        return drawn.stdout


def values(drawn):
    return [float(word) for word in re.findall(r"-?\d+\.?\d*(?:e[-+]?\d+)?|-?nan|-?inf", drawn)]


def in_common(a, b):
    """The lines that both have: a shader that reads no inputs is drawn with one vertex."""
    one, other = a.splitlines(), b.splitlines()
    lines = min(len(one), len(other))
    return "\n".join(one[:lines]), "\n".join(other[:lines])


def is_near(a, b):
    one, other = map(values, in_common(a, b))
    scale = max([abs(value) for value in one if abs(value) < 1e30] + [1])
    return len(one) == len(other) and all(
        x == y or x != x or abs(x - y) <= 4e-6 * scale for x, y in zip(one, other)
    )


def options_of(line):
    """The path, the options of clipc and those of the reference compiler."""
    path, entry, profile, includes, defines = (line.rstrip("\n").split("\t") + [""] * 5)[:5]
    options, reference = ["-E", entry, "-T", profile], ["-e", entry]
    source = pathlib.Path(path)
    for flag, several in (("-I", f"{source.parent};{includes}"), ("-D", defines)):
        for value in filter(None, several.split(";")):
            options += [flag, value]
            reference.append(flag + value)
    return source, entry, options, reference


def lines_of(folders):
    """A line of a list for each shader of the folders that has planes and compiles."""
    for folder in folders:
        for path in sorted(pathlib.Path(folder).rglob("*.hlsl")):
            text = path.read_text(errors="replace")
            if path.name.startswith("fail_") or not re.search(r"\[\s*clipplanes", text, re.I):
                continue
            command = re.search(r"RUN: (.*)|^// clipc (.*)", text, re.M)
            words = command[0].split() if command else []
            given = {
                flag: [b for a, b in zip(words, words[1:]) if a == flag] for flag in ("-T", "-E")
            }
            profile = (given["-T"] or ["vs_5_0"])[0]
            profile = profile if re.fullmatch(r"vs_[56]_\d", profile) else "vs_5_0"
            defines = ";".join(word[2:] for word in words if re.match(r"-D\w", word))
            yield "\t".join([str(path), (given["-E"] or ["main"])[0], profile, "", defines])


def is_laid_out_alike(spirv, buffers):
    """Whether the reference compiler gives the members of constant buffers the offsets of Direct3D, as clipc does."""
    types = json.loads(run("spirv-cross", spirv, "--reflect").stdout).get("types", {}).values()
    offsets = {
        (kind["name"], member["name"]): member.get("offset")
        for kind in types
        for member in kind["members"]
    }
    return all(
        offsets.get((buffer["name"], member["name"]), member["offset"]) == member["offset"]
        for buffer in buffers
        for member in buffer["members"]
    )


def judge_at_reference(draw, scene, drawn, reference, folder, knows_planes):
    """What the reference compiler makes of the rewritten text; `drawn` is what clipc's GLSL draws."""
    after, spirv, third = (folder / name for name in ("after.hlsl", "reference.spv", "3.vert"))
    if run(*REFERENCE, *reference, after, "-o", spirv).returncode:
        plain = run(*REFERENCE, *reference, folder / "plain.hlsl", "-o", spirv)
        return (
            "same; the reference compiler reads neither"
            if plain.returncode
            else "refused by the reference compiler"
        )
    crossing = run("spirv-cross", spirv, "--version", "450")
    if crossing.returncode:  # a buffer that the reference compiler packs as GLSL cannot say
        return "same; SPIRV-Cross writes no GLSL"
    third.write_text(crossing.stdout)
    count = DISTANCES.search((folder / "1.vert").read_text())[1]
    if f"gl_ClipDistance[{count}];" not in crossing.stdout:
        return "lost by the reference compiler"
    crossed = scene.draw(draw, third)
    if not crossed:
        return "same; the reference compiler's is not drawn"
    if is_near(drawn, crossed):
        return "same, and at the reference compiler"
    if not is_laid_out_alike(spirv, scene.cbuffers):
        return "same; the reference compiler lays a buffer out otherwise"
    positions = ["\n".join(re.findall(r"gl_Position = .*", text)) for text in (drawn, crossed)]
    if is_near(*positions) or (knows_planes and not scene.has_distances(crossed)):
        return "same; the reference compiler differs"
    return "same; the reference compiler's position differs"


def may_change(row, text, entry):
    """Whether the row of the text is one that --target=hlsl changes: a part of an attribute, the function's name, or the function's end,
    after which the rest is on a line of its own."""
    name = re.escape(entry.split("::")[-1])
    if re.search(rf"\[shader|^\s*\}}|(?<!\w){name}(?!\w)", row):
        return True
    for match in re.finditer(r"\[\s*clipplanes", text, re.I):
        depth, at = 1, match.end()
        while at < len(text) and depth:
            depth += {"[": 1, "]": -1}.get(text[at], 0)
            at += 1
        if any(part in row for part in text[match.start() : at].splitlines()):
            return True
    return False


def judge(tools, line, is_test, folder):
    clipc, draw, space = tools
    source, entry, options, reference = options_of(line)
    plain = source.read_text(errors="replace")
    text = plain if is_test else with_planes(plain, entry)
    if text is None:
        return "not in the file", 0
    before, after, reflection = (folder / n for n in ("before.hlsl", "after.hlsl", "r.json"))
    first, second = (folder / n for n in ("1.vert", "2.vert"))
    before.write_text(text)
    planes = [*options, f"--plane-space={space}"]
    compiled = run(clipc, before, *planes, "-o", first, f"--reflect={reflection}")
    if compiled.returncode or not DISTANCES.search(first.read_text()):
        return "not compiled with planes", 0
    if not is_test:
        same = run(clipc, source, *options, "--target=hlsl", "-o", after)
        if same.returncode or after.read_bytes() != source.read_bytes():
            return "not left alone without planes", 0
    rewritten = run(clipc, before, *planes, "--target=hlsl", "-o", after)
    if rewritten.returncode:
        return "refused: " + rewritten.stderr[:90], 0
    run(clipc, before, *options, "--target=hlsl", "--lower=none", "-o", folder / "plain.hlsl")
    compared = run("diff", "--minimal", before, after).stdout
    removed = [row[2:] for row in compared.splitlines() if row.startswith("< ")]
    changed = len(removed)
    if not all(may_change(row, text, entry) for row in removed):
        return "another line changes", changed
    again = run(clipc, after, *options, "-o", second)
    if again.returncode:
        return "not read again: " + again.stderr[:90], changed
    scene = Scene(str(source) + entry, json.loads(reflection.read_text())["cbuffers"])
    drawn, redrawn = scene.draw(draw, first), scene.draw(draw, second)
    if not drawn or not redrawn:
        return "not drawn", changed
    one, other = in_common(drawn, redrawn)
    if one != other:
        is_undefined = "[-Wvariable-not-written]" in compiled.stderr
        # clipc does not follow each read of what is not written; its evaluator does.
        if not is_undefined:
            evaluated = run(draw, "compare", before, *planes, "--target", "glsl450", "--direct3d")
            is_undefined = "nothing was compared" in evaluated.stderr
        return "undefined" if is_undefined else "different", changed
    return judge_at_reference(
        draw, scene, drawn, reference, folder, not is_test and space == "clip"
    ), changed


def judge_alone(tools, line, is_test):
    with tempfile.TemporaryDirectory() as name:
        return judge(tools, line, is_test, pathlib.Path(name))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("clipc")
    parser.add_argument("draw")
    parser.add_argument("list", nargs="?")
    parser.add_argument("--tests", nargs="+", default=[], help="folders with shaders")
    parser.add_argument("--most", type=int, default=500, help="judged shaders that are enough")
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--plane-space", default="clip")
    parser.add_argument("-v", action="store_true", help="list what is not the same")
    arguments = parser.parse_args()
    tools = (arguments.clipc, arguments.draw, arguments.plane_space)
    is_test = bool(arguments.tests)
    lines = list(lines_of(arguments.tests))
    if arguments.list:
        lines = pathlib.Path(arguments.list).read_text().splitlines()
    verdicts, changes, judged = collections.Counter(), collections.Counter(), 0
    with concurrent.futures.ThreadPoolExecutor(arguments.j) as pool:
        results = pool.map(lambda line: (line, *judge_alone(tools, line, is_test)), lines)
        for line, verdict, changed in results:
            verdicts[verdict.split(":")[0]] += 1
            if verdict.startswith(("not in", "not compiled")):
                continue
            judged += verdict != "not drawn"
            changes[changed] += 1
            if arguments.v and verdict != "same, and at the reference compiler":
                print(verdict, *line.split("\t")[:2], flush=True)
            if judged == arguments.most:
                pool.shutdown(wait=False, cancel_futures=True)
                break
    for verdict, count in verdicts.most_common():
        print(f"{count:5} {verdict}")
    print("lines of the input that change:", dict(sorted(changes.items())))
    wrong = (
        "refused",
        "not read",
        "not left",
        "another",
        "different",
        "lost",
        "same; the reference compiler differs",
    )
    return 1 if any(verdict.startswith(wrong) for verdict in verdicts) else 0


if __name__ == "__main__":
    sys.exit(main())
