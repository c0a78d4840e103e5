# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws a vertex shader of clipc's with the pixel shader of other tools.

    pair.py --clipc FILE --draw FILE [options] SHADER.hlsl WORK

SHADER.hlsl has the entry points `vs` and `ps`. glslang and SPIRV-Cross translate both; clipc translates `vs` to fit `ps`, given
as HLSL, as SPIR-V or as SPIRV-Cross's GLSL. Its picture, with SPIRV-Cross's pixel shader, must be that of their own two halves in
a GLSL whose halves meet by location: by name, these two do not. glslang numbers a pixel shader's inputs by itself: where they are not those of `vs` in their order, --peer names a vertex
shader that writes just what `ps` reads. WORK begins the names of the files that are made.

    --targets A,B     of clipc, default glsl450,glsl330,essl310,essl300
    --forms A,B       of the pixel shader, default glsl,spirv,hlsl; hlsl where the GLSL has locations, for names are not HLSL's
    --spoil OLD=NEW   replaces this in clipc's GLSL, where it must be, and expects another picture or a program that does not link
"""
import argparse
import pathlib
import subprocess
import sys

CROSS = {"glsl450": ["--version", "450"], "glsl330": ["--version", "330", "--no-420pack-extension"],
         "essl310": ["--version", "310", "--es"], "essl300": ["--version", "300", "--es"]}
WITH_LOCATIONS = ("glsl450", "essl310")
PEER_OF = {"glsl450": "glsl450", "glsl330": "glsl450", "essl310": "essl310", "essl300": "essl310"}


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(str(word) for word in command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--clipc", required=True)
    parser.add_argument("--draw", required=True)
    parser.add_argument("--targets", default=",".join(CROSS))
    parser.add_argument("--forms", default="glsl,spirv,hlsl")
    parser.add_argument("--peer", default="vs")
    parser.add_argument("--spoil")
    parser.add_argument("shader")
    parser.add_argument("work")
    given = parser.parse_args()
    spirv = {}
    for entry, stage in ((given.peer, "vert"), ("ps", "frag")):
        spirv[entry] = f"{given.work}.{entry}.spv"
        run("glslangValidator", "-D", "-V", "-S", stage, "-e", entry, given.shader, "-o", spirv[entry])
    drawn = 0
    for target in given.targets.split(","):
        fragment = pathlib.Path(f"{given.work}.{target}.frag")
        fragment.write_text(run("spirv-cross", spirv["ps"], *CROSS[target]))
        peer = [pathlib.Path(f"{given.work}.{target}.peer.{stage}") for stage in ("vert", "frag")]
        for path, entry in zip(peer, (given.peer, "ps")):
            path.write_text(run("spirv-cross", spirv[entry], *CROSS[PEER_OF[target]]))
        forms = {"glsl": [f"--pixel-shader={fragment}"], "spirv": [f"--pixel-shader={spirv['ps']}"],
                 "hlsl": [f"--pixel-shader={given.shader}", "--pixel-entry=ps"]}
        for form in given.forms.split(","):
            if form == "hlsl" and target not in WITH_LOCATIONS:
                continue
            mine = pathlib.Path(f"{given.work}.{target}.{form}.vert")
            run(given.clipc, "-w", "-T", "vs_5_0", "-E", "vs", f"--target={target}", *forms[form], given.shader, "-o", mine)
            if given.spoil:
                old, new = given.spoil.split("=", 1)
                text = mine.read_text()
                if old not in text:
                    sys.exit(f"{mine} has no `{old}`")
                mine.write_text(text.replace(old, new))
            done = subprocess.run([given.draw, "pair", mine, fragment, *peer], capture_output=True, text=True, check=False)
            if (done.returncode != 0) != bool(given.spoil):
                sys.exit(f"{target}, pixel shader as {form}: {done.stdout}{done.stderr}")
            drawn += 1
    print(f"{drawn} pairs drawn")


if __name__ == "__main__":
    main()
