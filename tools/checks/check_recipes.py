#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails when a step of a recipe in CONTRIBUTING.md names what is not there.

    check_recipes.py

A step is a numbered line below a heading of "## Recipes", with the lines that go on. What a step has in backticks is
a path, which must exist, or a text, which must be in one of the files that the step names; NAME stands for any text.
The texts of a step that names no path are looked for in all sources, up to a bracket: `.Note(...)` is `.Note(`.
"""

import pathlib
import re
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PATH = re.compile(r"[\w.-]+/[\w./-]*|\w+\.(md|py|cpp|h|def)")
SOURCES = (".h", ".cpp", ".def", ".hlsl", ".test")


def steps(page):
    """Each step as its recipe, its number and its text."""
    recipes = page.partition("\n## Recipes\n")[2].partition("\n## ")[0]
    for recipe in recipes.split("\n### ")[1:]:
        title = recipe.split("\n")[0]
        for number, text in re.findall(r"^(\d+)\. (.*(?:\n {2,}.*)*)", recipe, re.M):
            yield title, number, text


def files_at(root, path):
    """The files at a path, or below it where it is a folder; empty if there is none."""
    found = list(root.glob(path.rstrip("/").replace("NAME", "*")))
    return [
        file for at in found for file in ([at] if at.is_file() else at.rglob("*")) if file.is_file()
    ]


def all_sources(root):
    for file in root.rglob("*"):
        if file.suffix in SOURCES and file.relative_to(root).parts[0] not in ("build", ".git"):
            yield file


def problems(root):
    found = list(steps((root / "CONTRIBUTING.md").read_text()))
    if not found:
        yield "CONTRIBUTING.md has no recipes"
    for title, number, text in found:
        where = f"CONTRIBUTING.md, {title}, step {number}"
        codes = re.findall(r"`([^`\n]+)`", text)
        paths = [code for code in codes if PATH.fullmatch(code)]
        files = []
        for path in paths:
            there = files_at(root, path)
            if not there and "NAME" not in path:
                yield f"{where}: `{path}` does not exist"
            files += there
        wanted = {code: code.partition("NAME")[0] for code in codes if code not in paths}
        if not paths:
            files = all_sources(root) if wanted else []
            wanted = {code: re.sub(r"(?<=\().*", "", text) for code, text in wanted.items()}
        for file in files:
            text = file.read_text(errors="replace")
            wanted = {code: part for code, part in wanted.items() if part not in text}
            if not wanted:
                break
        for code in wanted:
            yield f"{where}: `{code}` is not in {' or '.join(paths) or 'any source'}"


def self_test():
    """A page with one of each mistake: the check must see them all and nothing else."""
    page = """# Contributing
1. `not/a.cpp`, which is not a step of a recipe.

## Recipes

### A thing

1. `ir/a.def`: a row; `OneRow` is one and `NoRow` is not.
2. `ir/gone.cpp`: a case.
3. `Report(where, what...)` and `.Lost(...)`, wherever it is.
4. `tests/NAME/` with
   `--after=NAME`, and `OneRow`.

## Another chapter
"""
    with tempfile.TemporaryDirectory() as name:
        root = pathlib.Path(name)
        (root / "CONTRIBUTING.md").write_text(page)
        for path, text in {
            "ir/a.def": "OneRow",
            "tests/x/a.test": "--after=x",
            "ir/b.cpp": "Report(x)",
        }.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text)
        seen = [found.removeprefix("CONTRIBUTING.md, A thing, step ") for found in problems(root)]
    expected = [
        "1: `NoRow` is not in ir/a.def",
        "2: `ir/gone.cpp` does not exist",
        "3: `.Lost(...)` is not in any source",
        "4: `OneRow` is not in tests/NAME/",
    ]
    if seen != expected:
        sys.exit(f"check_recipes.py itself is wrong: saw {seen}, expected {expected}")


def main():
    self_test()
    found = list(problems(ROOT))
    print("\n".join(found) or "every step of a recipe names what is there")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
