# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Texts that ask for macros in every way that the preprocessor has, at random: what a run over all permutations says of one
must be what a preprocessing of that permutation alone says.

usage: macro_uses.py CLIPC FOLDER
"""

import json
import pathlib
import random
import subprocess
import sys

NAMES = ["A", "B", "C"]
VALUES = ["0", "1", "B", "x"]
clipc, folder = sys.argv[1], pathlib.Path(sys.argv[2])


def lines(rng, depth=0):
    for _ in range(rng.randrange(1, 5)):
        name = rng.choice(NAMES)
        kind = rng.randrange(13 if depth < 2 else 9)
        yield from (
            [
                [f"word {name} end"],
                ["no macro here"],
                [f"#undef {name}"],
                [f"#undef {name}", f"#define {name} {rng.choice(VALUES)}"],
                [f"#define PASTE_{depth}(x) x##{name} {name}", f"PASTE_{depth}({name})"],
                [f"#define LATER_{depth} {name}"],
                [f"LATER_{depth} LATER_{depth + 1}"],
                [f"#define TEXT_{depth}(x) #x", f"TEXT_{depth}({name})"],
                [f'#pragma push_macro("{name}")', f'#pragma pop_macro("{name}")'],
            ][kind]
            if kind < 9
            else []
        )
        if kind < 9:
            continue
        condition = [
            f"#ifdef {name}",
            f"#ifndef {name}",
            f"#if defined({name}) || {rng.choice(NAMES)} == 1",
            f"#if {name} == {rng.randrange(3)}",
        ][kind - 9]
        yield condition
        yield from lines(rng, depth + 1)
        yield rng.choice(
            ["#else", f"#elif defined {rng.choice(NAMES)}", f"#elifdef {rng.choice(NAMES)}"]
        )
        yield from lines(rng, depth + 1)
        yield "#endif"


def preprocess(*words):
    result = subprocess.run(
        [clipc, "--no-validate", *words], cwd=folder, capture_output=True, text=True, check=False
    )
    assert result.returncode in (0, 1), result
    return result.returncode


def main():
    shared = 0
    for seed in range(24):
        rng = random.Random(seed)
        text = list(lines(rng))
        (folder / "text.hlsl").write_text("\n".join([f"seed {seed}", *text]) + "\n")
        # One of the macros is not defined in some permutations.
        manifest = {
            "version": 1,
            "shaders": [
                {
                    "source": "text.hlsl",
                    "defines": {"A": [0, 1, "B"], "B": [None, 0, 1], "C": ["x", 1]},
                }
            ],
        }
        (folder / "batch.json").write_text(json.dumps(manifest))
        out = folder / f"out{seed}"
        out.mkdir()
        preprocess("--batch=batch.json", "-k", "-P", ".i", "-o", out.name)
        shaders = json.loads((out / "index.json").read_text())["shaders"]
        assert len(shaders) == 18
        for shader in shaders:
            defines = [
                f"-D{name}={value}"
                for name, value in shader["defines"].items()
                if value is not None
            ]
            code = preprocess(*defines, "text.hlsl", "-P", "alone.i")
            where = f"seed {seed}, {defines}"
            assert (code == 0) == (shader["status"] == "compiled"), where
            if code == 0:
                assert (out / shader["files"]["preprocessed"]).read_text() == (
                    folder / "alone.i"
                ).read_text(), where
        shared += 18 - len(list(out.glob("*.i")))
    assert shared > 24, shared
    print(f"{shared} permutations share their files")


main()
