#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles each construct of pixel shaders, repeated 2,000 and 8,000 times: four times as much text takes at most six times as
many instructions. The processor's time says quickly that a construct grows as its text does: the least of three runs of the short text,
and of the long one as many as it needs, since another program beside it makes a run only longer. Where three do not say so, valgrind
counts.

    growth.py CLIPC [-spirv] [NAME...]
"""

import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

COUNTS = (2000, 8000)
GROWTH = 1.5  # beside the growth of the text
RUNS = 3
REST = 0.03  # seconds that a run may differ by, with other programs beside it

OBJECTS = """Texture2D t; Texture2DMS<float4> ms; Texture2DArray<float4> layers; TextureCube sky; SamplerState s;
SamplerComparisonState shadow; sampler2D old;
RWStructuredBuffer<uint> counted : register(u1); RWStructuredBuffer<uint> down : register(u2);
AppendStructuredBuffer<float3> added : register(u3); ConsumeStructuredBuffer<float4> taken : register(u4);
struct Row { float4 v; float4x4 m; }; RWStructuredBuffer<Row> rows : register(u7);
RWByteAddressBuffer bytes : register(u5); RWTexture2D<float4> image : register(u6);
"""

# The statement that is repeated, {i} its number, and what stands before the entry for each.
CONSTRUCTS = {
    "sample": ("r += t.Sample(s, uv * {i});", ""),
    "sample-bias": ("r += t.SampleBias(s, uv, {i}.5);", ""),
    "sample-grad": ("r += t.SampleGrad(s, uv, r.xy, r.zw);", ""),
    "sample-offset": ("r += t.Sample(s, uv, int2(1, -{i} % 8));", ""),
    "sample-compare": ("r += t.SampleCmp(shadow, uv, r.x);", ""),
    "sample-in-branch": ("if (uv.x > {i}) r += t.Sample(s, uv);", ""),
    "tex2d": ("r += tex2D(old, uv * {i});", ""),
    "gather": ("r += t.Gather(s, uv, int2({i} % 4, 1));", ""),
    "gather-four-offsets": (
        "r += t.Gather(s, uv, int2(0, 0), int2(1, 0), int2(0, 1), int2(1, 1));",
        "",
    ),
    "load": ("r += t.Load(int3(r.xy, {i} % 3));", ""),
    "load-sample": ("r += ms.Load(int2(r.xy), {i} % 4);", ""),
    "level-of-detail": ("r += t.CalculateLevelOfDetail(s, uv * {i});", ""),
    "dimensions": ("layers.GetDimensions(n, m, k); r += n + m + k;", ""),
    "derivatives": ("r += ddx(r) + ddy(uv.xyxy * {i}) + fwidth(r);", ""),
    "clip": ("clip(r - {i});", ""),
    "discard-before-sample": ("if (r.x > {i}) discard; r += t.Sample(s, r.xy);", ""),
    "discard-in-function": (
        "r += f{i}(r);",
        "float4 f{i}(float4 r) {{ clip(r.y); return t.Sample(s, r.xy); }}",
    ),
    "append": ("added.Append(r.xyz);", ""),
    "consume": ("r += taken.Consume();", ""),
    "increment": ("r += counted[counted.IncrementCounter()];", ""),
    "decrement": ("r += down.DecrementCounter();", ""),
    "atomics": ("bytes.InterlockedAdd(4 * {i}, n, m); r += m;", ""),
    "stores": ("bytes.Store2({i} * 8, asuint(r.xy)); image[int2({i}, 0)] = r;", ""),
    "stores-of-components": (
        "rows[{i}].v.xz = r.xy; rows[{i}].v[n] = r.x; rows[{i}].m._m00_m11 += r.zw;",
        "",
    ),
    "store-of-part": ("image[int2({i}, 0)].xz = r.xy;", ""),
    "vertices": ("r += GetAttributeAtVertex(flat, {i} % 3);", ""),
    "centroids": ("r.xy += EvaluateAttributeCentroid(uv) * {i};", ""),
    "snapped": ("r.xy += EvaluateAttributeSnapped(uv, int2(r.xy));", ""),
    "waves": ("r += WaveActiveSum(r * {i}) + WaveReadLaneAt(r.x, 3);", ""),
    "quads": ("r += QuadReadAcrossX(r * {i});", ""),
    "places": ("r += position.xyzw * {i} + front;", ""),
    "textures": ("r += t{i}.Load(int3(0, 0, 0));", "Texture2D t{i};"),
    "textures-of-a-function": ("r += Read(t, s, uv * {i});", ""),
    "struct-with-texture": (
        "P p{i}; p{i}.a = t; p{i}.s = s; r += Take(p{i}, uv);",
        "",
    ),
}
STRUCT = """struct P { Texture2D a; SamplerState s; };
float4 Read(Texture2D a, SamplerState b, float2 p) { return a.Sample(b, p); }
float4 Take(P p, float2 uv) { return p.a.Sample(p.s, uv); }
"""
ENTRY = """float4 main(float4 position : SV_Position, float2 uv : UV, nointerpolation float4 flat : FLAT, bool front : SV_IsFrontFace)
    : SV_Target {
  float4 r = uv.xyxy; uint n = 0, m = 0, k = 0;
"""


def text(name, count):
    statement, before = CONSTRUCTS[name]
    return (
        OBJECTS
        + STRUCT
        + "".join(before.format(i=i) + "\n" for i in range(count) if before)
        + ENTRY
        + "".join("  " + statement.format(i=i) + "\n" for i in range(count))
        + "  return r;\n}\n"
    )


def used():
    """The processor's time of all compiles so far; Linux measures the sum, and only estimates its parts."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def seconds(command, path):
    """Returns the processor's time of a compile."""
    before = used()
    done = subprocess.run([*command, path], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{path}: {done.stderr[:400]}")
    return used() - before


def instructions(command, path):
    """Returns how many instructions a compile takes."""
    counted = [
        "valgrind",
        "--tool=callgrind",
        f"--callgrind-out-file={os.devnull}",
        *command,
        path,
    ]
    done = subprocess.run(counted, capture_output=True, text=True, check=True)
    return int(re.search(r"Collected : (\d+)", done.stderr)[1])


def grows_faster(few, many, rest=0.0):
    return many > GROWTH * COUNTS[1] / COUNTS[0] * few + rest


def mistake(command, name, folder):
    paths = [pathlib.Path(folder) / f"{name}.{count}.hlsl" for count in COUNTS]
    for count, path in zip(COUNTS, paths, strict=True):
        path.write_text(text(name, count), encoding="ascii")
    short = min(seconds(command, paths[0]) for _ in range(RUNS))
    for _ in range(RUNS):
        if not grows_faster(short, seconds(command, paths[1]), REST):
            return None
    few, many = (instructions(command, path) for path in paths)
    if grows_faster(few, many):
        return f"{name}: {few:,} instructions for {COUNTS[0]}, {many:,} for {COUNTS[1]}"
    return None


def main():
    clipc, *words = sys.argv[1:]
    options = [word for word in words if word.startswith("-")]
    names = [word for word in words if not word.startswith("-")] or list(CONSTRUCTS)
    command = [clipc, "-w", "-T", "ps_6_1", "--target=vulkan", *options, "-o", os.devnull]
    with tempfile.TemporaryDirectory() as folder:
        mistakes = [what for name in names if (what := mistake(command, name, folder))]
    print("\n".join(mistakes) or f"{len(names)} constructs grow as their text does")
    return bool(mistakes)


if __name__ == "__main__":
    sys.exit(main())
