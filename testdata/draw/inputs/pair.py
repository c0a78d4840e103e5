# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws a vertex shader of clipc's with the pixel shader of other tools, and with clipc's own.

    pair.py --clipc FILE --draw FILE [options] SHADER.hlsl WORK

SHADER.hlsl has the entry points `vs` and `ps`. glslang and SPIRV-Cross translate both; clipc translates `vs` to fit `ps`, given
as HLSL, as SPIR-V or as SPIRV-Cross's GLSL, or both at once as a pair. Its image, with SPIRV-Cross's pixel shader, must be that of their own two halves in
a GLSL whose halves match by location: by name, these two do not. On Vulkan clipc writes SPIR-V, the pixel shader is glslang's or is
made of SPIRV-Cross's GLSL for Vulkan, and any message of the validation layers is a failure. glslang numbers a pixel shader's inputs
by itself: where they are not those of `vs` in their order, --reference names a vertex shader that writes just what `ps` reads. WORK begins
the names of the files that are made.

    --targets A,B     of clipc, default glsl450,glsl330,essl310,essl300,vulkan
    --forms A,B       of the pixel shader, default glsl,spirv,hlsl,pair; hlsl where the GLSL has locations, for names are not
                      HLSL's; pair is clipc's own two halves, which are not spoiled
    --spoil OLD=>NEW  replaces this in clipc's GLSL, where it must be (`\\n` is the end of a line), and expects another image,
                      a program that does not link, or a message. What comes of it must still be a shader to glslang
"""

import argparse
import pathlib
import subprocess
import sys

CROSS = {
    "glsl450": ["--version", "450"],
    "glsl330": ["--version", "330", "--no-420pack-extension"],
    "essl310": ["--version", "310", "--es"],
    "essl300": ["--version", "300", "--es"],
}
WITH_LOCATIONS = ("glsl450", "essl310", "vulkan")
# clipc's numbers for Vulkan, where textures and samplers share them with constant buffers.
SHIFTS = ["--shift-sampler-binding", "16", "--shift-texture-binding", "32"]
REFERENCE_OF = {
    "glsl450": "glsl450",
    "glsl330": "glsl450",
    "essl310": "essl310",
    "essl300": "essl310",
}


def run(*command):
    done = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, check=False
    )
    if done.returncode:
        sys.exit(f"{' '.join(str(word) for word in command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def translate(shader, entry, stage, spirv, *options):
    run("glslangValidator", "-D", "-V", "-S", stage, "-e", entry, *options, shader, "-o", spirv)
    return spirv


class Halves:
    """What one target draws: a pixel shader, the reference compilers' two halves, and clipc's vertex shader for each form of the pixel shader."""

    def __init__(self, given, target):
        self.given = given
        self.target = target
        self.is_vulkan = target == "vulkan"
        stem = f"{given.work}.{target}"
        shifts = SHIFTS if self.is_vulkan else []
        self.spirv = translate(given.shader, "ps", "frag", f"{stem}.ps.spv", *shifts)
        vertex = translate(
            given.shader, given.reference, "vert", f"{stem}.{given.reference}.spv", *shifts
        )
        self.glsl = pathlib.Path(f"{stem}.frag")
        if self.is_vulkan:
            self.glsl.write_text(
                run("spirv-cross", self.spirv, "--version", "450", "--vulkan-semantics")
            )
            run("glslangValidator", "-V", self.glsl, "-o", f"{stem}.frag.spv")
            self.reference = [vertex, self.spirv]
        else:
            self.glsl.write_text(run("spirv-cross", self.spirv, *CROSS[target]))
            self.reference = [f"{stem}.reference.vert", f"{stem}.reference.frag"]
            for path, half in zip(self.reference, (vertex, self.spirv)):
                pathlib.Path(path).write_text(
                    run("spirv-cross", half, *CROSS[REFERENCE_OF[target]])
                )

    def fragment(self, form):
        if form == "pair":
            return f"{self.given.work}.{self.target}.pair.frag" + (".spv" if self.is_vulkan else "")
        if not self.is_vulkan:
            return self.glsl
        return f"{self.glsl}.spv" if form == "glsl" else self.spirv

    def mine(self, form):
        """Compiles clipc's half, and spoils it if that is asked for."""
        given = self.given
        options = {
            "glsl": [f"--pixel-shader={self.glsl}"],
            "spirv": [f"--pixel-shader={self.spirv}"],
            "hlsl": [f"--pixel-shader={given.shader}", "--pixel-entry=ps"],
            # Blocks are fed by their names.
            "pair": [
                "--pixel-entry=ps",
                f"--pixel-output={self.fragment('pair')}",
                "--names=spirv-cross",
            ],
        }[form]
        path = pathlib.Path(f"{given.work}.{self.target}.{form}.vert")
        command = [
            given.clipc,
            "-w",
            "-T",
            "vs_5_0",
            "-E",
            "vs",
            f"--target={self.target}",
            *options,
            given.shader,
            "-o",
        ]
        if self.is_vulkan and not given.spoil:
            run(*command, f"{path}.spv")
            return f"{path}.spv"
        run(*command, path)
        if given.spoil:
            old, new = given.spoil.replace("\\n", "\n").split("=>", 1)
            text = path.read_text()
            if old not in text:
                sys.exit(f"{path} has no `{old}`")
            path.write_text(text.replace(old, new))
            run("glslangValidator", path, *(["-V", "-o", f"{path}.spv"] if self.is_vulkan else []))
        return f"{path}.spv" if self.is_vulkan else path


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--clipc", required=True)
    parser.add_argument("--draw", required=True)
    parser.add_argument("--targets", default=",".join([*CROSS, "vulkan"]))
    parser.add_argument("--forms", default="glsl,spirv,hlsl,pair")
    parser.add_argument("--reference", default="vs")
    parser.add_argument("--spoil")
    parser.add_argument("shader")
    parser.add_argument("work")
    given = parser.parse_args()
    answers = {}  # by what the files have: the same halves are drawn once, whatever form led to them
    fitted = 0
    for target in given.targets.split(","):
        halves = Halves(given, target)
        for form in given.forms.split(","):
            if form == "hlsl" and target not in WITH_LOCATIONS:
                continue
            if form == "pair" and given.spoil:
                continue
            files = [halves.mine(form), halves.fragment(form), *halves.reference]
            texts = tuple(pathlib.Path(path).read_bytes() for path in files)
            if texts not in answers:
                answers[texts] = subprocess.run(
                    [given.draw, "pair", *files], capture_output=True, text=True, check=False
                )
            done = answers[texts]
            if (done.returncode != 0) != bool(given.spoil):
                sys.exit(f"{target}, pixel shader as {form}: {done.stdout}{done.stderr}")
            fitted += 1
    print(f"{fitted} pairs, {len(answers)} drawn")


if __name__ == "__main__":
    main()
