#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Shows on a corpus that the HLSL of --target=hlsl means what the HLSL with [clipplanes] does.

usage: compare_rewritten.py CLIPC CLIPC_DRAW LIST [--most N] [-v]

LIST is that of tools/bench/compare_corpus.py. Planes in a cbuffer of their own are written before the first line of each shader, and
`[clipplanes(...)]` before its entry function. Of the shaders that clipc then compiles,

- clipc reads what it wrote, and both GLSL texts, drawn by Mesa with the same random vertices and constants, write the same positions and
  clip distances, bit for bit;
- glslang's HLSL front end reads it, SPIRV-Cross writes GLSL of that, and Mesa draws the same within the rounding of a dot product. A
  shader that this front end does not read without planes either is counted apart;
- lines of the input that the output does not have are counted: those of the attribute and of the function's name.

Needs glslangValidator and spirv-cross.
"""

import argparse
import collections
import difflib
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


def numbers(count, mark):
    if mark:
        return ",".join(f"{random.randint(0, 3)}{mark}" for _ in range(count))
    return ",".join(f"{random.uniform(-2, 2):.6f}" for _ in range(count))


class Scene:
    """Random vertices, by location, and constants, by the name of their block."""

    def __init__(self, seed, buffers):
        self.seed = seed
        self.buffers = {}  # by the name in the HLSL and by that in the GLSL
        for buffer in buffers:
            for name in (buffer["name"], buffer.get("glsl", {}).get("block")):
                self.buffers[name] = buffer

    def draw(self, draw, path):
        """The position and the distances of each vertex; None if the driver has none."""
        text = path.read_text()
        command = [draw, "capture", path]
        for location, kind, name in INPUT.findall(text):
            random.seed(f"{self.seed} {location}")
            mark = {"u": "u", "i": "i"}.get(kind[0], "")
            count = int(kind[-1]) if kind[-1].isdigit() else 1
            vertices = "/".join(numbers(count, mark) for _ in range(VERTICES))
            command += ["--attribute", f"{name}={vertices}"]
        for _, name in BLOCK.findall(text):
            buffer = self.buffers.get("$Globals" if name == "_Global" else name)
            if not buffer:
                continue
            random.seed(f"{self.seed} {buffer['name']}")
            for offset in range(0, buffer["size"], 16):
                command += ["--block", f"{name}@{offset}={numbers(4, '')}"]
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


def judge(tools, line, folder):
    clipc, draw = tools
    path, entry, profile, includes, defines = (line.rstrip("\n").split("\t") + [""] * 5)[:5]
    options, peer = ["-E", entry, "-T", profile], ["-e", entry]
    source = pathlib.Path(path)
    for flag, several in (("-I", f"{source.parent};{includes}"), ("-D", defines)):
        for value in filter(None, several.split(";")):
            options += [flag, value]
            peer.append(flag + value)
    text = with_planes(source.read_text(errors="replace"), entry)
    if text is None:
        return "not in the file", 0
    before, after, reflection = (folder / n for n in ("before.hlsl", "after.hlsl", "r.json"))
    first, second, third = (folder / n for n in ("1.vert", "2.vert", "3.vert"))
    before.write_text(text)
    if run(clipc, before, *options, "-o", first, f"--reflect={reflection}").returncode:
        return "not compiled with planes", 0
    rewritten = run(clipc, before, *options, "--target=hlsl", "-o", after)
    if rewritten.returncode:
        return "refused: " + rewritten.stderr[:90], 0
    lines = difflib.SequenceMatcher(
        None, text.splitlines(), after.read_text().splitlines(), autojunk=False
    )
    changed = sum(b - a for tag, a, b, _, _ in lines.get_opcodes() if tag in ("replace", "delete"))
    again = run(clipc, after, *options, "-o", second)
    if again.returncode:
        return "not read again: " + again.stderr[:90], changed
    scene = Scene(path + entry, json.loads(reflection.read_text())["cbuffers"])
    drawn, redrawn = scene.draw(draw, first), scene.draw(draw, second)
    if not drawn or not redrawn:
        return "not drawn", changed
    one, other = in_common(drawn, redrawn)
    if one != other:
        return "different", changed
    spirv = folder / "peer.spv"
    if run(
        "glslangValidator", "-D", "-V", "--amb", "-S", "vert", *peer, after, "-o", spirv
    ).returncode:
        before.write_text(text.replace(ATTRIBUTE, ""))
        plain = run(
            "glslangValidator", "-D", "-V", "--amb", "-S", "vert", *peer, before, "-o", spirv
        )
        verdict = "same; the peer reads neither" if plain.returncode else "refused by the peer"
        return verdict, changed
    crossing = run("spirv-cross", spirv, "--version", "450")
    if crossing.returncode:  # a buffer that the peer packs as GLSL cannot say
        return "same; SPIRV-Cross writes no GLSL", changed
    third.write_text(crossing.stdout)
    if f"gl_ClipDistance[{PLANES}]" not in third.read_text():
        return "lost by the peer", changed
    crossed = scene.draw(draw, third)
    if not crossed:
        return "same; the peer's is not drawn", changed
    return (
        "same, and at the peer" if is_near(drawn, crossed) else "same; the peer differs"
    ), changed


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("clipc")
    parser.add_argument("draw")
    parser.add_argument("list")
    parser.add_argument("--most", type=int, default=500, help="judged shaders that are enough")
    parser.add_argument("-v", action="store_true", help="list what is not the same")
    arguments = parser.parse_args()
    verdicts, changes, judged = collections.Counter(), collections.Counter(), 0
    with tempfile.TemporaryDirectory() as name, open(arguments.list) as lines:
        for line in lines:
            if judged == arguments.most:
                break
            tools = (arguments.clipc, arguments.draw)
            verdict, changed = judge(tools, line, pathlib.Path(name))
            verdicts[verdict.split(":")[0]] += 1
            if verdict.startswith(("not in", "not compiled")):
                continue
            judged += 1
            changes[changed] += 1
            if arguments.v and verdict != "same, and at the peer":
                print(verdict, *line.split("\t")[:2], flush=True)
    for verdict, count in verdicts.most_common():
        print(f"{count:5} {verdict}")
    print("lines of the input that change:", dict(sorted(changes.items())))
    wrong = ("refused", "not read", "different", "lost")
    return 1 if any(verdict.startswith(wrong) for verdict in verdicts) else 0


if __name__ == "__main__":
    sys.exit(main())
