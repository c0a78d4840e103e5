# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Calls things in HLSL by every word of GLSL, and lets glslang read what becomes of them.

    every_name.py CLIPC VALIDATOR WORDS FOLDER

The words are the keywords, layout words and functions that WORDS, backend-glsl/reserved_words.cpp,
lists, and all built-in names of VALIDATOR, which is glslangValidator: so a function that the list
lacks is found. A shader has all words in one kind of place; clipc writes it for every target.
"""

import json
import pathlib
import re
import subprocess
import sys

TARGETS = """glsl120 glsl130 glsl140 glsl150 glsl330 glsl400 glsl410 glsl420 glsl430 glsl440 glsl450
glsl460 essl100 essl300 essl310 essl320 webgl1 webgl2 vulkan""".split()
BUFFERS = "glsl430 glsl440 glsl450 glsl460 essl310 essl320 vulkan".split()
BUILTINS = ["110", "450", "460", "100", "320 es"]

# The words of both languages that are no names in HLSL, and `main`, which is the entry's.
HLSL = set(
    """bool break case class column_major const continue default discard do double else enum extern
    false float float16_t float32_t float64_t for half if in inline inout int int16_t int32_t int64_t
    interface main namespace nointerpolation noperspective out return row_major sizeof static struct
    switch template true typedef uint uint16_t uint32_t uint64_t uniform unsigned using void volatile
    while""".split()
)
MOST_INPUTS = 120  # beside which clipc takes a position
ENTRY = "float4 main(S s) : SV_Position { return f(s); }\n"
OUTPUT = """struct O {{
{}  float4 position : SV_Position;
}};
O main(float4 p : POSITION) {{
  O o;
{}  o.position = p;
  return o;
}}
"""
MAIN = "float4 main(float4 p : POSITION) : SV_Position {{\n  float4 r = p;\n{}  return r;\n}}\n"


def words(validator, listed, folder):
    """The words of the list and of the validator, in order."""
    found = set()
    for block in re.findall(r'R"\((.*?)\)"', pathlib.Path(listed).read_text(), re.S):
        found.update(block.split())
    for version in BUILTINS:
        shader = folder / "builtins.vert"
        shader.write_text(f"#version {version}\nvoid main() {{}}\n")
        dump = subprocess.run(
            [validator, "--dump-builtin-symbols", shader], capture_output=True, text=True
        )
        found.update(re.findall(r"^(\w+):", dump.stdout, re.M))
    return sorted(word for word in found if word not in HLSL)


def each(pattern, names):
    """The pattern for each name, with its number for {i}."""
    return "".join(pattern.format(w=name, i=i) for i, name in enumerate(names))


def shader(names, outside="", inside="", around="{}"):
    """A shader with two patterns for each name: outside of functions, within `around`, and in the entry function."""
    return around.format(each(outside, names)) + MAIN.format(each(inside, names))


def fields(names, semantic=""):
    """A struct with fields of these names, and a function that reads them."""
    read = "float4 f(S s) {{\n  float4 r = 0;\n{}  return r;\n}}\n"
    declared = "struct S {{\n{}}};\n".format(each("  float4 {w}" + semantic + ";\n", names))
    return declared + read.format(each("  r += s.{w};\n", names))


def places(names):
    """The shaders, each by the kind of place that it has the words in."""
    buffer = "cbuffer C {{\n{}}}\n"
    yield "member", shader(names, "  float4 {w};\n", "  r += {w};\n", buffer)
    use = "  {{ {w} s = {{ r }}; r += s.v; }}\n"
    yield "struct", shader(names, "struct {w} {{ float4 v; }};\n", use)
    yield "field", fields(names) + MAIN.format("  r += f((S)0);\n")
    of_parameter = "float4 f{i}(float4 {w}) {{ return {w} * {w}; }}\n"
    yield "parameter", shader(names, of_parameter, "  r += f{i}(r);\n")
    yield "variable", shader(names, "", "  {{ float4 {w} = r.yxwz; {w} *= {w}; r += {w}; }}\n")
    yield "static", shader(names, "static float4 {w};\n", "  {w} += r; r += {w}.y;\n")
    yield (
        "function",
        shader(names, "float4 {w}(float4 x) {{ return x * x; }}\n", "  r += {w}(r);\n"),
    )
    method = "  float4 {w}() {{ return v * v; }}\n"
    of_methods = "struct S {{\n  float4 v;\n{}}};\nstatic S s;\n"
    yield "method", shader(names, method, "  s.v += r; r += s.{w}();\n", of_methods)
    yield "block", shader(names, "cbuffer {w} {{ float4 m{i}; }}\n", "  r += m{i};\n")
    sample = "  r += {w}.SampleLevel(s, r.xy, 0);\n"
    yield "texture", shader(names, "Texture2D {w};\n", sample, "SamplerState s;\n{}")
    sample = "  r += t.SampleLevel({w}, r.xy, 0);\n"
    yield "sampler", shader(names, "SamplerState {w};\n", sample, "Texture2D t;\n{}")
    yield "buffer", shader(names, "StructuredBuffer<float4> {w};\n", "  r += {w}[0];\n")
    for i in range(0, len(names), MOST_INPUTS):
        part = names[i : i + MOST_INPUTS]
        yield f"input{i}", fields(part, " : I{i}") + ENTRY
        outputs = each("  float4 {w} : O{i};\n", part)
        yield f"output{i}", OUTPUT.format(outputs, each("  o.{w} = p;\n", part))


def main():
    clipc, validator, listed, folder = sys.argv[1:]
    folder = pathlib.Path(folder)
    (folder / "out").mkdir(parents=True, exist_ok=True)
    shaders = []
    for name, text in places(words(validator, listed, folder)):
        (folder / f"{name}.hlsl").write_text(text)
        options = ["--names={name}"] if name.startswith("output") else []
        targets = BUFFERS if name == "buffer" else TARGETS
        shaders.append({"source": f"{name}.hlsl", "target": targets, "options": options})
        if name == "member":
            plain = {
                "name": "plain",
                "target": ["glsl450", "essl300"],
                "options": ["--blocks=plain"],
            }
            shaders.append({"source": f"{name}.hlsl", **plain})
    manifest = {"version": 1, "shaders": shaders}
    (folder / "names.json").write_text(json.dumps(manifest))
    command = [clipc, "--batch=names.json", "-T", "vs_5_1", "-o", "out", "--validate", "-k", "-j1"]
    sys.exit(subprocess.run(command, cwd=folder).returncode)


if __name__ == "__main__":
    main()
