#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Counts the shaders of a corpus whose GLSL has a form that nobody would write by hand.

    count_forms.py CLIPC --list LIST [--tree FOLDER] [--target TARGET] [--show FORM] [-j N]

LIST is as for hash_outputs.py: path, entry, profile, include folders and defines, separated by tabs. A shader that does not
compile is not counted. --show prints the shaders that have a form, with the first line that shows it.
"""

import argparse
import concurrent.futures
import pathlib
import re
import subprocess

import hash_outputs

LITERAL = r"(?:true|false|-?\d+u?|-?\d+\.\d*)"
FORMS = {
    "rows": r"^ +u?vec4 \w+_rows\[\d+\];",
    "large": None,  # blocks of more than 16 KB, which OpenGL does not promise
    "constant": rf"\bif \((?:!*{LITERAL}|{LITERAL} [=!<>]=? {LITERAL})\)|\b(?:true|false) \?",
    "unnamed": r"\bUnnamed(?:_\d+)?\b",
    "draw": r"GL_ARB_shader_draw_parameters",
    "narrowed": r"\* mat[34]x[234]\([^;]*\)\)\.(?:xyz?|x)\b",
    "repeated": r"\b(?:in|vs)_(?P<name>\w+?)(?:_\d+)?;  // (?P=name)$",
}
BLOCK = re.compile(r"\n[^\n]*\buniform \w+ \{[^\n]*\n(.*?)\n\}", re.S)
MEMBER = re.compile(r"(?:offset = (\d+).*?)?\b(u?vec4|mat4) \w+\[(\d+)\];")
ROWS = {"vec4": 1, "uvec4": 1, "mat4": 4}
SIZE = 16384


def large(text):
    """The arrays of the first block whose arrays alone take more than 16 KB; none otherwise."""
    for block in BLOCK.finditer(text):
        arrays = MEMBER.findall(block[1])
        end = sum(ROWS[kind] * int(count) * 16 for _, kind, count in arrays)
        offsets = [int(found) for found in re.findall(r"offset = (\d+)", block[1])]
        if max([end, *offsets]) > SIZE:
            return block[1].strip().splitlines()[-1]
    return None


def forms(text):
    """The forms that the GLSL has, each with the line that shows it."""
    found = {}
    for form, pattern in FORMS.items():
        if pattern is None:
            line = large(text)
        else:
            at = re.search(pattern, text, re.M)
            line = at and text[text.rfind("\n", 0, at.start()) + 1 :].split("\n", 1)[0]
        if line:
            found[form] = line.strip()
    return found


def compiled(clipc, tree, target, path, options):
    command = [clipc, path, *options, "--target=" + target, "-o", "-"]
    done = subprocess.run(command, cwd=tree, capture_output=True, timeout=60)
    return None if done.returncode else forms(done.stdout.decode(errors="replace"))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("clipc", type=pathlib.Path)
    parser.add_argument("--list", type=pathlib.Path, required=True)
    parser.add_argument("--tree", type=pathlib.Path, default=pathlib.Path())
    parser.add_argument("--target", default="glsl450")
    parser.add_argument("--show", choices=list(FORMS))
    parser.add_argument("-j", type=int, default=2)
    given = parser.parse_args()
    clipc, tree = given.clipc.resolve(), given.tree.resolve()
    work = list(hash_outputs.listed(given.list))
    with concurrent.futures.ThreadPoolExecutor(given.j) as pool:
        results = list(pool.map(lambda item: compiled(clipc, tree, given.target, *item[1:]), work))
    for (name, _, _), found in zip(work, results):
        if given.show and found and given.show in found:
            print(f"{name}\t{found[given.show]}")
    written = [found for found in results if found is not None]
    print(f"{'shaders':10} {len(written)} of {len(work)}")
    for form in FORMS:
        print(f"{form:10} {sum(form in found for found in written)}")


if __name__ == "__main__":
    main()
