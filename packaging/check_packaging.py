#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds what lies beside the build to what it speaks of: versions, options of CMake, the form of messages.

usage: check_packaging.py CLIPC SCRATCH_FOLDER
"""

import ast
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PACKAGING = ROOT / "packaging"
SHADER = """float4 plane;
[clipplanes(plane, plane)] float4 main(float4 p : POSITION) : SV_Position { return p + unknown; }
"""


def version():
    return re.search(r"project\(clipc VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def recipes():
    """The ports parse, have the project's version, and set only variables that its build has."""
    port = json.loads((PACKAGING / "vcpkg/clipc/vcpkg.json").read_text())
    recipe = (PACKAGING / "conan/conanfile.py").read_text()
    ast.parse(recipe)
    assert port["version"] == version(), port["version"]
    assert re.search(r'version = "(.*)"', recipe)[1] == version()
    text = recipe + (PACKAGING / "vcpkg/clipc/portfile.cmake").read_text()
    build = "".join(file.read_text() for file in (ROOT / "cmake").glob("*.cmake"))
    for name in sorted(set(re.findall(r"CLIPC_\w+", text))):
        assert re.search(rf"(option|set)\({name} ", build), f"the build has no {name}"


def messages(clipc, scratch):
    """The problem matcher finds every message, and SARIF has what code scanning shows."""
    (scratch / "s.hlsl").write_text(SHADER)
    said = subprocess.run(
        [clipc, "s.hlsl", "-o", "-"], cwd=scratch, capture_output=True, text=True, check=False
    ).stderr
    pattern = json.loads((PACKAGING / "ci/clipc-problem-matcher.json").read_text())[
        "problemMatcher"
    ][0]["pattern"][0]
    task = json.loads((PACKAGING / "ci/tasks.json").read_text())["tasks"][0]
    assert task["problemMatcher"]["pattern"] == pattern
    found = [match for line in said.splitlines() if (match := re.match(pattern["regexp"], line))]
    fields = [
        tuple(match[pattern[name]] for name in ("file", "line", "severity", "code"))
        for match in found
    ]
    assert ("s.hlsl", "2", "error", "undeclared-name, X3004") in fields, said
    assert len(fields) == len(re.findall(r": (?:error|warning): ", said)), (fields, said)

    sarif = subprocess.run(
        [clipc, "s.hlsl", "--diagnostics=sarif", "-fsyntax-only"],
        cwd=scratch,
        capture_output=True,
        text=True,
        check=False,
    ).stderr
    run = json.loads(sarif)["runs"][0]
    assert run["tool"]["driver"]["name"] == "clipc"
    result = run["results"][0]
    place = result["locations"][0]["physicalLocation"]
    assert result["ruleId"] and result["level"] and result["message"]["text"]
    assert place["artifactLocation"]["uri"] == "s.hlsl" and place["region"]["startLine"] == 2


def workflows():
    """The commands of the workflows that are this repository's are there."""
    for file in sorted((ROOT / ".github/workflows").glob("*.yml")):
        commands = re.findall(r"^ *- run: (\S+)", file.read_text(), re.M)
        for command in commands:
            if command.startswith(("./", ".ci/", "packaging/")):
                assert (ROOT / command).is_file(), f"{file.name}: there is no {command}"
        assert commands, file


def main():
    clipc, scratch = sys.argv[1], pathlib.Path(sys.argv[2])
    scratch.mkdir(parents=True, exist_ok=True)
    recipes()
    workflows()
    messages(clipc, scratch)
    print("the recipes and the messages fit")


if __name__ == "__main__":
    main()
