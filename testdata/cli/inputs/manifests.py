# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs clipc on manifests with one mistake each, and prints what it says of them.

usage: manifests.py CLIPC FOLDER
"""

import json
import pathlib
import subprocess
import sys


def shaders(**members):
    return {"version": 1, "shaders": [members]}


MISTAKES = {
    "cut": '{"version": 1,',
    "list": [],
    "version": {"shaders": [{"source": "a.hlsl"}]},
    "empty": {"version": 1, "shaders": []},
    "member": shaders(source="a.hlsl", defnies={}),
    "source": shaders(entry="main"),
    "stdin": shaders(source="-"),
    "name": shaders(source=["a.hlsl", "b.hlsl"], name="a"),
    "folder": shaders(source="a.hlsl", name="../a"),
    "value": shaders(source="a.hlsl", defines={"A": [[1]]}),
    "novalue": shaders(source="a.hlsl", defines={"A": []}),
    "macro": shaders(source="a.hlsl", defines={"A=1": 1}),
    "option": shaders(source="a.hlsl", options=["--flipy"]),
    "input": shaders(source="a.hlsl", options=["b.hlsl"]),
    "run": shaders(source="a.hlsl", options=["-o", "elsewhere"]),
    "text": shaders(source="a.hlsl", options=[1]),
    "variants": shaders(source="a.hlsl", variants=-1),
    "choice": shaders(source="a.hlsl", target=[]),
    "deep": "[" * 1000000,
}

clipc, folder = sys.argv[1], pathlib.Path(sys.argv[2])


def run(name, *more):
    words = [clipc, f"--batch={name}.json", "-o", "out", *more]
    result = subprocess.run(
        words, cwd=folder, capture_output=True, text=True, check=False, timeout=60
    )
    assert result.returncode == 2, (name, result.returncode)
    return result.stderr.strip()


for mistake, manifest in MISTAKES.items():
    (folder / f"{mistake}.json").write_text(
        manifest if isinstance(manifest, str) else json.dumps(manifest)
    )
    print(f"{mistake}: {run(mistake)}")
print(f"absent: {run('absent')}")
print(f"both: {run('list', 'a.hlsl')}")
