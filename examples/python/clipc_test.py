# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles shaders by clipc.py: what comes out, an include from memory, and the errors."""

import clipc

SHADER = """#include "planes.hlsli"
[clipplanes(water)] float4 main(float4 p : POSITION) : SV_Position { return p; }
"""
FILES = {"shaders/planes.hlsli": "cbuffer Clip : register(b3) { float4 other, water; };"}


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
    print("clipc.py: passed")


main()
