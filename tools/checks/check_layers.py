# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails when a lower room includes a higher one, or a room includes a library that is not its business."""

import os
import pathlib
import re
import sys
import tempfile

# A room is a folder, with the folders below it that are not rooms themselves, or a single file. A room may include itself and
# these. From the bottom to the top, as in the top-level CMakeLists.txt.
VOCABULARY = "clip-table/vocabulary.h"
LIBRARY = "compiler/clipc.hpp"  # what an application sees of the compiler
# The headers of the runtime and the clip table are installed below include/clipc, and include each other by the way from one to
# the other: an application's own runtime/status.h cannot stand for clipc's.
INSTALLED = re.compile(
    r"(runtime|effect-runtime|clip-table)/(?!test_|json).*\.h|compiler/clipc(_effect\.h|\.hpp)"
)
COMPILER = {
    "compiler",
    "compiler/compile",
    "compiler/command",
    "compiler/batch",
    "compiler/effect",
    "compiler/library",
}
ROOMS = {
    VOCABULARY: set(),
    LIBRARY: {"compiler"},
    "base": set(),
    "ir": {"base", VOCABULARY},
    "frontend/lex": {"base"},
    "frontend/parse": {"base", "frontend/lex"},
    "frontend/typing": {"base", "ir"},
    "frontend/signature": {"base", "ir"},
    "frontend/rules": {"base", "ir", "frontend/typing"},
    "frontend/resolve": {"base", "ir", "frontend/typing", "frontend/rules"},
    "frontend/check": {
        "base",
        "ir",
        "frontend/lex",
        "frontend/parse",
        "frontend/typing",
        "frontend/signature",
        "frontend/rules",
        "frontend/resolve",
        VOCABULARY,
    },
    "passes": {"base", "ir", VOCABULARY},
    "legalize": {"base", "ir"},
    "backend-glsl": {"base", "ir", "legalize"},
    "backend-spirv": {"base", "ir", "legalize"},
    "clip-table": {VOCABULARY},
    "link": {"base", "ir", "frontend/signature"},
    "rewrite": {
        "base",
        "ir",
        "frontend/lex",
        "frontend/check",
        VOCABULARY,
    },
    "compiler/compile": {
        "link",
        "rewrite",
        "base",
        "ir",
        "frontend/lex",
        "frontend/parse",
        "frontend/signature",
        "frontend/resolve",
        "frontend/check",
        "passes",
        "legalize",
        "backend-glsl",
        "backend-spirv",
        "clip-table",
        VOCABULARY,
    },
    "compiler/command": {
        "base",
        "ir",
        "frontend/lex",
        "backend-glsl",
        "clip-table",
        "compiler/compile",
        VOCABULARY,
    },
    "compiler/batch": {
        "base",
        "frontend/lex",
        "compiler/compile",
        "compiler/command",
        VOCABULARY,
    },
    "compiler/effect": {
        "base",
        "ir",
        "frontend/parse",
        "compiler/compile",
        "compiler/command",
        "compiler/batch",
    },
    "compiler/library": {
        "base",
        "clip-table",
        "compiler",
        "compiler/compile",
        "compiler/command",
        "compiler/effect",
    },
    "compiler": {
        "base",
        "ir",
        "frontend/lex",
        "compiler/compile",
        "compiler/command",
        "compiler/batch",
        "compiler/effect",
    },
    "runtime": {"clip-table", VOCABULARY},
    "effect-runtime": {"runtime"},
    "tools/harness": {"base", "runtime"},
    "tools/draw": {
        "base",
        "ir",
        "frontend/lex",
        "frontend/parse",
        "frontend/signature",
        "frontend/resolve",
        "frontend/check",
        "passes",
        "backend-glsl",
        "clip-table",
        "compiler/compile",
        "compiler/command",
        "runtime",
        "tools/harness",
        VOCABULARY,
    },
    "tools/reference-compiler": {"base", "ir", "frontend/lex", "tools/harness", "tools/draw"},
    "tools/values": {"base", "tools/harness", LIBRARY},
    "tools/random": {
        "base",
        "ir",
        "backend-glsl",
        "compiler/compile",
        "clip-table",
        "tools/harness",
        "tools/draw",
        VOCABULARY,
    },
    "study": {"runtime", "tools/harness", VOCABULARY, LIBRARY},
    "tools/scenes": {"base", "clip-table", "runtime", "tools/harness", VOCABULARY},
    "tools/effects": {"effect-runtime", "tools/harness"},
    "tools/bench": {"compiler/compile", "runtime", "tools/harness"},
    "tools/fuzz": {"clip-table", "runtime", *COMPILER},
    "web/module": {"compiler", "compiler/compile", "link", "runtime"},
    "web/wasm": set(),
    "examples": {"runtime", "effect-runtime", "tools/harness", LIBRARY},
}

# A library's headers, and the files that may include them.
LIBRARIES = {
    r"(clang|llvm)/": r"frontend/lex/\w+_clang\.(cpp|h)|web/module/page\.cpp|web/wasm/.*",
    r"glslang/": r"compiler/.*\.cpp|link/.*\.cpp|tools/harness/glslang_includer\.h|tools/(draw/vulkan/glslang\.(cpp|h)|reference-compiler/glslang\.cpp)|tools/bench/reference_compilers\.cpp|web/module/page\.cpp|web/wasm/.*",
    r"spirv/": r"backend-spirv/.*",
    r"epoxy/": r"tools/(harness|draw|values|study/program|scenes|effects)/.*|examples/.*\.cpp",
    r"png\.h": r"tools/harness/image\.cpp",
    r"spirv_cross/": r"tools/(draw/vulkan|reference-compiler)/.*|tools/bench/reference_compilers\.cpp",
    r"vulkan/": r"(tools/draw/vulkan|examples/lake-vulkan)/device\.h",
    r"fmt/": r"(base|ir|frontend|passes|link|rewrite|legalize|backend-glsl|compiler|tools/bench)/.*",
    r"nlohmann/": r"(base|clip-table|compiler|tools/draw|tools/values|study)/.*\.cpp",
}

# The files that clipc_add_shader() and study/program/CMakeLists.txt write into a build folder.
GENERATED = re.compile(r"[\w-]+\.(shader|clip|spv|text|effect)\.h")

INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
# A raw string, in which an include is that of a shader.
RAW = re.compile(r'R"(\w*)\(.*?\)\1"', re.S)


def room_of(path):
    """The room that holds the file at `path`, a path from the root in slashes; or None."""
    return max(
        (room for room in ROOMS if path == room or path.startswith(room + "/")),
        key=len,
        default=None,
    )


def problem(path, quote, target):
    """The problem of the file at `path`, relative to the root, including `target`; or None."""
    room, included = room_of(path.as_posix()), None
    if quote == "<" and target.startswith("clipc/"):
        included = LIBRARY if "/" not in target[6:] else room_of(target[6:])
    if quote == '"':
        if GENERATED.fullmatch(target):
            return None
        if INSTALLED.fullmatch(path.as_posix()):
            if room_of(target):
                return "is not written from this file's folder"
            target = os.path.normpath(path.parent / target)
        elif "/" not in target or target.startswith("../"):
            return "is not written from the repository's root"
        included = room_of(target)
    if included:
        if included != room and included not in ROOMS[room]:
            allowed = ", ".join(sorted(ROOMS[room])) or "no other room"
            return f"points up; {room}/ includes {allowed}"
    for headers, users in LIBRARIES.items():
        if re.match(headers, target) and not re.fullmatch(users, path.as_posix()):
            return f"does not belong here; only {users} includes it"
    return None


def problems(root):
    for room in ROOMS:
        for file in [root / room, *sorted((root / room).rglob("*"))]:
            if not file.is_file() or file.suffix not in {".h", ".cpp", ".def", ".inc"}:
                continue
            path = file.relative_to(root)
            text = RAW.sub(lambda raw: "\n" * raw[0].count("\n"), file.read_text(errors="replace"))
            for number, line in enumerate(text.splitlines(), 1):
                if match := INCLUDE.match(line):
                    if found := problem(path, match[1], match[2]):
                        yield f"{path}:{number}: including {match[2]} {found}"


def self_test():
    """A tree with one of each mistake: the check must see them all and nothing else."""
    tree = {
        "base/a.h": '#include "ir/program.h"\n',
        "ir/a.h": '#include "base/id.h"\n#include <vector>\n',
        "frontend/check/a.cpp": "#include <clang/Lex/Lexer.h>\n",
        "frontend/parse/a.h": '#include "frontend/lex/token.h"\n#include "frontend/check/check.h"\n',
        "frontend/lex/lexer_clang.cpp": "#include <clang/Lex/Lexer.h>\n",
        "examples/a.cpp": '#include "water.clip.h"\n#include "water.shader.h"\n#include "../water.clip.h"\n#include "water.h"\n',
        "passes/a.cpp": '# include "backend-glsl/writer.h"\n',
        "passes/b.cpp": 'const char* const kShader = R"(\n#include "backend-glsl/writer.h"\n)";\n',
        "backend-glsl/a.cpp": '#include "writer.h"\n',
        "clip-table/a.h": "#include <nlohmann/json.hpp>\n",
        "clip-table/a.cpp": "#include <nlohmann/json.hpp>\n",
        "clip-table/vocabulary.h": '#include <string_view>\n#include "a.h"\n',
        "runtime/gl/b.h": '#include "../../clip-table/a.h"\n#include "../../base/id.h"\n#include "runtime/gl/c.h"\n',
        "examples/b.cpp": "#include <clipc/runtime/gl/b.h>\n#include <clipc/clip-table/a.h>\n",
        "backend-glsl/b.cpp": '#include "clip-table/vocabulary.h"\n',
        "runtime/gl/a.cpp": '#include <fmt/format.h>\n#include "base/id.h"\n#include "clip-table/table.h"\n',
    }
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        for path, text in tree.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text)
        seen = {found.split(": ")[0] for found in problems(root)}
    expected = {
        "base/a.h:1",
        "frontend/check/a.cpp:1",
        "frontend/parse/a.h:2",
        "passes/a.cpp:1",
        "backend-glsl/a.cpp:1",
        "clip-table/a.h:1",
        "clip-table/vocabulary.h:2",
        "backend-glsl/b.cpp:1",
        "runtime/gl/a.cpp:1",
        "runtime/gl/a.cpp:2",
        "runtime/gl/b.h:2",
        "runtime/gl/b.h:3",
        "examples/b.cpp:2",
        "examples/a.cpp:3",
        "examples/a.cpp:4",
    }
    if seen != expected:
        sys.exit(
            f"check_layers.py itself is wrong: saw {sorted(seen)}, expected {sorted(expected)}"
        )


def main():
    self_test()
    found = list(problems(pathlib.Path(__file__).resolve().parents[2]))
    print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
