# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The shader that clipc writes of the HLSL beside a listing, and what is drawn of it."""

import json
import re
import subprocess

from listings.text import NotRun

INPUT = re.compile(
    r"^(?:layout\(location = (\d+)\) )((?:\w+ )*?)in (\w+) (\w+);\s*// \S+ : (\w+?)(\d+)$", re.M
)
OUTPUT = re.compile(r"^layout\(location = (\d+)\) out (\w+) (\w+);.*$", re.M)
DEPTH = re.compile(r"^layout\(depth_\w+\) out float gl_FragDepth;.*$", re.M)
SAMPLER = re.compile(r"uniform ([iu]?sampler\w+) (\w+)(?:\[\d+\])?;")


def size_of(type_name):
    """The number of components of a GLSL scalar or vector."""
    size = re.search(r"\d$", type_name)
    return int(size[0]) if size else 1


def drawn(type_name, value):
    """The color that shows the value. Integers beyond 2^24 would be near each other as floats."""
    if type_name[0] in "iu":
        value = f"({value} & {type_name}(0xffff))"
    return f"vec4({value}{', 0' * (4 - size_of(type_name))})"


class Written:
    def __init__(self, clipc, hlsl, entry, profile, options, folder):
        reflection = folder / "reflection.json"
        command = [clipc, hlsl, "-T", profile, "-E", entry, "-w", "-o", "-", *options]
        command.append(f"--reflect={reflection}")
        done = subprocess.run(command, capture_output=True, text=True, timeout=60)
        if done.returncode:
            raise NotRun("clipc: " + done.stderr.split("\n")[0])
        self.glsl = done.stdout
        self.reflection = json.loads(reflection.read_text())
        # By semantic and index: location, interpolation, type and name.
        self.inputs = {(row[4].lower(), int(row[5])): row[:4] for row in INPUT.findall(self.glsl)}
        self.outputs = {f"target {row[0]}": row[1:] for row in OUTPUT.findall(self.glsl)}
        self.outputs["depth"] = ("float", "written_depth")
        self.outputs["coverage"] = ("int", "written_mask[0]")
        self.kinds = {name: kind for kind, name in SAMPLER.findall(self.glsl)}

    def textures(self):
        """Pairs of reflected resources and texture registers, with GLSL's type and name."""
        for resource in self.reflection["resources"]:
            texture = resource.get("texture")
            kind = self.kinds.get(resource["glsl"])
            if not texture or not kind:
                continue
            count = re.search(r"\[(\d+)\]$", texture["type"])
            for i in range(int(count[1]) if count else 1):
                name = resource["glsl"] + (f"[{i}]" if count else "")
                yield resource, int(texture["register"][1:]) + i, kind, name

    def sampler_declarations(self):
        return re.findall(r"uniform [iu]?sampler\w+ \w+(?:\[\d+\])?;", self.glsl)

    def input_declarations(self):
        return [
            f"layout(location = {location}) {words}in {kind} {name};"
            for location, words, kind, name in self.inputs.values()
        ]

    def drawing(self, output):
        """The shader with this output alone, as a color."""
        kind, name = self.outputs[output]
        glsl = OUTPUT.sub(lambda out: f"{out[2]} {out[3]};", self.glsl)
        glsl = DEPTH.sub("", glsl)
        glsl = re.sub(r"\bgl_FragDepth\b", "written_depth", glsl)
        glsl = re.sub(r"\bgl_SampleMask\b", "written_mask", glsl)
        glsl = glsl.replace("void main() {", "void main_of_shader() {")
        head, body = glsl.split("\n", 1)
        declared = "float written_depth; int written_mask[1]; layout(location = 0) out vec4 drawn;"
        return (
            f"{head}\n{extensions_first(body, declared)}\n"
            f"void main() {{ main_of_shader(); drawn = {drawn(kind, name)}; }}\n"
        )

    def vertex_shader(self, change):
        """Passes the inputs on that the fragment shader declares; location 0 is the position.

        `change` is what becomes of an input that is not an integer.
        """
        text = ["#version 450", "layout(location = 0) in vec4 position;"]
        body = ["gl_Position = position;"]
        for location, words, kind, name in self.inputs.values():
            text.append(f"layout(location = {int(location) + 1}) in {kind} given_{name};")
            text.append(f"layout(location = {location}) {words}out {kind} {name};")
            value = f"given_{name}"
            body.append(f"{name} = {value if kind[0] in 'iu' else change.format(value)};")
        return "\n".join([*text, "void main() {", *body, "}"]) + "\n"


def extensions_first(body, declared):
    """The declarations after the lines of `#extension`, which come first in GLSL."""
    lines = body.split("\n")
    count = max((i + 1 for i, line in enumerate(lines) if line.startswith("#extension")), default=0)
    return "\n".join([*lines[:count], declared, *lines[count:]])
