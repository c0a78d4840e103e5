#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails when a page names a file or folder of this repository, or links to a heading, that does not exist.

    check_pages.py            the pages of this repository
    check_pages.py FOLDER     the links of the pages that a package has in FOLDER

Pages: every .md file at the top, below docs/ and in study/. A page names a path in backticks or as the target of a link. Text in
backticks is taken for a path where it begins with one of the repository's top-level folders and a slash, or is a file
at the top; `*` stands for any name, a word in capitals (PASS) for any text, and `:12` may follow. What a build writes,
below build/, is left out.
"""

import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CODE = re.compile(r"`([^`\n]+)`")
LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)]*))?\)")
PATH = re.compile(r"(?<![\w./-])[.\w-]+(?:/[\w.*+{},-]+)*/?")
BLOCK = re.compile(r"^```.*?^```|^    [^\n]*$", re.M | re.S)


def expand(path):
    """The alternatives of `a/{b,c}.h`."""
    if match := re.search(r"\{([^{}]*)\}", path):
        return [
            name
            for part in match[1].split(",")
            for name in expand(path[: match.start()] + part + path[match.end() :])
        ]
    return [path]


def exists(path):
    pattern = re.sub(r"\b[A-Z]{3,}\b(?!\.md)", "*", path.rstrip("/"))
    return any(True for _ in ROOT.glob(pattern)) if "*" in pattern else (ROOT / pattern).exists()


def paths_in(text, folders):
    """The paths that the prose of a page names in backticks."""
    for code in CODE.findall(text):
        for word in PATH.findall(code):
            if word.split("/")[0] in folders and "/" in word:
                yield from expand(word)


@functools.cache
def anchors(page):
    """What GitHub calls the headings of a page in links."""
    headings = re.findall(r"^#+ (.*)$", BLOCK.sub("", page.read_text()), re.M)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken_links(page):
    for target, anchor in sorted(set(LINK.findall(BLOCK.sub("", page.read_text())))):
        linked = page.parent / target if target else page
        if "://" in target:
            continue
        if not linked.exists():
            yield f"{page}: the link to {target} leads nowhere"
        elif anchor and anchor not in anchors(linked):
            yield f"{page}: {target} has no heading #{anchor}"


def problems():
    folders = {entry.name for entry in ROOT.iterdir() if entry.is_dir() and entry.name != "build"}
    pages = (
        sorted(ROOT.glob("*.md"))
        + sorted((ROOT / "docs").rglob("*.md"))
        + sorted((ROOT / "study").glob("*.md"))
    )
    for page in pages:
        text = page.read_text()
        name = page.relative_to(ROOT)
        for path in sorted(set(paths_in(text, folders))):
            if not exists(path):
                yield f"{name}: `{path}` does not exist"
        yield from broken_links(page)


def main():
    if len(sys.argv) > 1:
        found = [
            problem
            for page in pathlib.Path(sys.argv[1]).rglob("*.md")
            for problem in broken_links(page)
        ]
        print("\n".join(found) or "every link leads to a file")
        return bool(found)
    for page in ("docs/architecture.md", "CONTRIBUTING.md"):
        if not (ROOT / page).exists():
            print(f"{page} does not exist")
            return 1
    found = list(problems())
    print("\n".join(found) or "every path that a page names exists")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
