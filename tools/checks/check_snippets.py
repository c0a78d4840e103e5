#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs the examples of the pages: commands, shaders, and pieces of C, C++, CMake and JSON.

usage: check_snippets.py BUILD_FOLDER SCRATCH_FOLDER C_COMPILER CXX_COMPILER

A page is README.md, CONTRIBUTING.md, in docs/ or in study/. On each,

- a block of `hlsl` is compiled, or after "where `NAME` is" it is the file of that name, and a block of `glsl` is what the `hlsl` before it becomes, to the letter;
- a block of `c`, `cpp` or `cmake`, the N-th block of the page, is put into tools/checks/snippets/PAGE.N.LANGUAGE.in and compiled, or
  configured with an installed clipc;
- a block of `cpp FILE` and the like is a part of that file, but for its indentation; a test of its own builds the file;
- a block of `json` is JSON; a manifest is `shaders.json`, and a reflection is that of the `hlsl` before it;
- a block of `js` is JavaScript, where there is node; the tests `web.*` run what it shows;
- a block of `console`, and a table of options, show what is printed: transcripts.py;
- a command, in a block that is indented or in backticks, is run if it calls clipc or glslangValidator; of other commands the program
  exists, and so do the options and presets that it is given; what each option of `clipc --help` does is shown once at least;
- a row of limits.md that names a constant has its value, the line in a row of pass.md that names a file is in that file, and each input
  in the table of pixel.md matches the output that the page names.

Whatever has no rule is a mistake. tools/checks/snippets/files is the folder in which the commands run.
"""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

import transcripts

ROOT = pathlib.Path(__file__).resolve().parents[2]
SNIPPETS = ROOT / "tools/checks/snippets"
NAMED = re.compile(r"where\s`(\S+)` is\n\n```hlsl\n(.*?)^```$", re.M | re.S)
FENCE = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
EXCERPT = re.compile(r"^```\w+ (\S+)\n(.*?)^```$", re.M | re.S)
INDENTED = re.compile(r"^    (\S.*)$", re.M)
INLINE = re.compile(
    r"`((?:clipc|clipc-draw|glslangValidator|cmake|ctest|cpack|\./\w+|(?:tools|study|examples|packaging)/[^\s`]+) [^`\n]+)`"
)
# Placeholders stand for something else: FILE, [options], and the arguments of functions. Macros and semantics are themselves.
PLACEHOLDER = re.compile(
    r"(?<!-D )(?<!-D ')(?<!-D)\b(?!POSITION)[A-Z][A-Z.]{2,}\b|\[|\.\.\.|`|=$|=\?"
)
# A command that can be run names a file or standard input, or is only a question.
WHOLE = re.compile(r"\w\.\w+$|^-$|^--(?:help|version|explain)$")
# Programs that cannot run here, or that every run of the tests has run.
OPTIONAL = {"clipc-draw", "spirv-cross"}  # run where they are
ELSEWHERE = {
    "cmake",
    "ctest",
    "ninja",
    "cpack",
    "cd",
    "export",
    "vcpkg",
    "conan",
    "bazel",
    "meson",
    "make",
    "scontrol",
}


class Run:
    def __init__(self, build, scratch, compilers):
        self.build, self.scratch, self.compilers = build, scratch, compilers
        self.problems, self.count, self.shown = [], 0, set()
        shutil.rmtree(scratch, ignore_errors=True)
        self.installed = scratch / "installed"
        self.call(
            ["cmake", "--install", build, "--prefix", self.installed], scratch.parent, "installing"
        )
        self.path = f"{self.installed / 'bin'}:{build / 'tools/draw'}:{os.environ['PATH']}"

    def call(self, command, folder, what):
        self.count += 1
        done = subprocess.run(
            [str(word) for word in command],
            cwd=folder,
            capture_output=True,
            text=True,
            check=False,
            timeout=120,
            env=os.environ | {"PATH": getattr(self, "path", os.environ["PATH"])},
            input=(SNIPPETS / "files/water.hlsl").read_text() if "-" in command else "",
        )
        if done.returncode != 0:
            self.problems.append(
                f"{what}: {shlex.join(map(str, command))}: {done.returncode}\n{done.stderr}{done.stdout}"
            )
        return done

    def show(self, words):
        """A page shows what a command with these words prints."""
        self.count += 1
        self.shown |= {"-W" if word.startswith("-W") else word.split("=")[0] for word in words}

    def folder(self, page):
        folder = self.scratch / page.relative_to(ROOT).with_suffix("")
        shutil.copytree(SNIPPETS / "files", folder)
        for name in ("shaders", "build"):
            (folder / name).mkdir()
        self.call(
            [
                "glslangValidator",
                "-D",
                "-V",
                "-S",
                "frag",
                "-e",
                "ps",
                "water.hlsl",
                "-o",
                "water.spv",
            ],
            folder,
            "water.spv",
        )
        return folder


def hoisted(wrapper, snippet):
    """The wrapper with the snippet in it, whose includes come first."""
    includes = "".join(line + "\n" for line in snippet.splitlines() if line.startswith("#include"))
    rest = "".join(line + "\n" for line in snippet.splitlines() if not line.startswith("#include"))
    return includes + wrapper.replace("@SNIPPET@\n", rest)


def check_code(run, page, number, language, text, folder):
    wrapper = SNIPPETS / f"{page.stem}.{number}.{language}.in"
    if not wrapper.exists():
        run.problems.append(f"{page.name}: block {number} has no {wrapper.relative_to(ROOT)}")
        return
    wrapped = wrapper.read_text()
    what = f"{page.name}: block {number}"
    if language == "cmake":
        project = folder / f"project{number}"
        shutil.copytree(SNIPPETS / "files", project)
        (project / "CMakeLists.txt").write_text(wrapped.replace("@SNIPPET@\n", text))
        run.call(
            [
                "cmake",
                "-S",
                project,
                "-B",
                project / "build",
                f"-DCMAKE_PREFIX_PATH={run.installed}",
            ],
            folder,
            what,
        )
        return
    if needs := re.search(r"needs: (\S+)", wrapped):
        compiler = shutil.which("x86_64-w64-mingw32-g++-win32")
        if not compiler:
            print(f"{what}: not compiled, there is no {needs[1]}")
            return
    else:
        compiler = run.compilers[language]
    for name in ("water",):  # as clipc_add_shader() makes them
        vert = run.call(["clipc", f"{name}.hlsl"], folder, what).stdout
        (folder / f"{name}.shader.h").write_text(
            f'inline constexpr char {name}_vert[] = R"({vert})";\n'
        )
        run.call(
            ["clipc", f"{name}.hlsl", "-o", os.devnull, f"--table={name}.clip.h"], folder, what
        )
    for name in re.findall(r'"(\w+)\.effect\.h"', text):  # as clipc_add_effect() makes it
        options = ["--target=glsl330", "-Fh", f"{name}.effect.h"]
        run.call(["clipc", "--effect", f"{name}.fx", *options], folder, what)
    file = folder / f"block{number}.{language}"
    runs = re.search(r"runs: (.*)", wrapped)
    file.write_text(text if runs else hoisted(wrapped, text))
    if runs:
        run_code(run, what, wrapped, file, compiler, runs[1].split())
        return
    standard = "-std=c99" if language == "c" else "-std=c++17"
    run.call(
        [
            compiler,
            standard,
            "-fsyntax-only",
            "-I",
            run.installed / "include",
            "-I",
            folder,
            file,
        ],
        folder,
        what,
    )


def run_code(run, what, wrapped, file, compiler, libraries):
    """Links a whole program of C and runs it without a display. The image that it writes is like one of the page's shaders:
    the wrapper has the colors of its upper left and lower left corners."""
    headers = ["-I", run.installed / "include", "-I", file.parent]
    links = ["-L", run.installed / "lib", *(f"-l{name}" for name in libraries)]
    built = run.call(
        [compiler, "-std=c99", *headers, file, *links, "-lstdc++", "-lm", "-o", "program"],
        file.parent,
        what,
    )
    if built.returncode != 0:
        return
    run.call(["env", "EGL_PLATFORM=surfaceless", "./program"], file.parent, what)
    name, upper, lower = re.search(r"writes: (\S+) (\w+) (\w+)", wrapped).groups()
    image = (file.parent / name).read_bytes() if (file.parent / name).exists() else b""
    size = 64 * 64 * 3
    found = (image[-size:][:3].hex(), image[-64 * 3 :][:3].hex())
    if found != (upper, lower):
        run.problems.append(f"{what}: the corners of {name} are {found}")


def check_json(run, page, text, folder):
    manifest = json.loads(text)
    if "files" in text and "status" in text:
        return  # an index, which clipc writes
    if "clipPlanes" in manifest:
        run.call(
            ["clipc", "water.hlsl", "-o", os.devnull, "--reflect=block.json"], folder, page.name
        )
        if manifest != json.loads((folder / "block.json").read_text()):
            run.problems.append(f"{page.name}: the reflection is another one")
        return
    (folder / "shaders.json").write_text(text)


def check_elsewhere(run, page, words):
    """Checks that the program, presets and options of a command that is not run exist."""
    program = words[0]
    if program in ELSEWHERE:
        presets = re.findall(r'"name": "(\w+)"', (ROOT / "CMakePresets.json").read_text())
        for before, word in zip(words, words[1:]):
            if before == "--preset" and word not in presets:
                run.problems.append(f"{page.name}: there is no preset {word}")
        return
    if program.startswith("build/release/examples/"):
        folder, name = program.removeprefix("build/release/").rsplit("/", 1)
        if f"add_executable({name} " not in (ROOT / folder / "CMakeLists.txt").read_text():
            run.problems.append(f"{page.name}: {folder} builds no {name}")
        return
    tools = {"clipc-study": "study", "clipc-draw": "tools/draw", "clipc-values": "tools/values"}
    if program in tools or program in ("clipc-bench", "clipc-runtime-bench"):
        sources = tools.get(program, "tools/bench")
    elif program == "./run" and words[1:2] == ["study"]:
        sources = "study"
    elif (ROOT / program).exists():
        sources = program
    else:
        run.problems.append(f"{page.name}: there is no {program}")
        return
    files = (
        [ROOT / sources]
        if (ROOT / sources).is_file()
        else [f for f in (ROOT / sources).rglob("*") if f.suffix in {".cpp", ".h", ".py"}]
    )
    text = "".join(file.read_text() for file in files)
    for word in words[1:]:
        if word.startswith("--") and word.split("=")[0] not in text:
            run.problems.append(f"{page.name}: {program} has no option {word}")


def check_command(run, page, line, folder):
    for part in re.split(r"\s+&&\s+", re.split(r"\s{2,}|\s# ", line)[0]):
        try:
            words = shlex.split(part)
        except ValueError as error:
            run.problems.append(f"{page.name}: {part}: {error}")
            continue
        is_whole = not PLACEHOLDER.search(part) and any(WHOLE.search(word) for word in words)
        if words[0] in ("clipc", "glslangValidator") and is_whole:
            # With --watch it would not end.
            run.call([word for word in words if word != "--watch"], folder, page.name)
        elif words[0] in OPTIONAL and is_whole and shutil.which(words[0], path=run.path):
            run.call(words, folder, page.name)
        elif words[0] not in ("clipc", "glslangValidator", "spirv-cross"):
            check_elsewhere(run, page, words)


def check_limits(run, page):
    for value, file, name in re.findall(r"\| (\d+) <!-- (\S+) (\w+) --> \|", page.read_text()):
        text = (ROOT / file).read_text()
        found = re.search(rf"\b{name} = ([^;]+);", text)
        number = re.sub(r"std::size_t\{(\w+)\}", r"\1", found[1]) if found else "None"
        number = re.sub(r"(?<=\d)u\b", "", number)
        if not re.fullmatch(r"[\d <]+", number) or eval(number) != int(
            value
        ):  # of digits and shifts only
            run.problems.append(f"{page.name}: {name} is {number} in {file}, not {value}")
        run.count += 1


def check_lines(run, page):
    for line, rest in re.findall(r"^\| [^|]+ \| `([^`]+)` \| (.*) \|$", page.read_text(), re.M):
        for file in re.findall(r"`([^`]+/[\w.]+)`", rest)[:1]:
            if line.split() not in [
                text.split() for text in (ROOT / file).read_text().splitlines()
            ]:
                run.problems.append(f"{page.name}: {file} has no line `{line}`")
            run.count += 1


def check_excerpts(run, page):
    bare = lambda text: "\n".join(line.strip() for line in text.strip().splitlines())
    for file, excerpt in EXCERPT.findall(page.read_text()):
        if bare(excerpt) not in bare((ROOT / file).read_text()):
            run.problems.append(f"{page.name}: {file} does not have\n{excerpt}")
        run.count += 1


def check_inputs(run, page, folder):
    """Each GLSL input of the table is matched: clipc gives the output the input's name."""
    text = page.read_text()
    output = re.search(r"the output `([^`]+)`", text)[1]
    (folder / "rule.hlsl").write_text(
        f"struct V {{ float4 p : SV_Position; {output}; }};\n"
        "V main(float4 p : POSITION, float2 uv : TEXCOORD0) { V o = {p, uv}; return o; }\n"
    )
    for declaration, name in re.findall(r"`((?:layout\(\S+ = \d\) )?in vec2 (\w+);)`", text):
        version = "450" if "layout" in declaration else "330"
        (folder / "rule.frag").write_text(
            f"#version {version} core\n{declaration}\n{'layout(location = 0) ' if version == '450' else ''}out vec4 color;\n"
            f"void main() {{ color = vec4({name}, 0.0, 1.0); }}\n"
        )
        command = [
            "clipc",
            "rule.hlsl",
            f"--target=glsl{version}",
            "--pixel-shader=rule.frag",
            "-o",
            "-",
        ]
        glsl = run.call(command, folder, f"{page.name}: {declaration}").stdout
        if f"out vec2 {name};" not in glsl:
            run.problems.append(f"{page.name}: `{declaration}` does not match: {glsl}")


def check_page(run, page):
    check_excerpts(run, page)
    text = EXCERPT.sub("", page.read_text())
    folder = run.folder(page)
    glsl, named = "", {block: name for name, block in NAMED.findall(text)}
    for name, block in NAMED.findall(text):
        (folder / name).write_text(block)
    for number, (language, block) in enumerate(FENCE.findall(text), 1):
        if block in named:
            continue
        if language == "hlsl":
            (folder / "water.hlsl").write_text(block)
            glsl = run.call(["clipc", "water.hlsl"], folder, page.name).stdout
        elif language == "glsl":
            if block != glsl:
                run.problems.append(f"{page.name}: the GLSL is\n{glsl}")
        elif language in ("c", "cpp", "cmake"):
            check_code(run, page, number, language, block, folder)
        elif language == "json":
            check_json(run, page, block, folder)
        elif language == "js":
            (folder / f"block{number}.mjs").write_text(block)
            if shutil.which("node"):
                run.call(
                    ["node", "--check", f"block{number}.mjs"],
                    folder,
                    f"{page.name}: block {number}",
                )
        elif language not in ("console", "text"):
            run.problems.append(f"{page.name}: block {number} of `{language}` has no rule")
    prose = FENCE.sub("", text)
    for line in INDENTED.findall(prose) + INLINE.findall(prose):
        check_command(run, page, line, folder)
    transcripts.check_transcripts(run, page, folder)
    if page.name == "limits.md":
        check_limits(run, page)
    if page.name == "pass.md":
        check_lines(run, page)
    if page.name == "pixel.md":
        check_inputs(run, page, folder)


def check_options(run):
    text = run.call(["clipc", "--help"], run.scratch, "the options").stdout
    long = re.findall(r"(?<![\w-])--[a-z][a-z-]+", text)
    short = re.findall(r"^  (-[A-Za-z][\w-]*)", text, re.M)
    for option in sorted({*long, *short}):
        if option not in run.shown:
            run.problems.append(f"no page shows what {option} does")


def main():
    build, scratch = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    scratch.mkdir(parents=True, exist_ok=True)
    run = Run(build, scratch / "work", {"c": sys.argv[3], "cpp": sys.argv[4]})
    for page in [
        ROOT / "README.md",
        ROOT / "CONTRIBUTING.md",
        *sorted((ROOT / "docs").glob("*.md")),
        *sorted((ROOT / "study").glob("*.md")),
    ]:
        check_page(run, page)
    check_options(run)
    print(
        "\n".join(run.problems) or f"{run.count} commands and pieces of code are as the pages say"
    )
    return bool(run.problems)


if __name__ == "__main__":
    sys.exit(main())
