# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs clipc with every line of a list, and says which do not do what the list says: command_lines.py CLIPC LIST FOLDER."""

import concurrent.futures
import pathlib
import shlex
import shutil
import subprocess
import sys

FILES = {
    "s.hlsl": """#include "planes.hlsli"
#ifndef SHIFT
#define SHIFT 0
#endif
#ifdef BROKEN
not HLSL
#endif
[clipplanes(left, right)]
float4 main(float4 p : POSITION) : SV_Position {
  float4 shifted = p + SHIFT;
  return shifted;
}
[clipplanes(left)]
float4 vs(float4 p : POSITION) : SV_Position { return p + SHIFT; }
float4 plain(float4 p : POSITION) : POSITION { return p; }
float4 unclipped(float4 p : POSITION) : SV_Position { return p; }
[maxvertexcount(1)] void points(point float4 p[1] : SV_Position, inout PointStream<float4> s : SV_Position) { s.Append(p[0]); }
[domain("tri")] float4 tess(const OutputPatch<float4, 3> p : POSITION, float3 at : SV_DomainLocation) : SV_Position { return p[0] * at.x; }
float4 pixel(float4 p : SV_Position) : SV_Target { return p; }
Texture2D image : register(t0);
SamplerState linear_sampler : register(s0);
StructuredBuffer<float4> rows : register(t1);
RWTexture2D<float4> drawn : register(u1);
float4 stored() : SV_Target { return drawn[uint2(0, 0)] = rows[0]; }
float4 textured(float2 uv : TEXCOORD0) : SV_Target { return image.Sample(linear_sampler, uv); }
""",
    "p.frag.hlsl": "float4 main(float2 uv : TEXCOORD0) : SV_Target { return uv.xyxy; }",
    "c.comp.hlsl": "RWBuffer<uint> b; [numthreads(8, 1, 1)] void group(uint i : SV_GroupIndex) { b[i] = i; }",
    "planes.hlsli": "cbuffer planes { float4 left, right; };\n",
    "shift.hlsli": "#define SHIFT 2\n",
    "profile.rsp": '-T vs_4_0\n-D  "SHIFT=2"\n',
    "nested.rsp": "@profile.rsp",
    "loop.rsp": "@loop.rsp",
}


class Line:
    def __init__(self, clipc, number, line, folder):
        self.clipc, self.number, self.line = str(pathlib.Path(clipc).resolve()), number, line
        verdict, arguments, self.expected = (part.strip() for part in line.split("|"))
        self.verdict = verdict
        self.arguments = shlex.split(arguments)
        self.folder = folder / str(number)

    def run(self, arguments, with_file=True):
        """(exit code, standard output, standard error, the files that were written)"""
        if self.folder.exists():
            shutil.rmtree(self.folder)
        for name in ("inc", "out", "pdb"):
            (self.folder / name).mkdir(parents=True)
        for name, text in FILES.items():
            (self.folder / name).write_text(text)
        if with_file and not any(argument.endswith(".hlsl") for argument in arguments):
            arguments = ["s.hlsl"] + arguments
        done = subprocess.run(
            [self.clipc] + arguments,
            cwd=self.folder,
            input=FILES["s.hlsl"],
            capture_output=True,
            text=True,
            errors="replace",
        )
        written = {
            str(file.relative_to(self.folder)) for file in self.folder.rglob("*") if file.is_file()
        } - set(FILES)
        return done.returncode, done.stdout, done.stderr, written

    def problem(self):
        """What is wrong; None if nothing is."""
        with_file = self.verdict not in ("help", "stdin") and "-P s.hlsl" not in self.line
        code, out, err, written = self.run(self.arguments, with_file)
        said = f"exit code {code}, said {err!r}, wrote {sorted(written)}"
        if self.verdict == "refused":
            return None if code in (1, 2) and self.expected in err and not written else said
        if code != 0:
            return said
        if self.verdict == "like":
            same = self.run(shlex.split(self.expected))
            return (
                None
                if (code, out, err) == same[:3] and not err and out
                else f"{said}; not like {same[2]!r}"
            )
        if self.verdict == "writes":
            names, _, words = self.expected.partition(": ")
            missing = set(names.split()) - written
            last = self.folder / names.split()[-1]
            return said if missing or err or words not in last.read_text(errors="replace") else None
        holds = {
            "warns": lambda: self.expected in err and "warning: " in err,
            "says": lambda: self.expected in err,
            "prints": lambda: self.expected in out and not err,
            "nothing": lambda: not (out or err or written),
            "stdin": lambda: out.startswith("#version") and not err,
            "help": lambda: self.expected in out and not err,
        }
        return None if holds[self.verdict]() else said + f", printed {out[:200]!r}"


def main():
    clipc, listed, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    lines = [
        Line(clipc, number, line, folder)
        for number, line in enumerate(listed.read_text().splitlines(), 1)
        if line and not line.startswith("#")
    ]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        failures = [
            (line, problem)
            for line, problem in zip(lines, pool.map(Line.problem, lines))
            if problem
        ]
    for line, problem in failures:
        print(f"{listed}:{line.number}: {line.line}\n  {problem}")
    refused = sum(line.verdict == "refused" for line in lines)
    print(
        f"{len(lines) - refused} command lines with effect, {refused} refused, {len(failures)} fail"
    )
    return 1 if failures else 0


sys.exit(main())
