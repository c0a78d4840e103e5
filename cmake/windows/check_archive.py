#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes the .zip of a Windows build, unpacks it, runs the program and builds with the libraries of it.

usage: check_archive.py CPACK BUILD_FOLDER WINE_SCRIPT C_COMPILER
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LICENCES = ("libclang", "llvm", "glslang", "libfmt", "nlohmann-json3", "g++-mingw-w64", "mingw-w64")


def run(*command, **more):
    done = subprocess.run(
        [str(word) for word in command],
        capture_output=True,
        text=True,
        check=False,
        timeout=200,
        **more,
    )
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    cpack, build, wine, compiler = sys.argv[1:]
    build = pathlib.Path(build)
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        run(cpack, "-G", "ZIP", "-B", scratch, cwd=build)
        (archive,) = scratch.glob("clipc-*.zip")
        with zipfile.ZipFile(archive) as file:
            file.extractall(scratch)
        folder = scratch / archive.stem
        linked = [path.name for path in (folder / "share/doc/clipc/linked").iterdir()]
        missing = [name for name in LICENCES if not any(there.startswith(name) for there in linked)]
        if missing or not (folder / "share/doc/clipc/LICENSE").exists():
            sys.exit(f"no licence of {missing or 'clipc'} among {linked}")

        def under_wine(program, *arguments):
            return run(wine, build / "wine", program, *arguments, cwd=scratch)

        # The program is copied out of the build's reach, in a folder with a space, a name that is not ASCII, and backslashes.
        program = scratch / "a place" / "clipc.exe"
        program.parent.mkdir()
        shutil.copy(folder / "bin/clipc.exe", program)
        shutil.copy(ROOT / "examples/clipplanes.hlsl", scratch / "wäsche.hlsl")
        under_wine(
            program,
            "wäsche.hlsl",
            "-T",
            "vs_5_0",
            "-E",
            "main",
            "-o",
            "a place\\wäsche.vert",
            "--table=.json",
        )
        if "gl_ClipDistance" not in (scratch / "a place/wäsche.vert").read_text():
            sys.exit("the shader has lost its planes")
        # The work of an application: compiles a shader by the DLL, and asks the runtime about its table.
        shutil.copy(folder / "bin/clipc.dll", scratch)
        for import_library in ("libclipc.dll.a", "clipc.lib"):
            run(
                compiler,
                "-std=c99",
                ROOT / "cmake/outside_c_project/main.c",
                "-o",
                scratch / "use.exe",
                f"-I{folder / 'include'}",
                f"-L{folder / 'lib'}",
                folder / "lib" / import_library,
                "-lclipc_runtime",
                "-lclipc_clip_table",
                "-static",
                "-lstdc++",
                "-lm",
            )
            said = under_wine(scratch / "use.exe")
            if "plane water: byte 16 of b3, lowering 0" not in said:
                sys.exit(f"the library says {said}")
        print(f"{archive.name}: {archive.stat().st_size} bytes")


if __name__ == "__main__":
    sys.exit(main())
