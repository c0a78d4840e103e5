#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Builds the shaders of examples/builds with each build system that is installed, outside the tree: once, again without a change, and
after an include has changed. MSBuild is in no package, so its files are only read.

usage: check_builds.py BUILD_FOLDER SCRATCH_FOLDER
"""

import hashlib
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import xml.etree.ElementTree

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]


class Builds:
    def __init__(self, build, scratch):
        shutil.rmtree(scratch, ignore_errors=True)
        scratch.mkdir(parents=True)
        self.scratch, self.installed = scratch, scratch / "installed"
        self.environment = os.environ | {
            "PATH": f"{self.installed / 'bin'}:{os.environ['PATH']}",
            "PKG_CONFIG_PATH": str(self.installed / "lib/pkgconfig"),
        }
        self.run(["cmake", "--install", build, "--prefix", self.installed], scratch)

    def run(self, command, folder, fails=False):
        done = subprocess.run(
            [str(word) for word in command],
            cwd=folder,
            env=self.environment,
            capture_output=True,
            text=True,
            check=False,
            timeout=300,
        )
        said = done.stdout + done.stderr
        if (done.returncode != 0) != fails:
            sys.exit(f"{shlex.join(map(str, command))}: {done.returncode}\n{said}")
        return said

    def folder(self, name):
        folder = self.scratch / name
        shutil.copytree(HERE / name, folder)
        shutil.copytree(HERE / "shaders", folder, dirs_exist_ok=True)
        return folder


def change(folder):
    """Moves the plane by 16 bytes."""
    include = folder / "planes.hlsli"
    include.write_text(include.read_text().replace("float4 water", "float4 other, water"))


def expect(condition, what):
    if not condition:
        sys.exit(f"expected: {what}")


def has_distances(hlsl, spirv):
    """Checks the pass: clipc's HLSL, and another compiler's SPIR-V, which says that an output is ClipDistance."""
    expect(": SV_ClipDistance0" in hlsl.read_text(), f"clip distances in {hlsl.name}")
    words = memoryview(spirv.read_bytes()).cast("I").tolist()
    expect((11, 3) in zip(words, words[1:]), f"BuiltIn ClipDistance in {spirv.name}")


def make(builds):
    folder = builds.folder("make")
    builds.run(["make"], folder)
    table = folder / "build/water.clip.h"
    has_distances(folder / "build/water.hlsl", folder / "build/water.spv")
    expect('0u, 0u, "' in table.read_text(), "the plane at byte 0")
    expect("clipc" not in builds.run(["make"], folder), "nothing to do")
    change(folder)
    said = builds.run(["make"], folder)
    expect("clipc -T" in said and "clipc --target=hlsl" in said, "the shader again")
    expect("glslangValidator" in said, "the other compiler again")
    expect('1u, 16u, "' in table.read_text(), "the plane at byte 16")


def meson(builds):
    folder = builds.folder("meson")
    builds.run(["meson", "setup", "build"], folder)
    builds.run(["ninja", "-C", "build"], folder)
    expect("byte 0" in builds.run(["build/application"], folder), "the plane at byte 0")
    has_distances(folder / "build/water.clipped.hlsl", folder / "build/water.spv")
    expect("no work to do" in builds.run(["ninja", "-C", "build"], folder), "nothing to do")
    written = [folder / "build" / name for name in ("water.spv", "water.clipped.hlsl")]
    before = [file.stat().st_mtime_ns for file in written]
    change(folder)
    builds.run(["ninja", "-C", "build"], folder)
    after = [file.stat().st_mtime_ns for file in written]
    expect(all(map(int.__lt__, before, after)), "the pass and the other compiler again")
    expect("byte 16" in builds.run(["build/application"], folder), "the plane at byte 16")


def check_permutations(builds, folder):
    """Checks that the folder of three parts has the index of one run, and the files that it names."""
    (folder / "single").mkdir()
    permutations = ["-D", "FOG={0,1}", "-D", "WAVES={0,1,2,3}"]
    builds.run(
        ["clipc", "-T", "vs_5_0", "-I.", *permutations, "water.hlsl", "-o", "single"], folder
    )
    merged = folder / "bazel-bin/permutations"
    for file in (folder / "single").iterdir():
        expect((merged / file.name).read_bytes() == file.read_bytes(), f"{file.name} of one run")
    expect(not list(merged.glob("index.*-of-*")), "one index")


def bazel(builds):
    """Checks that two sandboxes give the same bytes, and that files that are not declared are missing there."""
    found = []
    for number in (1, 2):
        folder = builds.folder("bazel").rename(builds.scratch / f"bazel{number}")
        shutil.copytree(ROOT / "packaging/bazel", folder / "bazel")
        shutil.copytree(builds.installed, folder / "installed")
        start = ["bazel", f"--output_user_root={builds.scratch}/bazel_root{number}", "--batch"]
        options = ["--spawn_strategy=sandboxed", "--curses=no"]
        builds.run(
            [*start, "build", *options, "//:water", "//:water_spv", "//:permutations"], folder
        )
        has_distances(folder / "bazel-bin/water_clipped.hlsl", folder / "bazel-bin/water.spv")
        outputs = [
            folder / "bazel-bin" / f"water.{kind}" for kind in ("vert", "shader.h", "clip.h")
        ]
        found.append([hashlib.sha256(file.read_bytes()).hexdigest() for file in outputs])
        check_permutations(builds, folder)
        said = builds.run([*start, "build", *options, "//:undeclared"], folder, fails=True)
        expect("planes.hlsli" in said, f"a missing include, not\n{said}")
    expect(found[0] == found[1], "the same bytes in two sandboxes")
    for number in (1, 2):  # Bazel makes its folders read-only
        subprocess.run(["chmod", "-R", "u+w", builds.scratch / f"bazel_root{number}"], check=False)


def fastbuild(builds):
    """Runs the command line of FASTBuild as it is, since FASTBuild is not in Debian."""
    folder = builds.folder("fastbuild")
    (folder / "build").mkdir()
    text = (folder / "fbuild.bff").read_text()
    lines = (
        re.findall(rf"\.{name}\s*= '(.*)'", text)
        for name in ("ExecExecutable", "ExecArguments", "ExecOutput")
    )
    for program, arguments, output in zip(*lines):
        builds.run([program, *shlex.split(arguments)], folder)
        expect((folder / output).exists(), output)
    has_distances(folder / "build/water.hlsl", folder / "build/water.spv")


# What MSBuild and the FxCompile of Visual C++ know, by their references.
ELEMENTS = "Project PropertyGroup ItemDefinitionGroup ItemGroup Target MakeDir Exec FxCompile"
METADATA = (
    "FullPath RootDir Directory Filename Extension ShaderType ShaderModel EntryPointName "
    "PreprocessorDefinitions AdditionalIncludeDirectories ExcludedFromBuild"
)


def expand(text, values):
    """What MSBuild makes of a text: metadata, properties, and the one function that the files call."""
    text = re.sub(r"%\((?:\w+\.)?(\w+)\)", lambda name: values[name[1]], text)
    text = re.sub(
        r"\$\(\[System\.String\]::Copy\('(.*?)'\)\.Replace\('(.*?)', '(.*?)'\)\)",
        lambda call: call[1].replace(call[2], call[3]),
        text,
    )
    return re.sub(r"\$\((\w+)\)", lambda name: values[name[1]], text)


def msbuild(builds):
    """Reads MSBuild's files: what they name is there, and the command that they make writes the HLSL."""
    folder = builds.folder("msbuild")
    (folder / "obj/clipc").mkdir(parents=True)
    trees = [xml.etree.ElementTree.parse(folder / f"clipc.{kind}") for kind in ("props", "targets")]
    elements = [element for tree in trees for element in tree.iter()]
    space = "{http://schemas.microsoft.com/developer/msbuild/2003}"
    names = {element.tag.removeprefix(space) for element in elements}
    own = {name for name in names if name.startswith("Clipc")}
    expect(names - own <= {*ELEMENTS.split(), *METADATA.split()}, f"known elements, not {names}")
    texts = [
        text for element in elements for text in (element.text or "", *element.attrib.values())
    ]
    used = {name for text in texts for name in re.findall(r"%\((?:\w+\.)?(\w+)\)", text)}
    expect(used <= own | set(METADATA.split()), f"known metadata, not {used}")
    targets = [element.attrib for element in elements if element.tag == space + "Target"]
    named = {target.get("DependsOnTargets") for target in targets} - {None}
    expect(named < {target["Name"] for target in targets}, f"targets that are there, not {named}")
    values = dict.fromkeys(own, "") | {
        "IntDir": "obj/",
        "FullPath": "water.hlsl",
        "RootDir": "",
        "Directory": "",
        "Filename": "water",
        "Extension": ".hlsl",
        "ShaderModel": "5.0",
        "EntryPointName": "main",
        "PreprocessorDefinitions": "A=1;B",
        "AdditionalIncludeDirectories": "one two;three",
    }
    for element in elements:
        if element.tag.startswith(space + "Clipc") and element.text and element.text.strip():
            values[element.tag.removeprefix(space)] = expand(element.text, values).replace(
                "\\", "/"
            )
    command = next(element for element in elements if element.tag == space + "Exec").get("Command")
    words = shlex.split(expand(command, values))
    expect(words[0] == "clipc.exe", f"clipc.exe, not {words}")
    expect(
        {"-D", "A=1", "B", "one two/.", "three/."} < set(words), f"macros and folders in {words}"
    )
    builds.run(["clipc", *words[1:]], folder)
    expect("SV_ClipDistance" in (folder / "obj/clipc/water.hlsl").read_text(), "clip distances")


def main():
    builds = Builds(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
    for tool, check in (
        ("make", make),
        ("meson", meson),
        ("bazel", bazel),
        ("clipc", fastbuild),
        ("clipc", msbuild),
    ):
        if shutil.which(tool, path=builds.environment["PATH"]):
            check(builds)
            print(f"{check.__name__}: passed")
        else:
            print(f"{check.__name__}: not run, there is no {tool}")
    shutil.rmtree(builds.scratch)


if __name__ == "__main__":
    main()
