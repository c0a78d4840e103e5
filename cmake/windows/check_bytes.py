#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles every shader below testdata/ and examples/ with two builds of clipc, for each of eight targets, and with the other
lowerings and variants where a shader has clip planes. Fails unless both write the same files, messages and exit code.

usage: check_bytes.py NATIVE OTHER FOLDER
"""

import filecmp
import json
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools/checks"))
import hash_outputs  # noqa: E402

TARGETS = ["glsl120", "glsl330", "glsl450", "essl100", "essl300", "essl310", "webgl2", "vulkan"]
LOWERINGS = ["level9", "near-plane", "discard", "none"]


def shader(name, path, options):
    """The entry of a manifest for a shader that a command line compiles with these options."""
    known = {"name": name, "source": path, "defines": {}, "options": []}
    words = iter(options)
    for word in words:
        value = word[2:] or next(words, "") if word[:2] in ("-T", "-E", "-D", "-I") else ""
        if word.startswith("-T"):
            known["profile"] = value
        elif word.startswith("-E"):
            known["entry"] = value
        elif word.startswith("-D"):
            macro, _, text = value.partition("=")
            known["defines"][macro] = text or "1"
        else:
            known["options"] += [word[:2], value] if value else [word]
    return {member: value for member, value in known.items() if value}


def manifest():
    shaders = []
    for number, (_, path, options) in enumerate(hash_outputs.shaders(ROOT, None)):
        name = f"{number:03d}-{pathlib.Path(path).stem}"
        known = shader(name, path, [option for word in options for option in word.split()])
        shaders.append(known | {"target": TARGETS})
        if "clipplanes" in (ROOT / path).read_text(errors="replace"):
            for lowering in LOWERINGS:
                more = {
                    "name": f"{name}-{lowering}",
                    "options": known.get("options", [])
                    + [f"--lower={lowering}", "--plane-space=xyw1"],
                }
                shaders.append(known | more)
            shaders.append(known | {"name": f"{name}-variants", "variants": True})
    return {"version": 1, "shaders": shaders}


def run(clipc, batch, folder):
    folder.mkdir()
    words = [
        clipc,
        f"--batch={batch}",
        "-k",
        "--table=.json",
        "--reflect=.reflect.json",
        "-o",
        str(folder),
    ]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, check=False, timeout=900)
    return done.returncode, done.stdout, done.stderr.replace(str(folder).encode(), b"OUT")


def main():
    native, other, scratch = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    batch = scratch / "batch.json"
    batch.write_text(json.dumps(manifest(), indent=1))
    said = [
        run(clipc, batch, scratch / name) for name, clipc in (("native", native), ("other", other))
    ]
    names = sorted(
        {
            file.name
            for folder in ("native", "other")
            for file in (scratch / folder).iterdir()
            if file.suffix != ".part"  # the times of what was read
        }
    )
    _, different, missing = filecmp.cmpfiles(
        scratch / "native", scratch / "other", names, shallow=False
    )
    for name in different + missing:
        print(f"{name} differs")
    for what, one, two in zip(("exit codes", "standard outputs", "messages"), *said):
        if one != two:
            different.append(what)
            print(f"{what} differ")
            (scratch / "native.txt").write_bytes(said[0][2])
            (scratch / "other.txt").write_bytes(said[1][2])
    last = said[0][2].decode(errors="replace").splitlines()[-1:]
    print(
        f"{len(names)} files compared, {len(different) + len(missing)} different; the native program's last line is {last}"
    )
    return bool(different or missing) or len(names) < 1000


if __name__ == "__main__":
    sys.exit(main())
