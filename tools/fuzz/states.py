#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws effects whose passes, samplers and blocks have any state of Direct3D with any value, right or wrong, and whose passes choose
shaders in any way, and compiles each: no crash, no broken invariant, exit code 0 or 1, JSON that can be read, and a program for each
value that chooses one.

    states.py CLIPC [--count N] [--seed S]

States and words are those of the tables in compiler/effect/.
"""

import argparse
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = "\n".join(
    (ROOT / "compiler/effect" / name).read_text(encoding="utf-8")
    for name in ("d3d_states.def", "gl_states.def", "gl_words.def")
)
STATES = {}  # names, by place
for place, name in re.findall(r'^(?:GL_RULE|D3D_STATE)\((\w+), "([^"]+)"', TABLES, re.M):
    STATES.setdefault(place, []).append(name.replace("#", "1"))
WORDS = sorted(set(re.findall(r'^(?:GL_WORD|D3D_WORD)\([\w"]+, "(\w+)"', TABLES, re.M)))
OBS_WORDS = "Linear Point Anisotropy Repeat Clamp None Mirror MirrorOnce Border".split()
NUMBERS = "0 1 -1 2 7 255 0xFF 0xFFFFFFFF 4294967296 0.5 -0.0 1e38 1e39 (1+2)*3 1/0 3u".split()
CRASH = re.compile(r"invariant broken|internal error|Sanitizer|Segmentation")
BLOCKS = {
    "BlendState": "SetBlendState",
    "RasterizerState": "SetRasterizerState",
    "DepthStencilState": "SetDepthStencilState",
}
SHADERS = """float4x4 World; float Size; texture Map;
struct V { float4 p : POSITION; float2 uv : TEXCOORD0; };
V VA(V v) { v.p = mul(v.p, World); return v; }
V VB(V v, uniform float by) { v.p *= by; return v; }
float4 PA(float2 uv : TEXCOORD0) : COLOR { return uv.xyxy * Size; }
float4 PB(float2 uv : TEXCOORD0) : COLOR { return tex2D(Maps, uv); }
struct G { float4 p : SV_Position; float2 uv : TEXCOORD0; };
G VG(float4 p : POSITION) { G g = {mul(p, World), p.xy}; return g; }
[maxvertexcount(2)] void GA(point G g[1], inout PointStream<G> s) { s.Append(g[0]); }
RWBuffer<float> Sums;
[numthreads(4, 1, 1)] void CA(uint i : SV_DispatchThreadID) { Sums[i] = Size; }
VertexShader VS[3] = { compile vs_3_0 VA(), compile vs_3_0 VB(2), NULL };
PixelShader PS[2] = { compile ps_3_0 PA(), compile ps_3_0 PB() };
"""
OBS_SHADERS = """uniform float4x4 World; uniform float Size<string label = "a";> = 1.0;
struct V { float4 p : POSITION; float2 uv : TEXCOORD0; };
V VA(V v) { v.p = mul(v.p, World); return v; }
V VC(V v, float by) { v.p *= by * Size; return v; }
float4 PA(float2 uv : TEXCOORD0) : TARGET { return Map.Sample(Maps, uv) + (obs_glsl_compile ? 1.0 : 0.0); }
"""


class Draw:
    def __init__(self, seed):
        self.random = random.Random(seed)
        self.is_obs = self.chance(0.15)
        self.options = self.pick(
            (
                ["--target=glsl330", "-Fh", "effect.h"],
                ["-spirv"],
                ["--target=vulkan", "--flip-y"],
                ["--target=essl300", "-Fh", "effect.h", "--flip-y"],
                ["--effect-dialect=monogame"],
            )
        )
        if self.is_obs:
            self.options = self.pick((self.options[:1], ["--effect-dialect=obs"], []))
        self.text = self.effect()

    def pick(self, items):
        return self.random.choice(list(items))

    def chance(self, share):
        return self.random.random() < share

    def word(self):
        word = self.pick([*WORDS, *OBS_WORDS])
        return self.pick((word, word.lower(), f"D3DBLEND_{word}", word[:-1] or "x"))

    def value(self):
        if self.chance(0.01):
            return self.pick(("", "((((1", "{", '"text"'))
        kind = self.random.randrange(9)
        if kind < 3:
            return self.word()
        if kind < 5:
            return self.pick(NUMBERS)
        return self.pick(
            (
                "true",
                "FALSE",
                f"({self.word()})",
                f"{self.word()} | {self.word()} | {self.pick(NUMBERS)}",
                f"float4({self.pick(NUMBERS)}, 0, 0.5, {self.pick(NUMBERS)})",
                f"{{{self.pick(NUMBERS)}, {self.word()}}}",
                "<Map>",
                "(Size)",
                "(Size * 2 + 1)",
                "NULL",
            )
        )

    def state(self, place):
        name = self.pick(STATES[place if self.chance(0.8) else self.pick(STATES)])
        if self.chance(0.1):
            name = name[:-1] + self.pick("xyz")
        index = self.pick(("", "", "", "[0]", "[1]", "[99999999999]", "[i]"))
        end = ";" if self.chance(0.995) else ""
        return f"  {name}{index} = {self.value()}{end}\n"

    def states(self, place):
        return "".join(self.state(place) for _ in range(self.random.randrange(8)))

    def index(self):
        index = self.pick(("i", "k", "0", "2", "i + k", "9", "Given[i]"))
        while self.chance(0.5):
            index = f"{self.pick(('T0', 'T1', 'T2', 'Absent'))}[{index}]"
        return index

    def shader(self, stage):
        if self.chance(0.6):
            return f"({stage}S[{self.index()}])"
        if self.chance(0.1):
            return f"compile {stage.lower()}s_3_0 {stage}{self.pick(('B()', 'C(v)', 'A(1, 2)'))}"
        name = self.pick((f"{stage}A()", "VB(1.5)" if stage == "V" else "PB()"))
        profile = self.pick(("3_0", "2_0", "4_0_level_9_1"))
        return self.pick((f"compile {stage.lower()}s_{profile} {name}", "NULL", f"{stage}S"))

    def effect_pass(self):
        if self.is_obs:
            call = self.pick(
                ("VA(v)", "compile VA(v)", "VC(v, 2.0)", "VC(v, (1))", "VA((v))", "VA")
            )
            return f"  pass {{ vertex_shader = {call}; pixel_shader = PA(uv); }}\n"
        lines = f"  VertexShader = {self.shader('V')};\n  PixelShader = {self.shader('P')};\n"
        if self.chance(0.1):
            stage, prefix, name = self.pick((("Geometry", "gs", "GA"), ("Compute", "cs", "CA")))
            call = f"{self.pick((name, name, 'VG', 'Absent'))}()"
            profile = f"{prefix}_{self.pick(('4_0', '5_0', '9_9'))}"
            lines = self.pick(
                (
                    f"  VertexShader = compile vs_4_0 VG();\n  {stage}Shader = compile {profile} {call};\n",
                    f"{lines}  {stage}Shader = {self.pick(('NULL', name, 'Absent'))};\n",
                    f"  SetVertexShader(CompileShader(vs_4_0, VG()));\n"
                    f"  Set{stage}Shader(CompileShader({profile}, {call}));\n",
                )
            )
        lines += self.states("Pass")
        if self.chance(0.3):
            block, call = self.pick(BLOCKS.items())
            lines += f"  {call}({block}0, {self.value()}, {self.value()});\n"
        return f"  pass P{self.random.randrange(3)} <int a = {self.value()};> {{\n{lines}}}\n"

    def effect(self):
        if self.is_obs:
            text = f"uniform texture2d Map;\nsampler_state Maps {{\n{self.states('Sampler')}}};\n"
            passes = "".join(self.effect_pass() for _ in range(1 + self.random.randrange(3)))
            return f"{text}{OBS_SHADERS}technique T {{\n{passes}}}\n"
        text = f"sampler Maps = sampler_state {{ Texture = <Map>;\n{self.states('Sampler')}}};\n"
        for block in BLOCKS:
            text += f"{block} {block}0 {{\n{self.states(block)}}};\n"
        text += SHADERS + "int i, k; int Given[2];\n"
        for number in range(3):
            values = [
                str(self.random.randrange(-1, 4)) for _ in range(1 + self.random.randrange(4))
            ]
            text += f"int T{number}[{len(values)}] = {{{', '.join(values)}}};\n"
        passes = "".join(self.effect_pass() for _ in range(1 + self.random.randrange(3)))
        return text + f"technique T {{\n{passes}}}\n"


def misfit(document):
    """A pass whose choices name programs that it does not have; empty if there is none."""
    for technique in document["techniques"]:
        for each in technique["passes"]:
            for choice in each.get("choices", []):
                combinations = 1
                for value in choice["values"]:
                    combinations *= value["count"]
                named = {number for number in choice["programs"] if number is not None}
                if len(choice["programs"]) != combinations:
                    return f"{combinations} combinations, {len(choice['programs'])} programs"
                if not named <= set(range(len(each["programs"]))):
                    return f"programs {sorted(named)} of {len(each['programs'])}"
    return ""


def problem_of(clipc, draw, folder):
    """What is wrong with clipc's answer to the effect; empty if nothing is, and the exit code."""
    for file in folder.iterdir():
        file.unlink()
    source = folder / "effect.fx"
    source.write_text(draw.text, encoding="utf-8")
    done = subprocess.run(
        [clipc, "--effect", source, "-o", folder, "--verify", *draw.options],
        capture_output=True,
        check=False,
        timeout=60,
        cwd=folder,
    )
    said = (done.stdout + done.stderr).decode(errors="replace")
    if done.returncode not in (0, 1) or CRASH.search(said):
        return f"exit code {done.returncode}\n{said[-2000:]}", done.returncode
    if done.returncode == 1 and "error:" not in said:
        return "exit code 1 without an error", 1
    index = folder / "effect.json"
    if not index.exists():
        return ("" if done.returncode == 1 else "no JSON"), done.returncode
    return misfit(json.loads(index.read_text(encoding="utf-8"))), done.returncode


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("clipc")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    failures, compiled = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(options.seed, options.seed + options.count):
            draw = Draw(seed)
            problem, code = problem_of(
                str(pathlib.Path(options.clipc).resolve()), draw, pathlib.Path(folder)
            )
            compiled += code == 0
            if problem:
                failures += 1
                print(f"seed {seed}, {' '.join(draw.options)}\n{draw.text}\n{problem}\n")
    print(f"{options.count} effects, {compiled} of them compile, {failures} failures")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
