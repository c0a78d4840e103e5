#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes random pairs of shaders, and draws what clipc makes of each in one run against the same two shaders in two runs.

usage: pairs.py CLIPC CLIPC_DRAW [--count 100] [--seed 1] [--keep FOLDER]

The pair is hard to match: the pixel shader reads some of the outputs, in another order, with fewer components and other
interpolation modifiers; constant buffers, uniforms and textures of one name or register are alike in both shaders, or are not; both
shaders are in one file or in two. The same program in two runs is easy to match: all names differ, and both shaders have one
struct. Under GLSL 3.30, 4.50 and ES 3.00 both draw the same image on Mesa. For Vulkan the pair becomes a pipeline of which the
validation layers have nothing to say. Prints a line for each pair that does not, with its
seed; exit 1 then.
"""

import argparse
import pathlib
import random
import re
import subprocess
import sys
import tempfile

MODIFIERS = ["", "", "linear ", "centroid ", "noperspective ", "nointerpolation "]
SEMANTICS = ["TEXCOORD0", "TEXCOORD1", "TEXCOORD5", "COLOR0", "COLOR1", "NORMAL", "FOO", "Bar3"]
DRAWN = ["glsl330", "glsl450", "essl300"]


class Varying:
    """An output that the vertex shader writes, and the part of it that the pixel shader reads."""

    def __init__(self, r, semantic):
        self.semantic = semantic
        self.scalar = r.choice(["float"] * 5 + ["int", "uint"])
        self.count = r.randint(1, 4)
        self.array = r.choice([0, 0, 0, 2]) if semantic.startswith("TEXCOORD5") else 0
        self.is_read = r.random() < 0.6
        self.read = self.count if self.array or r.random() < 0.6 else r.randint(1, self.count)
        self.modifier = r.choice(MODIFIERS) if self.scalar == "float" else "nointerpolation "
        self.other_modifier = r.choice(MODIFIERS) if r.random() < 0.5 else self.modifier
        if self.scalar != "float" and self.other_modifier != "nointerpolation ":
            self.other_modifier = ""  # integers are never interpolated: X4576
        self.name = "v_" + semantic.lower()

    def field(self, modifier, count):
        array = f"[{self.array}]" if self.array else ""
        return f"  {modifier}{self.scalar}{count} {self.name}{array} : {self.semantic};\n"

    def write(self, r, terms):
        value = f"({r.choice(terms)} * {r.randint(1, 3)} + {r.choice(terms)})"
        if self.scalar != "float":
            value = f"(({self.scalar}4)abs({value} * 3))"
        swizzle = ".xyzw"[: self.count + 1]
        if self.array:
            return "".join(
                f"  o.{self.name}[{i}] = {value}{swizzle} + {i};\n" for i in range(self.array)
            )
        # A loop that is removed with an output that nothing reads.
        if r.random() < 0.2:
            return f"  for (int i{self.name} = 0; i{self.name} < 2; i{self.name}++) o.{self.name} = {value}{swizzle} + i{self.name};\n"
        return f"  o.{self.name} = {value}{swizzle};\n"

    def value(self):
        last = "xyzw"[self.read - 1]
        swizzle = "." + ("xyzw"[: self.read] + last * 4)[:4]
        access = f"v.{self.name}[1]" if self.array else f"v.{self.name}"
        return f"(float4)({access}{swizzle}) * 0.25"


class Shared:
    """A buffer, a uniform or a texture that both shaders declare: alike, or under one name or register only."""

    def __init__(self, r, number, is_one_file):
        self.kind = r.choice(["buffer", "buffer", "texture", "uniform"])
        self.name = f"{self.kind}{number}"
        self.number = number
        self.is_alike = is_one_file or r.random() < 0.5
        self.differs = r.choice(["members", "register"]) if self.kind == "buffer" else "register"
        self.members = r.choice(
            ["float4 {}a; float2 {}b;", "float {}b; float4 {}a;", "float4x4 {}m; float4 {}a;"]
        )
        self.in_pixel = r.random() < 0.8

    def declare(self, is_pixel, easy):
        other = is_pixel and not self.is_alike
        name = self.name + ("_2" if other and easy else "")
        register = self.number + (8 if other and (easy or self.differs == "register") else 0)
        if self.kind == "texture":
            return f"Texture2D {name} : register(t{register});\n"
        if self.kind == "uniform":
            return (
                f"float4 {self.name};\n"
                if not other
                else f"float4 {self.name}, {self.name}_more;\n"
            )
        members = self.members.format(*[self.name] * 2)
        if other and self.differs == "members":
            members = f"float3 {self.name}c; float4 {self.name}a;"
        return f"cbuffer {name} : register(b{register}) {{ {members} }}\n"

    def terms(self, is_pixel, easy):
        other = is_pixel and not self.is_alike
        if self.kind == "texture":
            name = self.name + ("_2" if other and easy else "")
            return [f"{name}.SampleLevel(smp, x.xy, 0)"]
        if self.kind == "uniform":
            return [f"{self.name}_more" if other else self.name]
        return [f"{self.name}a"]


class Pair:
    def __init__(self, seed):
        self.r = r = random.Random(seed)
        self.is_one_file = r.random() < 0.3
        self.varyings = [Varying(r, s) for s in r.sample(SEMANTICS, r.randint(1, 7))]
        if not any(v.is_read and v.scalar == "float" for v in self.varyings):
            self.varyings[0].is_read, self.varyings[0].scalar = True, "float"
            self.varyings[0].modifier = self.varyings[0].other_modifier = ""
        self.shared = [Shared(r, i, self.is_one_file) for i in range(r.randint(0, 4))]
        self.reads_position = r.random() < 0.3
        self.discards = r.random() < 0.2
        self.order = r.sample(self.varyings, len(self.varyings))
        self.body = r.randrange(1 << 30)

    def globals_differ(self):
        return any(s.kind == "uniform" and not s.is_alike for s in self.shared)

    def resources(self, is_pixel, easy):
        """The declarations of a stage; $Globals of the easy pixel shader has the name that it gets beside another."""
        text = "SamplerState smp : register(s0);\n"
        uniforms = ""
        for one in self.shared:
            if is_pixel and not one.in_pixel and not self.is_one_file:
                continue
            if one.kind == "uniform":
                uniforms += one.declare(is_pixel, easy)
            else:
                text += one.declare(is_pixel, easy)
        if uniforms and easy and is_pixel and not self.has_same_globals():
            return text + "cbuffer Globals_2 : register(b13) {\n" + uniforms + "}\n"
        return text + uniforms

    def has_same_globals(self):
        uniforms = [s for s in self.shared if s.kind == "uniform"]
        return all(s.is_alike and (s.in_pixel or self.is_one_file) for s in uniforms)

    def vertex(self, easy):
        r = random.Random(self.body)
        terms = ["x", "n.xyzz", "p"] + [t for s in self.shared for t in s.terms(False, easy)]
        fields = "".join(
            v.field(v.modifier if easy else v.other_modifier, v.count) for v in self.varyings
        )
        writes = "".join(v.write(r, terms) for v in self.varyings)
        return f"""struct V {{
  float4 position : SV_Position;
{fields}}};
V vs(float4 p : POSITION, float4 x : TEXCOORD0, float3 n : NORMAL) {{
  V o;
  o.position = p;
{writes}  return o;
}}
"""

    def pixel(self, easy):
        r = random.Random(self.body + 1)
        read = [v for v in self.order if v.is_read]
        if easy:
            struct = "V"
            fields = ""
        else:
            struct = "P"
            fields = "".join(v.field(v.modifier, v.read) for v in read)
            position = "  float4 position : SV_Position;\n" if self.reads_position else ""
            fields = f"struct P {{\n{fields}{position}}};\n"
        terms = [v.value() for v in read]
        for one in self.shared:
            if one.in_pixel:
                terms += [f"{t} * {r.randint(1, 3)}" for t in one.terms(True, easy)]
        if self.reads_position:
            terms.append("float4(v.position.xy, v.position.zw) * 0.01")
        x = next(v for v in read if v.scalar == "float").value()
        discard = "  if (x.x > 3) discard;\n" if self.discards else ""
        return f"""{fields}float4 ps({struct} v) : SV_Target {{
  float4 x = {x};
{discard}  return {" + ".join(terms)} + 0.125;
}}
"""

    def write(self, folder, is_es=False):
        """The files of the hard pair, and of the easy one. OpenGL ES interpolates nothing without perspective, and
        its SV_Position needs a uniform of the application."""
        self.reads_position = self.reads_position and not is_es
        for varying in self.varyings if is_es else []:
            varying.modifier = varying.modifier.replace("noperspective ", "")
            varying.other_modifier = varying.other_modifier.replace("noperspective ", "")
        hard_vertex = self.resources(False, False) + self.vertex(False)
        if self.is_one_file:
            (folder / "v.hlsl").write_text(hard_vertex + self.pixel(False))
        else:
            (folder / "v.hlsl").write_text(hard_vertex)
            (folder / "p.hlsl").write_text(self.resources(True, False) + self.pixel(False))
        vertex = self.vertex(True)
        (folder / "ev.hlsl").write_text(self.resources(False, True) + vertex)
        struct = vertex[: vertex.index("V vs(")]
        (folder / "ep.hlsl").write_text(self.resources(True, True) + struct + self.pixel(True))


def run(folder, *command):
    done = subprocess.run(
        [str(word) for word in command],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
        timeout=120,
        check=False,
    )
    return done.returncode, (done.stdout + done.stderr).strip()


def same_names(folder):
    """Gives the easy pair the names of the hard one, where outputs that nothing reads took the vertex shader's away."""
    text = {name: (folder / name).read_text() for name in ("h.vert", "h.frag", "e.vert", "e.frag")}
    for name in re.findall(r"uniform (?:highp )?(?:sampler2D )?(\w+)_2\b", text["e.frag"]):
        if not re.search(rf"\b{name}_2\b", text["h.frag"]):
            text["e.vert"] = re.sub(rf"\b{name}\b", f"{name}_dropped", text["e.vert"])
            text["e.frag"] = re.sub(rf"\b{name}_2\b", name, text["e.frag"])
    for name in ("e.vert", "e.frag"):
        (folder / name).write_text(text[name])


class Failure(Exception):
    pass


def must(folder, *command):
    code, text = run(folder, *command)
    if code:
        raise Failure(f"{' '.join(str(word) for word in command)}: {text[:600]}")
    return text


def judge(clipc, draw, seed, folder):
    pair = Pair(seed)
    other = [] if pair.is_one_file else ["--pixel-shader=p.hlsl"]
    hard = [clipc, "v.hlsl", "-E", "vs", "-T", "vs_5_0", "--pixel-entry=ps", *other]
    for target in DRAWN:
        pair.write(folder, target.startswith("essl"))
        must(folder, *hard, "-o", "h.vert", "--pixel-output=h.frag", f"--target={target}")
        easy = "glsl330" if target == "glsl450" else target
        must(
            folder, clipc, "ev.hlsl", "-E", "vs", "-T", "vs_5_0", "-o", "e.vert", f"--target={easy}"
        )
        must(
            folder, clipc, "ep.hlsl", "-E", "ps", "-T", "ps_5_0", "-o", "e.frag", f"--target={easy}"
        )
        same_names(folder)
        code, text = run(folder, draw, "pair", "h.vert", "h.frag", "e.vert", "e.frag")
        found = re.search(r"(\d+) different", text)
        # An image of one color shows that too: what matters is that both are equal.
        if not found or int(found[1]) * 200 >= 4096 or (code and "too little" not in text):
            raise Failure(f"{target}: {text[:600]}")
    Pair(seed).write(folder)
    must(folder, *hard, "-o", "h.spv", "--pixel-output=h.frag.spv", "--target=vulkan")
    must(folder, draw, "link", "h.spv", "h.frag.spv")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("clipc", type=pathlib.Path)
    parser.add_argument("draw", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--keep", type=pathlib.Path, help="a folder for the files of the pairs that fail"
    )
    arguments = parser.parse_args()
    clipc, draw = arguments.clipc.resolve(), arguments.draw.resolve()
    failed = 0
    for seed in range(arguments.seed, arguments.seed + arguments.count):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            try:
                judge(clipc, draw, seed, folder)
            except Failure as failure:
                failed += 1
                print(f"seed {seed}: {failure}")
                if arguments.keep:
                    kept = arguments.keep / str(seed)
                    kept.mkdir(parents=True, exist_ok=True)
                    for file in folder.iterdir():
                        (kept / file.name).write_bytes(file.read_bytes())
    print(f"{arguments.count} pairs from seed {arguments.seed}, {failed} wrong")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
