#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws shaders that use every object type of HLSL with every element type in every way, right or wrong, and compiles each: no
crash, no broken invariant, exit code 0 or 1, and where it is 0 GLSL that glslang takes, or SPIR-V that spirv-val does.

    objects.py CLIPC [--count N] [--seed S] [--library LIBRARY_FUZZ]

With --library the same shaders go through the C interface, by the fuzz target `library`.
"""

import argparse
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROWS = (ROOT / "base/builtin_types.def").read_text(encoding="utf-8")
NAMES = re.findall(r"^(?:OBJECT|UNUSABLE)\w*\((?:\w+, )?\"(\w+)\"", ROWS, re.M)
PATCHES = re.findall(r"^PATCH\(\"(\w+)\"", ROWS, re.M)
SCALARS = re.findall(r"^SCALAR\w*\(\w+, \"(\w+)\"", ROWS, re.M)
OBJECTS = [*NAMES, *PATCHES, "ConstantBuffer", "TextureBuffer"]


def parts(text):
    return [part.strip() for part in text.split(" |")]


DECLARATIONS = """struct Plain { float4 a; float3 b[2]; float4x4 m; };
struct One { float a; };
struct Empty { };
struct Holds { Texture2D a; float4 b; };
struct Deep { Holds a; float4 c[2]; };
struct Samples { SamplerState a; };
struct Buffers { StructuredBuffer<float4> a; };
struct Many { Texture2D a[2]; };
enum Kind { kNone, kOne };
interface Face { float4 Get(); };
class Class : Face { float4 a; float4 Get() { return a; } };
typedef float4 Alias;
typedef float4 Row[2];
typedef Texture2D<float4> Map;
SamplerState s; SamplerComparisonState cs; uint k; Texture2D other;
float4 f(float4 x) { return x; }
"""
ELEMENTS = [
    *SCALARS,
    *(f"{scalar}{n}" for scalar in SCALARS if scalar[-1].isalpha() for n in (1, 2, 3, 4)),
    *parts(
        """float4x4 | half3x2 | double2x2 | int1x4 | bool2x3 | row_major float4x3 | float[2] |
float4[2] | Plain[2] | Texture2D[2] | unorm float4 | snorm float | Plain | One | Empty |
Holds | Deep | Samples | Buffers | Many | Kind | Face | Class | Alias | Row | Map |
void | string | Missing | 4 | vector<float, 3> | matrix<float, 2, 2> |
StructuredBuffer<float4> | ConstantBuffer<Plain> | Texture2D<float> | Buffer<Plain>"""
    ),
]
# Elements that the objects of a category may have, and reads of it that are right for some of its types.
FITTING = {
    "kTexture": (
        parts(
            """float4 | float | float2 | half3 | int4 | uint | uint2 | unorm float4 | min16float4"""
        ),
        parts("""$.Load(int2(0, 0)).x | $.Load(int3(0, 0, 0)).x | $.Load(int4(0, 0, 0, 0)).x |
$.Load(int2(p.xy), 1).x | $.Load(int3(p.xyz), 0).x | $.SampleLevel(s, p.x, 0).x |
$.SampleLevel(s, p.xy, 0).x | $.SampleLevel(s, p.xyz, 0).x | $.SampleLevel(s, p, 0).x |
$.Sample(s, p.xy).x | $.Sample(s, p.xyz).x | $.Gather(s, p.xy).x |
$.Gather(s, p.xyz).x | $.SampleCmpLevelZero(cs, p.xy, 0.5) |
$.SampleCmpLevelZero(cs, p.xyz, 0.5) | $.SampleCmpLevelZero(cs, p, 0.5) | $[0].x |
$[int2(k, 0)].x | $[uint3(0, 0, 0)].x | $.mips[0][int2(0, 0)].x |
$.SampleGrad(s, p.xy, p.xy, p.zw).x | $.GatherBlue(s, p.xy).x |
$.GatherCmp(cs, p.xy, 0.5).x | $.SampleBias(s, p.xyz, 0.5).x"""),
    ),
    "kSampler": (
        [""],
        parts(
            """other.SampleLevel($, p.xy, 0) | other.SampleCmpLevelZero($, p.xy, 0) | tex2D($, p.xy)"""
        ),
    ),
    "kCombinedSampler": (
        [""],
        parts("""tex1D($, p.x) | tex2D($, p.xy) | tex3D($, p.xyz) | texCUBE($, p.xyz)"""),
    ),
    "kSubpass": (
        parts("""float4 | int | uint2"""),
        parts("""$.SubpassLoad().x | $.SubpassLoad(1).x"""),
    ),
    "kTypedBuffer": (
        parts("""float4 | float | uint | int2"""),
        parts("""$.Load(k).x | $[k].x | $[0].x"""),
    ),
    "kStructuredBuffer": (
        parts("""Plain | One | float4 | float3 | uint | float4x4 | float[2] | Kind | Class"""),
        parts("""$[k].a | $[0].b[1].xyzz | $[k][0] | $.Load(k).a | $.Consume().a | $.IncrementCounter() |
$[1] | mul(p, $[k].m)"""),
    ),
    "kByteAddressBuffer": (
        [""],
        parts(
            """$.Load(k) | $.Load4(0) | $.Load<float4>(16) | $.Load<Plain>(0).a | $.Load2(k).xyxy"""
        ),
    ),
    "kConstant": (
        parts("""Plain | One | Class | Plain"""),
        parts("""$.a | $.b[k].xyzz | mul(p, $.m) | $.m[1]"""),
    ),
}
CATEGORIES = dict(re.findall(r"^OBJECT\(\w+, \"(\w+)\", \w+, (\w+)", ROWS, re.M)) | {
    "ConstantBuffer": "kConstant",
    "TextureBuffer": "kConstant",
}
# What stands at `$` for the object, and `T` for its type.
EXPRESSIONS = parts("""$ | $.a | $.x | $[0] | $[0].a | $[0].b[1] | $[0][1] | $[k] | $[p.x] | $[k].a.x | $.a.a |
(float4)$ | (float)$[0] | (Plain)$ | f($) | f($[0]) | -$ | $ + 1 | $ == $ | $ ? 1 : 0 |
$.Load(0) | $.Load(int3(0, 0, 0)) | $.Load(int2(0, 0), 0) | $.Load(int4(0, 0, 0, 0)) |
$.Load(k).a | $.Load<float4>(0) | $.Load<Holds>(0) | $.Load<Plain>(0).a | $.Load2(0) |
$.Load4(k) | $.Sample(s, p.xy) | $.Sample(s, p.xyz) | $.SampleLevel(s, p.xy, 0) |
$.SampleLevel(s, p.xyz, 0) | $.SampleLevel(s, p.x, 0) | $.SampleLevel(s, p, 0) |
$.SampleGrad(s, p.xy, p.xy, p.zw) | $[0].Sample(s, p.xy) |
$.SampleCmpLevelZero(cs, p.xy, 0.5) | $.SampleCmpLevelZero(cs, p, 0.5) |
$.SampleCmp(cs, p.xyz, 0.5) | $.Gather(s, p.xy) | $.GatherBlue(s, p.xyz) |
$.GatherCmp(cs, p.xy, 0.5) | $.Gather(s, p.xy, int2(k, 0)) | $.mips[0][int2(0, 0)] |
$.mips[0] | $.sample[1][int2(0, 0)] | $.SubpassLoad() | $.SubpassLoad(1) | $[int2(0, 0)] |
$[uint3(0, 0, 0)] | $[int2(0, 0)].x | $.Consume() | $.IncrementCounter() | $.Get() |
tex2D($, p.xy) | texCUBE($, p.xyz) | other.SampleLevel($, p.xy, 0) |
other.SampleCmpLevelZero($, p.xy, 0) | $[0].SampleLevel(s, p.xy, 0) | $[1].Load(0) |
$[0][1].Load(0) | $[k].Load(int3(0, 0, 0)) | $[1][0][0] | $.b[1].xyzz | mul(p, $.m) |
$.m[k] | float4($, 0) | { $ } | sizeof($) | $.CalculateLevelOfDetail(s, p.xy) | dot($, p) |
any($) | min($, p) | transpose($) | asuint($) | k ? $ : $ | ($, p) | f($.a) | $[0].Get()""")
STATEMENTS = parts("""r += {}; | r.x += {}; | T l = {}; r += 1; | r = {}; | float4 l = {}; r += l; |
if ({}) r = 0; | {} = r; | {} = 1; | {} += r; | {}++; | {}; |
switch ({}) {{ case 0: r = 1; }} | while ({}) break; | $.Append({}); | $.Store(0, {}); |
$.Store4(0, uint4(1, 2, 3, 4)); | InterlockedAdd($[0], 1); |
InterlockedAdd($[0].a, 1, k2); | $.InterlockedAdd(0, 1); | $.GetDimensions(k2); |
$.GetDimensions(k2, k3); | $.GetDimensions(0, k2, k3, k4); | $.GetDimensions(k2, k3, k4); |
T l; r += 1; | T l = $; r += l.Load(0); | T l = $; r += l; | T l = $; r += l.a; |
T l[2] = {{ $, $ }}; r += l[0].Load(0); | static T l; r += l[0]; |
T l[2] = {{ $, $ }}; for (int i = 0; i < 2; i++) r += l[i].Load(0); |
T l = $; l = $; r += l[0]; | Box b; b.o = $; r += b.o[0]; |
Box b = {{ $ }}; r += b.o.Load(0); | r += take($); | r += give()[0]; | r += give().a; |
T l; fill(l); r += l.Load(0); | r += boxed($); | const T l = $; r += l[0].a; |
T l = (T)0; r += l; | T l = {{ {} }}; r += 1;""")
TARGETS = """glsl120 glsl130 glsl140 glsl150 glsl330 glsl400 glsl410 glsl420 glsl430 glsl440 glsl450 glsl460 essl100 essl300
essl310 essl320 webgl1 webgl2 glsl450 glsl460 vulkan vulkan vulkan vulkan""".split()
VERSIONS = "2_0 3_0 4_0 4_1 5_0 5_0 5_0 5_1 5_1 5_1 6_0 6_0 6_6 6_7".split()
CRASH = re.compile(r"invariant broken|internal error|Sanitizer|terminate called")


class Draw:
    """One shader, with its profile and target."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        pick = self.random.choice
        self.object = pick(OBJECTS)
        # Three of four are meant to be right, with a wrong part now and then.
        fitting = FITTING.get(CATEGORIES.get(self.object)) if self.random.random() < 0.75 else None
        self.elements, self.reads = fitting or (None, None)
        self.type = self.object + self.arguments()
        self.stage = pick(("vs", "ps"))
        self.profile = f"{self.stage}_{pick(VERSIONS)}"
        self.target = pick(TARGETS)
        dimensions = pick(("", "", "", "", "", "[2]", "[2]", "[2][2]", "[2][2][2]", "[]"))
        register = pick(
            ("",) * 9 + (" : register(t0)", " : register(u1)", " : register(b0)", " : register(s0)")
        )
        self.dimensions = dimensions
        self.text = DECLARATIONS + self.globals(dimensions, register) + self.entry()

    def arguments(self):
        pick = self.random.choice
        if self.elements and self.random.random() < 0.9:
            element = pick(self.elements)
            return f"<{element}>" if element else ""
        form = self.random.random()
        if form < 0.08:
            return ""
        if self.object in PATCHES:
            return f"<{pick(ELEMENTS)}, 3>"
        if form < 0.12:
            return f"<{pick(ELEMENTS)}, {pick(ELEMENTS)}>"
        if form < 0.2:
            inner = pick(OBJECTS)
            return f"<{inner}<{pick(ELEMENTS)}> >"
        if form < 0.25:
            return f"<{pick(OBJECTS)}>"
        return f"<{pick(ELEMENTS)}>"

    def globals(self, dimensions, register):
        """The object, declared in one of many ways, and the functions that the uses name."""
        of = f"{self.type} o{dimensions}"
        place, self.name = self.random.choice(
            (
                *((f"{of}{register};", "o"),) * (30 if self.reads else 8),
                (f"cbuffer C {{ {of}; float4 after; }};", "o"),
                (f"struct Outer {{ {of}; float4 after; }}; Outer outer;", "outer.o"),
                (f"struct Outer {{ {of}; }}; Outer outer[2];", "outer[1].o"),
                (f"struct Outer {{ {of}; float4 a; }}; ConstantBuffer<Outer> outer;", "outer.o"),
                (
                    f"struct Outer {{ {of}; float4 a; }}; StructuredBuffer<Outer> outer;",
                    "outer[0].o",
                ),
                (f"static {of};", "o"),
                (f"static const {of} = {{ 0 }};", "o"),
                (f"const {of};", "o"),
                (f"groupshared {of};", "o"),
                (f"uniform {of};", "o"),
                (f"typedef {self.type} Of; Of o{dimensions};", "o"),
                (f"namespace N {{ {of}; }}", "N::o"),
                (f"[[vk::push_constant]] {of};", "o"),
                (f"{of} = 0;", "o"),
                ("", "parameter"),
                ("", "unused"),
            )
        )
        return f"""{place}
{"" if self.random.random() < 0.6 else self.functions(dimensions)}"""

    def functions(self, dimensions):
        return f"""struct Box {{ {self.type} o{dimensions}; }};
float4 take({self.type} o{dimensions}) {{ return o[0]; }}
{self.type} give() {{ return {self.name}; }}
void fill(out {self.type} x) {{ x = {self.name}; }}
float4 boxed({self.type} x) {{ Box b; b.o = x; return b.o.Load(0); }}
"""

    def entry(self):
        pick = self.random.choice
        name = self.name
        if name == "parameter":
            name = "o"
        elif self.dimensions and self.random.random() < 0.7:
            name += "".join(
                f"[{pick(('0', '1', 'k', 'p.x', 'i'))}]" for _ in range(self.dimensions.count("["))
            )
        if self.name == "unused":
            name = "other"
        body = ""
        for _ in range(self.random.randint(1, 2)):
            is_meant = self.reads and self.random.random() < 0.8
            statement = (
                (pick(STATEMENTS[:2]) if is_meant else pick(STATEMENTS))
                .replace("{{", "\1")
                .replace("}}", "\2")
            )
            statement = (
                statement.replace("{}", pick(self.reads if is_meant else EXPRESSIONS))
                .replace("\1", "{")
                .replace("\2", "}")
            )
            statement = re.sub(r"\bT\b", self.type, statement).replace("$", name)
            body += (
                f"  {statement}\n"
                if self.random.random() < 0.8
                else f"  for (int i = 0; i < 2; i++) {{ {statement} }}\n"
            )
        if self.name == "unused":
            body += (
                f"  {self.type} hidden{self.dimensions};\n" if self.random.random() < 0.5 else ""
            )
        parameter = (
            f", {pick(('uniform ', '', 'in '))}{self.type} o{self.dimensions}"
            if self.name == "parameter"
            else ""
        )
        semantic = "SV_Position" if self.stage == "vs" else "SV_Target"
        hidden = f"{self.type} unused{self.dimensions};\n" if self.name == "unused" else ""
        return f"""{hidden}float4 main(float4 p : P{parameter}) : {semantic} {{
  float4 r = p; uint k2, k3, k4;
{body}  return r;
}}
"""


def options_of(draw):
    return ["-T", draw.profile, f"--target={draw.target}", "--validate", "-w", "--verify"]


def problem_of(clipc, draw, folder, spirv_val):
    """What is wrong with clipc's answer to the shader; empty if nothing is, and the exit code."""
    source = folder / "object.hlsl"
    source.write_text(draw.text, encoding="utf-8")
    binary = folder / "object.spv"
    as_spirv = draw.target == "vulkan" and spirv_val
    output = ["-spirv", "-o", str(binary)] if as_spirv else ["-o", "-"]
    done = subprocess.run(
        [clipc, str(source), *options_of(draw), *output],
        capture_output=True,
        check=False,
        timeout=60,
    )
    said = (done.stdout + done.stderr).decode(errors="replace")
    if done.returncode not in (0, 1):
        return f"exit code {done.returncode}\n{said[-2000:]}", done.returncode
    if CRASH.search(said):
        return said[-2000:], done.returncode
    if done.returncode == 1 and "error:" not in said:
        return "exit code 1 without an error", 1
    if as_spirv and done.returncode == 0:
        judged = subprocess.run([spirv_val, str(binary)], capture_output=True, check=False)
        if judged.returncode != 0:
            return f"spirv-val: {judged.stdout.decode()[-1000:]}{judged.stderr.decode()[-1000:]}", 0
    return "", done.returncode


def run_clipc(clipc, seeds):
    spirv_val = shutil.which("spirv-val")
    failures, compiled = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in seeds:
            draw = Draw(seed)
            problem, code = problem_of(clipc, draw, pathlib.Path(folder), spirv_val)
            compiled += code == 0
            if problem:
                failures += 1
                print(f"seed {seed}, {' '.join(options_of(draw))}\n{draw.text}\n{problem}\n")
    print(f"{len(seeds)} shaders, {compiled} of them compile, {failures} failures")
    return failures


def run_library(program, seeds):
    """Gives the shaders to the fuzz target, a hundred at a time, and names those that end it."""
    failures = 0
    for begin in range(0, len(seeds), 100):
        with tempfile.TemporaryDirectory() as folder:
            for seed in seeds[begin : begin + 100]:
                draw = Draw(seed)
                text = "\n".join([f"-T{draw.profile}", *options_of(draw)[2:], "", draw.text])
                (pathlib.Path(folder) / f"{seed}").write_text(text, encoding="utf-8")
            if subprocess.run([program, folder], capture_output=True, check=False).returncode == 0:
                continue
            for path in sorted(pathlib.Path(folder).iterdir()):
                with tempfile.TemporaryDirectory() as alone:
                    shutil.copy(path, alone)
                    done = subprocess.run([program, alone], capture_output=True, check=False)
                if done.returncode != 0:
                    failures += 1
                    print(
                        f"seed {path.name}: exit code {done.returncode}\n{path.read_text(encoding='utf-8')}"
                    )
    print(f"{len(seeds)} shaders through the library, {failures} failures")
    return failures


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("clipc")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--library")
    options = parser.parse_args()
    seeds = range(options.seed, options.seed + options.count)
    failures = (
        run_library(options.library, seeds) if options.library else run_clipc(options.clipc, seeds)
    )
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
