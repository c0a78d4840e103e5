#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles the effects of a corpus of your own with --effect, and links what comes out on Mesa.

usage: compile_effects.py CLIPC CLIPC_DRAW LIST [--target glsl330] [-D NAME=VALUE]... [--goal 0.95] [--verbose]

LIST has a line per effect, separated by tabs: path, include folders (a;b), defines (A=1;B). -D gives macros that the applications
of the effects define. Prints how many passes compile, and of the others how many for each cause; a pass that is left out for a
stage that clipc does not have is counted apart from those that fail. For the target vulkan, each pair becomes a pipeline, of which
Vulkan's validation layers must have nothing to say. Exit 1 if fewer of the passes that are not left out compile than the goal says, or a pair does not link.
"""

import argparse
import collections
import json
import pathlib
import re
import subprocess
import sys
import tempfile


def run(*command):
    return subprocess.run(
        [str(word) for word in command],
        capture_output=True,
        text=True,
        errors="replace",
        timeout=300,
        check=False,
    )


def causes(messages):
    """The names of the errors, each with how often it stands there; the words of a pass that is left out."""
    found = collections.Counter()
    for message in re.findall(r" error: (.*)", messages):
        left_out = re.search(r"is left out; its (\w+) is `(.*?)`", message)
        name = re.search(r"\[([\w-]+)[\],]", message)
        if left_out:
            why = re.match(r"\W*(BindInterfaces|ConstructGSWithSO|asm)?", left_out[2])[1]
            found[f"left out: {left_out[1]}" + (f", {why}" if why else "")] += 1
        else:
            found[name[1] if name else message[:60]] += 1
    return found


def kind_of(a_pass):
    if a_pass.get("leftOut"):
        return "left out"
    if not a_pass["programs"]:
        return "without shaders"
    is_compiled = all(program["status"] == "compiled" for program in a_pass["programs"])
    return "compiled" if is_compiled else "failed"


def pairs_in(effect, folder):
    """The files of each pair, once."""
    found = {}
    for technique in effect["techniques"]:
        for a_pass in technique["passes"]:
            for program in a_pass["programs"]:
                files = program["files"]
                if "vertex" in files and "fragment" in files:
                    found[folder / files["vertex"], folder / files["fragment"]] = None
    return list(found)


def link(arguments, pairs):
    """The messages about pairs that do not link."""
    files = [file for pair in pairs for file in pair]
    done = run(arguments.draw, "link", *files)
    return done.stdout.splitlines()[:-1] or [done.stderr] if done.returncode else []


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("clipc")
    parser.add_argument("draw")
    parser.add_argument("list")
    parser.add_argument("--target", default="glsl330")
    parser.add_argument("-D", dest="defines", action="append", default=[])
    parser.add_argument("--goal", type=float, default=0.95)
    parser.add_argument("--verbose", action="store_true", help="name each effect with a failure")
    arguments = parser.parse_args()
    passes, why, problems, linked = collections.Counter(), collections.Counter(), [], 0
    for line in pathlib.Path(arguments.list).read_text().splitlines():
        path, includes, defines = (line.split("\t") + ["", ""])[:3]
        options = [f"-I{folder}" for folder in includes.split(";") if folder]
        options += [f"-D{name}" for name in [*arguments.defines, *defines.split(";")] if name]
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch)
            options.append(f"--target={arguments.target}")
            if arguments.target == "vulkan":
                options.append("-spirv")
            done = run(arguments.clipc, "--effect", path, "-o", folder, *options)
            why.update(causes(done.stderr))
            index = folder / (pathlib.Path(path).stem + ".json")
            if not index.exists():
                passes["in effects that are not read"] += 1
                problems.append(f"{path}: {done.stderr.strip()[:300]}")
                continue
            effect = json.loads(index.read_text())
            kinds = [kind_of(p) for t in effect["techniques"] for p in t["passes"]]
            passes.update(kinds)
            pairs = pairs_in(effect, folder)
            linked += len(pairs)
            refused = link(arguments, pairs) if pairs else []
            problems += refused
            if arguments.verbose and ("failed" in kinds or refused):
                print(f"{path}: {dict(collections.Counter(kinds))} {dict(causes(done.stderr))}")
    for problem in problems:
        print(problem)
    for cause, count in why.most_common():
        print(f"{count:5d}  {cause}")
    tried = passes["compiled"] + passes["failed"] + passes["in effects that are not read"]
    share = passes["compiled"] / tried if tried else 0
    print(
        f"{arguments.target}: {sum(passes.values())} passes: {dict(passes)}; {share:.1%} of the {tried} that are not left out; {linked} pairs, {len(problems)} problems"
    )
    return bool(problems) or share < arguments.goal


if __name__ == "__main__":
    sys.exit(main())
