#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles shaders in which a few tokens are others: what a person gets who makes a slip, and what a fuzzer of bytes seldom finds,
since most of its texts do not parse. Each compile ends in time, with exit code 0, 1 or 2 and no word of an internal error; a part of
those that compile is validated too.

    mutations.py CLIPC [--count N] [--seed S] [--validated SHARE] [--out FOLDER] [-j N] [FILE...]

The shaders are those of testdata/ and examples/, or the files given. A mutation that fails is written to FOLDER, and its command is
printed.
"""

import argparse
import concurrent.futures
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SECONDS = 20
TARGETS = "glsl450 glsl460 glsl430 glsl400 glsl330 glsl150 glsl130 glsl120 essl100 essl300 essl310 essl320 vulkan hlsl".split()
PROFILES = {
    "vs": "vs_2_0 vs_3_0 vs_4_0 vs_4_0_level_9_1 vs_4_0_level_9_3 vs_4_1 vs_5_0 vs_5_1 vs_6_0 vs_6_6".split(),
    "ps": "ps_2_0 ps_2_b ps_3_0 ps_4_0 ps_4_0_level_9_1 ps_4_1 ps_5_0 ps_5_1 ps_6_0 ps_6_6".split(),
    "gs": "gs_4_0 gs_4_1 gs_5_0 gs_5_1 gs_6_0 gs_6_6".split(),
    "cs": "cs_4_0 cs_4_1 cs_5_0 cs_5_1 cs_6_0 cs_6_6".split(),
    "hs": "hs_5_0 hs_5_1 hs_6_0 hs_6_6".split(),
    "ds": "ds_5_0 ds_5_1 ds_6_0 ds_6_6".split(),
}
KEPT = re.compile(r"(?:^|\s)(-[TE]\s*\S+|-D\s*\S+|--lower=\S+|-I\s*\S+|--pixel-entry=\S+)")
STAGE = re.compile(r"(?:-T)?(ps|cs|gs|hs|ds)_")
TOKEN = re.compile(
    r"""//[^\n]*|/\*.*?\*/|\#[^\n]*|\s+|"[^"\n]*"|[A-Za-z_]\w*|0[xX][0-9a-fA-F]+[uUlL]*"""
    r"""|(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?[fFhHuUlL]*|<<=|>>=|[-+*/%&|^=!<>]=|&&|\|\||<<|>>|\+\+|--|::|.""",
    re.DOTALL,
)
NUMBERS = "0 1 -1 2 3 4 7 31 32 255 4294967295 0x80000000 -2147483648 0.0 -0.0 1e38 1e-45 0.5 1.5h 3u".split()
OPERATORS = "+ - * / % & | ^ << >> < > <= >= == != && || = += -= *= /= %= , ? :".split()
MODIFIERS = (
    "const static uniform precise row_major column_major nointerpolation linear centroid sample noperspective "
    "point line triangle lineadj triangleadj in out inout groupshared globallycoherent snorm unorm volatile shared extern inline"
).split()
SEMANTICS = (
    "SV_Position SV_Target SV_Target1 SV_Depth SV_ClipDistance0 SV_CullDistance SV_VertexID SV_InstanceID SV_IsFrontFace "
    "SV_DispatchThreadID SV_GroupID SV_GroupThreadID SV_GroupIndex SV_Coverage SV_SampleIndex SV_PrimitiveID SV_GSInstanceID SV_RenderTargetArrayIndex SV_ViewportArrayIndex TEXCOORD0 COLOR0 COLOR1 POSITION NORMAL FOG PSIZE VPOS VFACE DEPTH "
    "SV_OutputControlPointID SV_DomainLocation SV_TessFactor SV_InsideTessFactor"
).split()
SCALARS = "float int uint bool half double min16float uint64_t".split()
TYPES = (
    [scalar + size for scalar in SCALARS for size in ("", "1", "2", "3", "4", "2x2", "3x4", "4x4")]
    + "void Texture2D Texture3D TextureCube Texture2DArray Texture2DMS<float4> Buffer<float4> StructuredBuffer<float4>".split()
    + "RWTexture2D<float4> RWBuffer<uint> RWStructuredBuffer<int> ByteAddressBuffer SamplerState SamplerComparisonState".split()
    + "InputPatch<float4,3> OutputPatch<float4,3>".split()
    + "sampler sampler2D samplerCUBE texture ConstantBuffer<float4> TextureBuffer<float> AppendStructuredBuffer<float>".split()
    + "PointStream<float4> LineStream<float4> TriangleStream<float4>".split()
)
WORDS = "if else for while do switch case default break continue return discard struct cbuffer namespace typedef".split()
INTRINSICS = (
    "mul dot cross normalize length saturate clamp lerp pow exp log sin atan2 fmod frac modf frexp ddx fwidth clip "
    "transpose determinant any all select asfloat asuint f16tof32 countbits firstbithigh tex2D tex2Dlod texCUBE "
    "GroupMemoryBarrierWithGroupSync AllMemoryBarrier DeviceMemoryBarrier InterlockedAdd InterlockedCompareExchange"
).split()


def options_of(file, text):
    run = next((line for line in text.splitlines() if "RUN:" in line and "%clipc" in line), "")
    kept = " ".join(KEPT.findall(run.split("|")[0]))
    return kept.replace("%S", str(file.parent)).replace("%s", str(file)).split() or ["-T", "vs_5_0"]


def mutate(tokens, random_):
    """Changes one place of a list of tokens."""
    code = [
        i
        for i, token in enumerate(tokens)
        if token.strip() and not token.startswith(("#", "//", "/*"))
    ]
    if len(code) < 4:
        return
    at = random_.randrange(len(code) - 1)
    i, after = code[at], code[at + 1]
    token = tokens[i]
    kind = random_.randrange(12)
    if kind == 0:
        tokens[i] = ""
    elif kind == 1:
        tokens[i] = token + " " + token
    elif kind == 2:
        tokens[i], tokens[after] = tokens[after], token
    elif kind == 3:  # another name of the same shader
        names = [tokens[other] for other in code if re.match(r"[A-Za-z_]", tokens[other])]
        tokens[i] = random_.choice(names or [token])
    elif kind == 4:
        tokens[i] = " " + random_.choice(TYPES) + " "
    elif kind == 5:
        tokens[i] = random_.choice(MODIFIERS + WORDS) + " " + token
    elif kind == 6:
        tokens[i] = " " + random_.choice(INTRINSICS + SEMANTICS) + " "
    elif kind == 7 and re.match(r"[\d.]", token):
        tokens[i] = random_.choice(NUMBERS)
    elif kind == 8 and not re.match(r"[\w\"(){}\[\];]", token):
        tokens[i] = random_.choice(OPERATORS)
    elif kind == 9:  # a statement is removed, or stands twice
        ends = [other for other in code if tokens[other] in ";{}"]
        if len(ends) > 2:
            first = random_.randrange(len(ends) - 1)
            place = slice(ends[first] + 1, ends[first + 1] + 1)
            tokens[place] = tokens[place] * random_.choice((0, 2))
    elif kind == 10:  # a part of an expression has an index, a member, a cast or another operand
        around = "({})[{n}]|({}).{m}|(({t}){})|({} {o} {n})|{}(0)|{}[{n}]|{}.{m}".split("|")
        tokens[i] = random_.choice(around).format(
            token,
            n=random_.choice(NUMBERS),
            m=random_.choice(
                "x xy wzyx rgba _m00 _11_12 xyzw length Sample Load Append RestartStrip a".split()
            ),
            t=random_.choice(TYPES),
            o=random_.choice(OPERATORS),
        )
    elif kind == 11 and token == ":":
        tokens[after] = random_.choice(SEMANTICS)


def make(files, seed):
    """The text and the options of the mutation with a number."""
    random_ = random.Random(seed)
    file = random_.choice(files)
    text = file.read_text(errors="replace")
    options = options_of(file, text)
    tokens = TOKEN.findall(text)
    for _ in range(random_.choice((1, 1, 1, 2, 3, 5))):
        mutate(tokens, random_)
    if random_.random() < 0.3:
        stage = next((found[1] for found in map(STAGE.match, options) if found), "vs")
        options = options + ["-T", random_.choice(PROFILES[stage])]
    target = random_.choice(TARGETS)
    options = options + ["-I", str(file.parent), "--target=" + target]
    if target == "vulkan":
        options = options + ["-spirv"]
    return file, "".join(tokens), options


def refusal(spirv_val, module):
    """What spirv-val says of a module; None if nothing is wrong."""
    done = subprocess.run(
        [spirv_val, "--target-env", "vulkan1.1", module],
        capture_output=True,
        text=True,
        errors="replace",
    )
    return f"spirv-val: {(done.stdout + done.stderr).strip()[:300]}" if done.returncode else None


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("clipc", type=pathlib.Path)
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--validated", type=float, default=0.05, help="the share that is validated, 0 to 1"
    )
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("-j", type=int, default=2)
    given = parser.parse_args()
    files = given.files or [
        file
        for folder in ("testdata", "examples")
        for file in sorted((ROOT / folder).rglob("*.hlsl"))
        if file.stat().st_size < 20_000
    ]
    scratch = pathlib.Path(tempfile.mkdtemp())
    spirv_val = shutil.which("spirv-val")
    out = given.out or scratch
    out.mkdir(parents=True, exist_ok=True)

    def run(seed):
        file, text, options = make(files, seed)
        if random.Random(~seed).random() < given.validated:
            options = options + ["--validate"]
        shader = scratch / f"{seed}.hlsl"
        shader.write_text(text)
        command = [given.clipc.resolve(), shader, *options, "-o", scratch / f"{seed}.out"]
        problem = None
        try:
            done = subprocess.run(
                command, capture_output=True, text=True, errors="replace", timeout=SECONDS
            )
            if done.returncode not in (0, 1, 2):
                problem = f"exit code {done.returncode}"
            elif "internal error" in done.stderr or "invariant broken" in done.stderr:
                problem = "internal error"
            elif done.returncode and "error" not in done.stderr:
                problem = "exit code 1 without an error"
            elif spirv_val and "-spirv" in options and done.returncode == 0:
                problem = refusal(spirv_val, scratch / f"{seed}.out")
        except subprocess.TimeoutExpired:
            problem = f"more than {SECONDS} seconds"
        for made in scratch.glob(f"{seed}.out*"):
            made.unlink()
        if problem:
            kept = out / f"mutation{seed}.hlsl"
            kept.write_text(text)
            place = file.relative_to(ROOT) if file.is_relative_to(ROOT) else file
            words = " ".join(str(word) for word in (given.clipc, kept, *options))
            print(
                f"{problem}: {words}    # of {place}\n    {done.stderr.strip()[-300:] if done.returncode else ''}",
                flush=True,
            )
        else:
            shader.unlink()
        return problem is None, "done" in locals() and done.returncode == 0

    with concurrent.futures.ThreadPoolExecutor(given.j) as pool:
        results = list(pool.map(run, range(given.seed, given.seed + given.count)))
    compiled = sum(1 for _, ok in results if ok)
    failed = sum(1 for good, _ in results if not good)
    print(f"{given.count} mutations of {len(files)} shaders, {compiled} compile, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
