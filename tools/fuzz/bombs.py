#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles shaders of a few kilobytes that name things many times over, level by level, so that code that walks them anew at each
name takes years or all memory. Each one must end, with GLSL or with an error.

    bombs.py CLIPC [NAME...]
"""

import os
import resource
import subprocess
import sys
import tempfile

SECONDS = 20  # of processor time a compile; each takes some milliseconds
BYTES = 2 << 30  # of memory; all but `casts` and `loads` take some 10 MiB
LEVELS = 12
NAMES = 40  # of the level before, at each level

BUFFER = "cbuffer C { float4x4 m; float4 q; float4 p[64]; };\n"
LEVEL9 = ["-T", "vs_4_0_level_9_1", "--table", "{folder}/table.json"]
TEMPLATES = ["-T", "vs_6_0", "-HV", "2021"]


def main(body, parameters=""):
    return f"float4 main(float4 v : POSITION, int4 w : W{parameters}) : SV_Position {{ {body} }}\n"


def levels(first, rest, count=LEVELS):
    """`first`, and `rest` for each level after it: {i} is its number and {b} that of the level before."""
    return first + "".join(
        rest.replace("{i}", str(i)).replace("{b}", str(i - 1)) for i in range(1, count)
    )


def times(text, separator="+", count=NAMES):
    return separator.join([text] * count)


def nested(opening, innermost, closing, depth=100):
    return opening * depth + innermost + closing * depth


def struct_levels(field, fields):
    return levels(
        f"struct S0 {{ float a{field}; }};\n", f"struct S{{i}} {{ S{{b}} {fields}; }};\n", 10
    )


def permuted(i):
    """A function of eight textures that calls the one before with the textures in eight other orders."""
    parameters = ",".join(f"Texture2D a{k}" for k in range(8))
    if i == 0:
        body = "a0.SampleLevel(s, u, 0)"
    else:
        order = [[(k * (2 * r + 1) + r * i * k * k + r) % 8 for k in range(8)] for r in range(8)]
        body = "+".join(f"f{i - 1}({','.join(f'a{k}' for k in row)}, u)" for row in order)
    return f"float4 f{i}({parameters}, float2 u) {{ return {body}; }}\n"


SIX = "a, b, c, d, e, f"
BOMBS = {
    "functions": (
        levels(
            "float f0(float x) { return x; }\n",
            f"float f{{i}}(float x) {{ return {times('f{b}(x)')}; }}\n",
        )
        + main("return v * f11(v.x);"),
        [],
    ),
    "functions-level9": (
        levels(
            "float f0(int x) { return p[x].x; }\n",
            f"float f{{i}}(int x) {{ return {times('f{b}(x)')}; }}\n",
        )
        + main("return v * f11(3);"),
        LEVEL9,
    ),
    "a-chain-of-functions": (
        levels(
            "float f0(float x) { return x; }\n", "float f{i}(float x) { return f{b}(x); }\n", 20000
        )
        + main("return v * f19999(v.x);"),
        [],
    ),
    "statements": (
        levels(
            "static float g; void f0() { g += 1; }\n",
            f"void f{{i}}() {{ {times('f{b}();', '')} }}\n",
        )
        + main("f11(); return v * g;"),
        [],
    ),
    "templates": (
        levels(
            "template<typename T> T f0(T x) { return x; }\n",
            f"template<typename T> T f{{i}}(T x) {{ return {times('f{b}<T>(x)')}; }}\n",
        )
        + main("return f11<float4>(v);"),
        TEMPLATES,
    ),
    "template-types": (
        "template<typename T> struct P { T a, b, c, d; };\n"
        + main(nested("P<", "float", "> ", 12) + "x; return v;"),
        TEMPLATES,
    ),
    "textures": (
        "Texture2D t[8]; SamplerState s;\n"
        + "".join(permuted(i) for i in range(LEVELS))
        + main(f"return f11({','.join(f't[{k}]' for k in range(8))}, v.xy);"),
        [],
    ),
    "loads": (
        "typedef float Big[1 << 20];\nByteAddressBuffer g;\n"
        + main(f"return v + {times('g.Load<Big>(w.x)[w.y]')};"),
        ["-T", "vs_6_2"],
    ),
    "casts": (
        levels("struct S0 { float x; };\n", "struct S{i} { S{b} a, b; };\n", 13)
        + "struct T { float v[4096]; };\nvoid f(S12 s) {}\n"
        + main("T t = (T)0; " + "f((S12)t); " * 10000 + "return v;"),
        [],
    ),
    "statics": (
        levels("static float a0 = q.x;\n", f"static float a{{i}} = {times('a{b}')};\n")
        + main("a3 += 1; return v * a11;"),
        [],
    ),
    "constants": (
        levels("static const float a0 = 1;\n", f"static const float a{{i}} = {times('a{b}')};\n")
        + main("return v * a11 + int(a4 * v.x) + w[int(a4) & 3];"),
        [],
    ),
    "constants-converted": (
        levels(
            "static const float a0 = 1;\n",
            f"static const float a{{i}} = {times('a{b}', '+', 400)};\n",
            5,
        )
        + main(f"return v * int({times('a4', '+', 400)});"),
        [],
    ),
    "constant-arrays": (
        levels(
            "static const float a0[2] = { 1, 2 };\n",
            f"static const float a{{i}}[2] = {{ {times('a{b}[0]')}, {times('a{b}[1]')} }};\n",
        )
        + main("return v * a11[w.x & 1];"),
        [],
    ),
    "structs": (
        struct_levels("", SIX)
        + main("S9 s = (S9)v.x; S9 t = s; return v * t.a.a.a.a.a.a.a.a.a.a;"),
        [],
    ),
    "structs-in-buffer": (
        struct_levels("", SIX)
        + "cbuffer D { S9 s; };\n"
        + main("return v * s.a.a.a.a.a.a.a.a.a.a;"),
        [],
    ),
    "structs-as-output": (
        struct_levels(" : A", SIX) + main("o = (S9)0; return v;", ", out S9 o : B"),
        [],
    ),
    "structs-many": (
        levels("struct S0 { float a; };\n", f"struct S{{i}} {{ S{{b}} {SIX}; }};\n", 7)
        + "".join(f"static S6 s{k} = (S6)0;\n" for k in range(300))
        + main(f"return v * ({'+'.join(f's{k}.a.a.a.a.a.a.a' for k in range(300))});"),
        [],
    ),
    "arrays-of-structs": (
        struct_levels("[8]", "a[8]")
        + main(f"S9 s = (S9)0; s{'.a[w.x]' * 10} = v.x; return v * s{'.a[1]' * 10};"),
        [],
    ),
    "arrays": (
        levels("typedef float T0[8];\n", "typedef T{b} T{i}[8];\n")
        + main("T11 t = (T11)0; return v;"),
        [],
    ),
    "loops-level9": (
        main(
            "float4 s = 0; "
            + "".join(f"[unroll] for (int i{k} = 0; i{k} < 50; ++i{k}) " for k in range(8))
            + "s += p[i7]; return s;"
        ),
        LEVEL9,
    ),
    "offsets-of-a-chain": (
        "Texture2D t; SamplerState s;\n"
        + main(
            levels("const int a0 = 1; ", "const int a{i} = a{b}; ", 60000)
            + "return v * t.SampleLevel(s, v.xy, 0, int2(a59999, 0)).x;"
        ),
        [],
    ),
    "offsets-of-a-table": (
        "Texture2D t; SamplerState s;\n"
        + main(
            f"const int a[1024] = {{ {times('1', ',', 1024)} }}; "
            + f"{times('v *= t.SampleLevel(s, v.xy, 0, int2(a[3], a[5])).x;', ' ', 4000)} return v;"
        ),
        [],
    ),
    "offsets-of-parameters": (
        "Texture2D t; SamplerState s;\n"
        + levels(
            "float f0(int x) { return t.SampleLevel(s, p[0].xy, 0, int2(x & 7, 0)).x; }\n",
            "float f{i}(int x) { return f{b}(2 * x) + f{b}(2 * x + 1); }\n",
            20,
        )
        + main("return v * f19(1);"),
        [],
    ),
    "indices-that-differ": (
        "Texture2D t[8]; SamplerState s;\n"
        + main(
            "int a0 = 0; "
            + "".join(f"int a{k} = 0; " for k in range(1, 60000))
            + "".join(f"a{k} = a{k + 1}; " for k in range(59999))
            + "a59999 = NonUniformResourceIndex(w.x); "
            + "return v * t[a0].SampleLevel(s, v.xy, 0).x;"
        ),
        ["-T", "vs_5_1"],
    ),
    "choices": (main(f"return v * ({nested('v.x > 1 ? v.y : ', '1', '', 200)});"), []),
    "choices-with-steps": (
        main(
            f"float s, c; return v * ({nested('v.x > 1 ? (sincos(v.x, s, c), s) + (', '1', ') : 3', 60)});"
        ),
        [],
    ),
    "choices-of-matrices": (main(f"return mul(v, {nested('(m > 1 ? m + 1 : ', 'm', ')')});"), []),
    "conversions": (main(f"return v * {nested('float(int(', 'v.x', ' + 1))')};"), []),
    "divisions": (main(f"return v * {nested('(', 'w.x', ' / w.y % w.z)')};"), []),
    "indices": (main(f"int4 a = w; return v * {nested('a[', '0', ']', 200)};"), []),
    "written-elements": (
        main(
            f"float4x4 a = m; {times('a[w.x][w.y] = a[w[a[1][2]]][w.z];', ' ', 400)} return mul(v, a);"
        ),
        [],
    ),
    "written-arguments": (
        "float f(inout float4x4 a, inout float4 b) { a[1] += b; b.xy = a[0].xy; return b.x; }\n"
        + main(f"float4x4 a = m; float4 b = v; return v * ({times('f(a, b)', '+', 400)});"),
        [],
    ),
    "written-arguments-nested": (
        "float f(float x, inout float a) { a += x; return a; }\n"
        + main(f"float4 b = v; return v * {nested('f(', '1', ', b.x)')};"),
        [],
    ),
    "methods": (
        "struct S { float a; float f(float x) { a += x; return a; } };\n"
        + main(f"S s; s.a = 0; return v * {nested('s.f(', '1', ')')};"),
        [],
    ),
    "overloads": (
        "".join(
            f"float f(float{a} x, float{b} y, int{c} z) {{ return 1; }}\n"
            for a in range(1, 5)
            for b in range(1, 5)
            for c in range(1, 5)
        )
        + main(f"return v * ({times('f(v, v, w)', '+', 300)});"),
        [],
    ),
    "logic": (main(f"return v * {nested('(v.x > 1 && v.y++ > 2 || ', 'true', ')')};"), []),
    "logic-of-vectors": (main(f"return v * {nested('(v > 1 && v > 2 || ', 'true', ')')};"), []),
    "switches": (
        main(
            f"float r = 0; {nested('switch (w.x) { case 1: r += 1; ', '', ' break; }', 60)} return v * r;"
        ),
        [],
    ),
    "precise": (
        levels(
            "precise static float a0 = 1;\n" + main("precise float4 r0 = v; ")[:-3],
            "precise float4 r{i} = r{b} * r{b}; ",
            1000,
        )
        + "return r999; }\n",
        [],
    ),
    "lists": (
        main(
            f"float4x4 a[64] = {nested('{', times('v', ', ', 256), '}')}; return v * a[w.x & 63][0];"
        ),
        [],
    ),
}


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))


def mistake(clipc, name, target, folder):
    text, options = BOMBS[name]
    path = os.path.join(folder, f"{name}.hlsl")
    with open(path, "w", encoding="ascii") as file:
        file.write(BUFFER + text)
    profile = [] if "-T" in options else ["-T", "vs_5_0"]
    options = [option.replace("{folder}", folder) for option in options]
    command = [
        clipc,
        *profile,
        *options,
        "-E",
        "main",
        f"--target={target}",
        path,
        "-o",
        os.devnull,
        "--reflect",
        f"{folder}/reflection.json",
    ]
    done = subprocess.run(
        command, capture_output=True, text=True, errors="replace", preexec_fn=limit, check=False
    )
    if done.returncode not in (0, 1):
        return f"exit code {done.returncode}\n{done.stderr[-400:]}"
    if done.returncode == 1 and "error: " not in done.stderr:
        return "failed without an error"
    return None


def run(clipc, names):
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        for name in names or BOMBS:
            for target in ("glsl450", "essl100", "essl300"):
                if what := mistake(clipc, name, target, folder):
                    failures += 1
                    print(f"{name}, {target}: {what}")
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024
    if peak > BYTES:
        failures += 1
        print(f"one compile took {peak >> 20} MiB")
    if not failures:
        print(f"{len(names or BOMBS)} shaders, at most {peak >> 20} MiB")
    return failures != 0


if __name__ == "__main__":
    sys.exit(run(sys.argv[1], sys.argv[2:]))
