#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes the reference of the installed headers with Doxygen, and fails for a warning.

usage: check_reference.py DOXYGEN BUILD_FOLDER OUTPUT_FOLDER      writes OUTPUT_FOLDER/html/index.html
"""

import pathlib
import subprocess
import sys

DOXYFILE = """
PROJECT_NAME           = clipc
PROJECT_BRIEF          = "the compiler's library and the runtime"
INPUT                  = "{headers}" "{main}"
FILE_PATTERNS          = *.h *.hpp
RECURSIVE              = YES
USE_MDFILE_AS_MAINPAGE = "{main}"
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
QUIET                  = YES
WARNINGS               = YES
WARN_IF_DOC_ERROR      = YES
"""

MAIN = """# The headers of clipc

`<clipc/clipc.h>` is the compiler for C, with `<clipc/clipc_effect.h>`, and `<clipc/clipc.hpp>` the same for C++. `runtime/` is what an application draws with:
`<clipc/runtime/clipc_runtime.h>` for C, the other headers for C++. The pages in the folder docs/ say how they go together.
"""


def main():
    doxygen, build, output = (
        sys.argv[1],
        pathlib.Path(sys.argv[2]).resolve(),
        pathlib.Path(sys.argv[3]).resolve(),
    )
    output.mkdir(parents=True, exist_ok=True)
    installed = output / "installed"
    subprocess.run(
        ["cmake", "--install", build, "--component", "development", "--prefix", installed],
        check=True,
        capture_output=True,
    )
    start = output / "headers.md"
    start.write_text(MAIN)
    options = DOXYFILE.format(headers=installed / "include/clipc", main=start, output=output)
    done = subprocess.run(
        [doxygen, "-"], input=options, capture_output=True, text=True, check=False
    )
    said = (done.stderr + done.stdout).strip()
    print(said or f"the reference is {output / 'html/index.html'}")
    return int(bool(said) or done.returncode != 0)


if __name__ == "__main__":
    sys.exit(main())
