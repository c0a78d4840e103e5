#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Builds the shaders of examples/builds with each build system that is installed, outside the tree: once, again without a change, and
after an include has changed.

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


def make(builds):
    folder = builds.folder("make")
    builds.run(["make"], folder)
    table = folder / "build/water.clip.h"
    expect('0u, 0u, "' in table.read_text(), "the plane at byte 0")
    expect("clipc" not in builds.run(["make"], folder), "nothing to do")
    change(folder)
    expect("clipc" in builds.run(["make"], folder), "the shader again")
    expect('1u, 16u, "' in table.read_text(), "the plane at byte 16")


def meson(builds):
    folder = builds.folder("meson")
    builds.run(["meson", "setup", "build"], folder)
    builds.run(["ninja", "-C", "build"], folder)
    expect("byte 0" in builds.run(["build/application"], folder), "the plane at byte 0")
    expect("no work to do" in builds.run(["ninja", "-C", "build"], folder), "nothing to do")
    change(folder)
    builds.run(["ninja", "-C", "build"], folder)
    expect("byte 16" in builds.run(["build/application"], folder), "the plane at byte 16")


def bazel(builds):
    """Checks that two sandboxes give the same bytes, and that files that are not declared are missing there."""
    found = []
    for number in (1, 2):
        folder = builds.folder("bazel").rename(builds.scratch / f"bazel{number}")
        shutil.copytree(ROOT / "bazel", folder / "bazel")
        shutil.copytree(builds.installed, folder / "installed")
        start = ["bazel", f"--output_user_root={builds.scratch}/bazel_root{number}", "--batch"]
        options = ["--spawn_strategy=sandboxed", "--curses=no"]
        builds.run([*start, "build", *options, "//:water"], folder)
        outputs = [
            folder / "bazel-bin" / f"water.{kind}" for kind in ("vert", "shader.h", "clip.h")
        ]
        found.append([hashlib.sha256(file.read_bytes()).hexdigest() for file in outputs])
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
    builds.run(["clipc", *shlex.split(re.search(r"\.ExecArguments\s*= '(.*)'", text)[1])], folder)
    expect((folder / re.search(r"\.ExecOutput\s*= '(.*)'", text)[1]).exists(), "the output")


def main():
    builds = Builds(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve())
    for tool, check in (("make", make), ("meson", meson), ("bazel", bazel), ("clipc", fastbuild)):
        if shutil.which(tool, path=builds.environment["PATH"]):
            check(builds)
            print(f"{check.__name__}: passed")
        else:
            print(f"{check.__name__}: not run, there is no {tool}")
    shutil.rmtree(builds.scratch)


if __name__ == "__main__":
    main()
