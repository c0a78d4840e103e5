#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds the catalogue of diagnostics against its index and its tests, and writes its pages.

    check_diagnostics.py [--write] [--coverage] [--explanations CLIPC] [--pages FOLDER]

docs/diagnostics.md must be the index of base/diagnostic_kinds.def; --write makes it so.
Fails when two kinds share a name, when one has no explanation in compiler/compile/explanations/, but those that
no user sees, or, with --coverage, when no test expects a kind. A test expects a kind where
its printed name is as clipc prints it: in brackets after a message (`[-Wclip-plane-repeated]`,
`[clip-plane-not-float4, X3084]`), as the code of the msvc form, or as a name of the JSON form, which
is the only one that names notes.

With --explanations, clipc must report the kind about each example of an explanation, and accept the fixed
one without it; --pages writes the pages (diagnostic_pages.py), each link of which must lead somewhere."""

import pathlib
import re
import sys

from check_pages import broken_links
from diagnostic_pages import (
    CATALOGUE,
    HOW,
    NOT_SEEN,
    ROOT,
    chapters,
    explanations,
    kinds,
    printed,
    try_explanations,
    write_pages,
)

DOCUMENT = ROOT / "docs/diagnostics.md"

# No shader brings these about: the parser or the driver refuses what would, or they report a fault of
# clipc itself (PlainNote lists the rest of what glslang finds).
NOT_PROVOKED = {
    "InvalidGlsl",
    "PlainNote",
    "InternalError",
    "InitListAsValue",
    "SwitchWithoutBlock",
    "TargetClipVertex",
}

INDEX = f"""# Diagnostics

Everything that clipc reports about a shader.

- `clipc --explain NAME` and `clipc --explain CODE` print the rule of a message, an example, what clipc says about it, and the fix.
- A package has all of that as pages, one a chapter, in `share/doc/clipc/docs/diagnostics`. In the sources,
  `tools/checks/diagnostic_pages.py FOLDER CLIPC` writes them.

{HOW}"""


def index(all_kinds):
    """docs/diagnostics.md: the names of each chapter."""
    rows = [INDEX, "| chapter | kinds | names |", "|---|---|---|"]
    for title, kinds_of in chapters(all_kinds).items():
        names = ", ".join(f"`{name}`" for name in sorted(printed(name) for name, *_ in kinds_of))
        rows.append(f"| {title} | {len(kinds_of)} | {names} |")
    return "\n".join(rows) + "\n"


# A printed name in an expected message.
EXPECTED = re.compile(
    r'\[(?:-Werror,)?(?:-W)?([a-z0-9-]+)(?=[],])|: (?:error|warning) ([a-z0-9-]+):|"name": "([a-z0-9-]+)"'
)


def expected_names():
    """Every name that a line of a test expects, except in the RUN lines."""
    tests = [
        file for file in sorted((ROOT / "testdata").rglob("*")) if file.suffix in {".hlsl", ".test"}
    ]
    tests += [
        file
        for file in sorted(ROOT.rglob("*_test.cpp"))
        if "build" not in file.relative_to(ROOT).parts
    ]
    for file in tests:
        for line in file.read_text(errors="replace").splitlines():
            if "RUN:" not in line:
                for match in EXPECTED.finditer(line):
                    yield next(filter(None, match.groups()))


def untested(all_kinds):
    expected = set(expected_names())
    for _, name, *_ in all_kinds:
        if name not in NOT_PROVOKED and printed(name) not in expected:
            yield name


def unexplained(all_kinds):
    """The kinds without a page, of those that a user can see."""
    explained = {name for name, *_ in explanations()}
    for _, name, severity, *_ in all_kinds:
        if severity != "note" and name not in explained | NOT_SEEN:
            yield name


def main():
    all_kinds = list(kinds())
    problems = []
    names = [name for _, name, *_ in all_kinds]
    problems += [f"{name}: listed twice" for name in sorted(set(names)) if names.count(name) > 1]
    declared = len(re.findall(r"^DIAG\(", CATALOGUE.read_text(), re.M))
    if declared != len(all_kinds):
        problems.append(f"{declared} kinds are declared but {len(all_kinds)} were understood")
    problems += [
        f"{name}: compiler/compile/explanations has no page of `{printed(name)}`"
        for name in unexplained(all_kinds)
    ]
    outputs = {}
    if "--explanations" in sys.argv:
        clipc = pathlib.Path(sys.argv[sys.argv.index("--explanations") + 1]).resolve()
        outputs, mistakes = try_explanations(clipc)
        problems += mistakes
    if "--pages" in sys.argv:
        folder = pathlib.Path(sys.argv[sys.argv.index("--pages") + 1])
        write_pages(folder, chapters(all_kinds), outputs)
        for page in sorted(folder.glob("*.md")):
            problems += broken_links(page)
    if "--write" in sys.argv:
        DOCUMENT.write_text(index(all_kinds))
    elif not DOCUMENT.exists() or DOCUMENT.read_text() != index(all_kinds):
        problems.append(
            "docs/diagnostics.md is out of date: run tools/checks/check_diagnostics.py --write"
        )
    if "--coverage" in sys.argv:
        problems += [f"{name}: no test expects `{printed(name)}`" for name in untested(all_kinds)]
    print("\n".join(problems) or f"{len(all_kinds)} kinds of diagnostics, each documented")
    return bool(problems)


sys.exit(main())
