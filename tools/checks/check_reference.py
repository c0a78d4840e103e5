#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes the reference of the installed headers with Doxygen, and fails for a warning.

usage: check_reference.py DOXYGEN BUILD_FOLDER OUTPUT_FOLDER      writes OUTPUT_FOLDER/html/index.html
       check_reference.py --filter HEADER                         what Doxygen reads of a header

The headers have plain comments. As Doxygen wants them marked, a comment before a declaration gets `///`, and one that follows on the
same line `///<`; a comment above several declarations is about each.
"""
import pathlib
import re
import subprocess
import sys

# Words in comments that Doxygen would take for its commands or for HTML.
TAGS = re.compile(r"[@\\<](?=\w)")

DOXYFILE = """
PROJECT_NAME           = clipc
PROJECT_BRIEF          = "the compiler's library and the runtime"
INPUT                  = "{headers}" "{main}"
FILE_PATTERNS          = *.h *.hpp
RECURSIVE              = YES
USE_MDFILE_AS_MAINPAGE = "{main}"
INPUT_FILTER           = "{python} {this} --filter"
FILTER_PATTERNS        = *.md=cat
STRIP_FROM_PATH        = "{headers}"
OUTPUT_DIRECTORY       = "{output}"
JAVADOC_AUTOBRIEF      = YES
MARKDOWN_SUPPORT       = YES
AUTOLINK_SUPPORT       = YES
EXTRACT_ALL            = YES
WARN_NO_PARAMDOC       = NO
ENABLE_PREPROCESSING   = YES
MACRO_EXPANSION        = YES
EXPAND_ONLY_PREDEF     = YES
PREDEFINED             = CLIPC_API= CLIPC_GL_API= __cplusplus=201703L
GENERATE_LATEX         = NO
HAVE_DOT               = NO
DISTRIBUTE_GROUP_DOC   = YES
QUIET                  = YES
WARNINGS               = YES
WARN_IF_DOC_ERROR      = YES
"""

MAIN = """# The headers of clipc

`compiler/clipc.h` is the compiler for C, `compiler/clipc.hpp` the same for C++. `runtime/` is what an application draws with:
`runtime/clipc_runtime.h` for C, the other headers for C++. The pages in the folder docs/ say how they go together.
"""


def grouped(text):
    """A comment above several declarations, with no empty line between them, is about each; one above none is about the file."""
    paragraphs = []
    for paragraph in text.split("\n\n"):
        lines = paragraph.split("\n")
        after = next((i for i, line in enumerate(lines) if not re.match(r"\s*(///|/\*\*|\*| \* )(?!<)", line)), len(lines))
        code = "\n".join(re.sub(r"//.*|/\*.*?\*/", "", line) for line in lines[after:])
        outside = re.sub(r"\{[^{}]*\}", "", re.sub(r"\{[^{}]*\}", "", code))
        if after == len(lines) and re.match(r"/// |/\*\* ", paragraph):  # about no declaration: about the file
            lines[0] = re.sub(r"^(///|/\*\*) ", r"\1 \\file\n\1 " if paragraph.startswith("///") else r"\1 \\file\n * ", lines[0])
        if after and not re.search(r"[{}#]", outside) and outside.count(";") > 1:
            indent = re.match(r"\s*", lines[0])[0]
            lines = [*lines[:after], indent + "///@{", *lines[after:], indent + "///@}"]
        paragraphs.append("\n".join(lines))
    return "\n\n".join(paragraphs)


def filtered(text):
    lines = ["/** \\file */"]
    for line in text.splitlines():
        if "SPDX-License-Identifier" in line or "NOLINT" in line or "clang-format o" in line:
            lines.append("")
            continue
        comment = re.match(r"^(\s*)//(?!/)(.*)$", line)
        trailing = re.match(r"^(.*\S)(\s+)// (.*)$", line)
        if comment:
            line = f"{comment[1]}///{TAGS.sub(lambda m: chr(92) + m[0], comment[2])}"
        elif trailing:
            line = f"{trailing[1]}{trailing[2]}///< {TAGS.sub(lambda m: chr(92) + m[0], trailing[3])}"
        else:
            line = re.sub(r"^(.*\S)(\s+)/\* (.*)$", r"\1\2/**< \3", line)
            line = re.sub(r"^(\s*)/\* (.*)$", r"\1/** \2", line)
        lines.append(line)
    return grouped("\n".join(lines)) + "\n"


def main():
    if sys.argv[1] == "--filter":
        sys.stdout.write(filtered(pathlib.Path(sys.argv[2]).read_text()))
        return 0
    doxygen, build, output = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    output.mkdir(parents=True, exist_ok=True)
    installed = output / "installed"
    subprocess.run(["cmake", "--install", build, "--component", "development", "--prefix", installed], check=True, capture_output=True)
    start = output / "headers.md"
    start.write_text(MAIN)
    settings = DOXYFILE.format(headers=installed / "include/clipc", main=start, output=output, python=sys.executable,
                               this=pathlib.Path(__file__).resolve())
    done = subprocess.run([doxygen, "-"], input=settings, capture_output=True, text=True, check=False)
    said = (done.stderr + done.stdout).strip()
    print(said or f"the reference is {output / 'html/index.html'}")
    return int(bool(said) or done.returncode != 0)


if __name__ == "__main__":
    sys.exit(main())
