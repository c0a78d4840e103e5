# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Ten thousand permutations of an engine's macros for one vertex shader with 30 kB of includes, in one run; and five hundred
of them as files that are compiled one by one in one process. Prints how many times as fast the first is, in processor
time, its peak memory, and how many files it writes.

usage: permutations.py CLIPC FOLDER
"""

import json
import os
import pathlib
import resource
import subprocess
import sys

# The vertex shader asks for the first four; the others are the pixel shader's, and an engine passes them all.
AXES = {
    "SKINNING": 2,
    "INSTANCING": 5,
    "QUALITY": 5,
    "FOG": 2,
    "LIGHTS": 5,
    "SHADOWS": 5,
    "ALPHA": 2,
    "NORMALS": 2,
}
COUNT = 10000
SINGLES = 500

MAIN = """#include "common.hlsli"
#include "waves.hlsli"
#include "skinning.hlsli"
cbuffer Frame : register(b0) { float4x4 view_projection; float4 water; float4 eye; };
cbuffer Object : register(b1) { float4x4 world[5]; };
struct Output { float4 position : SV_Position; float3 normal : NORMAL; float fog : TEXCOORD0; };

[clipplanes(water)]
Output main(float3 position : POSITION, float3 normal : NORMAL, float4 weights : BLENDWEIGHT, uint4 bones : BLENDINDICES) {
  Output output;
  float4 at = float4(position, 1);
#if SKINNING
  at = Skin(at, weights, bones);
#endif
  at = mul(at, world[INSTANCING]);
  [unroll] for (int i = 0; i < QUALITY; ++i) at.y += Wave0(at.xz, eye.w + i);
  output.position = mul(at, view_projection);
  output.normal = normalize(mul(normal, (float3x3)world[INSTANCING]));
#if FOG
  output.fog = saturate(Fade3(distance(at.xyz, eye.xyz)));
#else
  output.fog = 1;
#endif
  return output;
}
"""


def function(kind, number):
    return f"""// {kind} {number}: as the artists asked for it. The constants come from the tuning of the second chapter.
float {kind}{number}(float2 at, float time) {{
  float phase = dot(at, float2(0.{number + 11}, 0.{number + 23})) * {number + 1}.5 + time * {number % 7 + 1}.25;
  float height = sin(phase) * 0.{number + 31} + cos(phase * 1.7) * 0.{number + 17};
  if (height > {number % 3}.5) height = lerp(height, {number % 3}.5, saturate(phase));
  return height * exp(-0.0{number + 10} * dot(at, at));
}}
"""


def write(folder):
    folder.mkdir(parents=True)
    common = "".join(f"static const float kTuning{i} = {i}.5;\n" for i in range(60))
    common += "".join(
        f"float Fade{i}(float at) {{ return exp2(-at * kTuning{i}) + kTuning{i + 1}; }}\n"
        for i in range(50)
    )
    (folder / "common.hlsli").write_text("#pragma once\n" + common)
    (folder / "waves.hlsli").write_text(
        '#pragma once\n#include "common.hlsli"\n' + "".join(function("Wave", i) for i in range(56))
    )
    skinning = "cbuffer Bones : register(b2) { float4x4 bone[64]; };\n" + "".join(
        function("Flex", i) for i in range(10)
    )
    skinning += (
        "float4 Skin(float4 p, float4 w, uint4 i) { float4 q = 0; [unroll] for (int k = 0; k < 4; ++k) "
        "q += w[k] * mul(p, bone[i[k]]); return q; }\n"
    )
    (folder / "skinning.hlsli").write_text("#pragma once\n" + skinning)
    (folder / "ground.hlsl").write_text(MAIN)
    return sum(file.stat().st_size for file in folder.glob("*.hlsli"))


def run(words, folder):
    """Seconds of processor time, and MiB at the peak."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    # What AddressSanitizer keeps of freed memory is not the program's.
    environment = {**os.environ, "ASAN_OPTIONS": "quarantine_size_mb=1"}
    subprocess.run(words, cwd=folder, check=True, env=environment)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return (
        after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
        after.ru_maxrss / 1024,
    )


def main():
    clipc, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    size = write(folder)
    (folder / "out").mkdir()
    (folder / "single").mkdir()
    words = [clipc, "-T", "vs_5_0"]
    lists = [f"-D{name}={{{','.join(map(str, range(count)))}}}" for name, count in AXES.items()]
    batch, memory = run([*words, *lists, "ground.hlsl", "-o", "out"], folder)
    index = json.loads((folder / "out/index.json").read_text())
    assert len(index["shaders"]) == COUNT and all(
        shader["status"] == "compiled" for shader in index["shaders"]
    )

    chosen = index["shaders"][:: COUNT // SINGLES]
    for number, shader in enumerate(chosen):
        defines = "".join(f"#define {name} {value}\n" for name, value in shader["defines"].items())
        (folder / f"{number}.hlsl").write_text(defines + '#include "ground.hlsl"\n')
    single, _ = run(
        [*words, *(f"{number}.hlsl" for number in range(len(chosen))), "-o", "single"], folder
    )
    for number, shader in enumerate(chosen):
        own, shared = folder / f"single/{number}.vert", folder / "out" / shader["files"]["glsl"]
        assert own.read_text() == shared.read_text(), (
            f"{shader['name']} is not what a compile of its own gives"
        )
    files = len(list((folder / "out").glob("*.vert")))
    faster = single * COUNT / len(chosen) / batch
    print(
        f"{size} bytes of includes, {batch:.2f} s for {COUNT} permutations, {files} files, {memory:.0f} MiB, {faster:.1f} times as fast"
    )
    assert size >= 30000 and files == 100 and memory < 100 and faster >= 5


main()
