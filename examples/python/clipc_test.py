# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles shaders and an effect by clipc.py: what comes out, includes from memory, and the errors."""

import clipc

SHADER = """#include "planes.hlsli"
[clipplanes(water)] float4 main(float4 p : POSITION) : SV_Position { return p; }
"""
FILES = {"shaders/planes.hlsli": "cbuffer Clip : register(b3) { float4 other, water; };"}

EFFECT = """#include "lights.fxh"
float4 VS(float4 p : POSITION) : POSITION { return mul(p, World); }
float4 PS() : COLOR { return Tint; }
technique Draw { pass P { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS(); CullMode = None; } }
technique Wrong { pass P { PixelShader = compile ps_3_0 VS(); } }
"""
LIGHTS = {"lights.fxh": "float4x4 World; float4 Tint = {1, 0, 0, 1};"}


def test_effect(compiler):
    options = ["--effect", "--target=glsl330"]
    result = compiler.compile(EFFECT, "water.fx", [*options, "--technique=Draw"], LIGHTS.get)
    assert result.ok, result.messages
    program = result.effect["techniques"][0]["passes"][0]["programs"][0]
    assert "gl_Position = " in program["glsl"] and "Tint" in program["pixel"], program
    assert program["reflection"]["cbuffers"][0]["members"][0]["name"] == "World", program
    assert result.dependencies == ["lights.fxh"]

    assert [each["text"] for each in program["code"]] == [program["glsl"], program["pixel"]]

    result = compiler.compile(EFFECT, "water.fx", options, LIGHTS.get)
    assert result.status == "has-errors", result.status
    good, bad = (each["passes"][0]["programs"][0] for each in result.effect["techniques"])
    assert good["glsl"] and not bad["glsl"] and bad["status"] == "failed", bad


PROGRAM = """struct V { float4 p : SV_Position; };
V vs(float4 p : POSITION) { V v = {p}; return v; }
[maxvertexcount(1)] void gs(point V v[1], inout PointStream<V> s) { s.Append(v[0]); }
float4 ps() : SV_Target { return 1; }
"""


def test_stages(compiler):
    options = ["-E", "vs", "--geometry-entry=gs", "--geometry-output=.geom"]
    options += ["--pixel-entry=ps", "--pixel-output=.frag", "-spirv"]
    result = compiler.compile(PROGRAM, options=options)
    assert result.ok, result.messages
    assert [each["stage"] for each in result.shaders] == ["vertex", "geometry", "pixel"]
    assert "EmitVertex()" in result.shaders[1]["text"], result.shaders
    assert result.shaders[2] == {
        "stage": "pixel",
        "text": result.pixel,
        "spirv": result.pixel_spirv,
    }


def main():
    compiler = clipc.Compiler()

    def compile_it(*options):
        return compiler.compile(SHADER, "shaders/water.hlsl", options, FILES.get)

    result = compile_it("-T", "vs_5_0")
    assert result.ok, result.messages
    assert "gl_ClipDistance[0] = dot(" in result.glsl
    assert result.table["planes"][0]["constant"]["byte_offset"] == 16
    plane = result.reflection["clipPlanes"][0]
    assert (plane["register"], plane["offset"]) == ("b3", 16), plane
    assert result.dependencies == ["shaders/planes.hlsli"]
    spirv = compile_it("-spirv").spirv
    assert spirv[:4] == (0x07230203).to_bytes(4, "little"), spirv[:4]
    assert ": SV_ClipDistance0" in compile_it("--target=hlsl").hlsl

    result = compiler.compile(SHADER, "shaders/water.hlsl")  # the include is not on the disk
    assert result.status == "has-errors" and not result.glsl
    assert result.diagnostics[0]["name"] == "missing-include", result.diagnostics
    result = compile_it("--bogus")
    assert result.status == "bad-request", result.status
    assert result.diagnostics[0]["message"].startswith("unknown option `--bogus`")
    test_effect(compiler)
    test_stages(compiler)
    print("clipc.py: passed")


main()
