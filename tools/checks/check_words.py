#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails when a page or a message uses a word for which the field has a better known one.

    check_words.py            the pages, the man page, the help and the messages of this repository
    check_words.py --test     the check's own examples

The list below is that of a technical editor. Pages are those in docs/, CONTRIBUTING.md, CHANGELOG.md and each README.md, without code, paths and links;
messages are the texts of base/diagnostic_kinds.def, their explanations are those in compiler/explanations/, and the help is that of compiler/own_options.cpp.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

# What is found, and what to write instead.
WORDS = {
    r"pictures?": "image or frame",
    r"settings?": "permutation or option",
    r"(?:\d|\bN|fewer|more|whose|{}) turns?": "iteration",
    r"peers?": "reference compiler",
    r"(?:the )?other half|both halves|two halves": "pixel shader, vertex shader, or both shaders",
    r"digits": "precision",
    r"meets?|met": "match or link",
    r"mend(?:s|ed)?": "fix",
    r"without a word": "silently",
    r"of one's own": "separate",
    r"kin": "the names of what is meant",
    r"ask(?:s|ed)? for": "query, need or request",
    r"stands?(?! (?:for|in for|still)\b)": "is",
    r"(?<!there )is no(?! (?:longer|more|less|better|larger|bigger|smaller|greater)\b)": "is not a",
    r"(?:^|[.:;] )Of (?!course\b|(?:the )?\d)": "In",
}
# These are for pages and the help. Messages say "takes 2 arguments", as compilers of C++ do.
PAGE_WORDS = {r"tak(?:es?|en|ing)|took": "accept, read, use, need or last"}

# What a page says in its own right: (page, text).
EXCEPTIONS = {
    ("docs/errata.md", "setting does not enable"),  # what Microsoft's page says
}

CODE = re.compile(
    r"^```.*?^```$|^    [^\n]*$|`[^`\n]*`|\]\([^)]*\)|[\w./]+\.md\b|<!--.*?-->", re.M | re.S
)


def faults(text, words):
    """(line, word, what to write instead) of each in a text."""
    for pattern, better in words.items():
        bounded = re.compile(
            pattern if pattern.startswith("(?:^|") else rf"(?<![\w-])(?:{pattern})(?![\w-])",
            re.M | (0 if "Of" in pattern else re.I),
        )
        for match in bounded.finditer(text):
            yield text.count("\n", 0, match.start()) + 1, match[0].strip(), better


def prose(page):
    """The page's text; code, paths and links become spaces, and lines stay lines."""
    return CODE.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), page)


def strings(source, beginning):
    """The string literals of each line that begins so; the others become empty lines."""
    return "\n".join(
        " ".join(re.findall(r'"((?:[^"\\]|\\.)*)"', line)) if re.match(beginning, line) else ""
        for line in source.split("\n")
    )


def rules(source):
    """The rules of a file of explanations: the texts before an example and its options."""
    shaders = re.compile(r'R"\(.*?\)"', re.S)
    without = shaders.sub(lambda match: "R" + "\n" * match[0].count("\n"), source)
    return strings(without, r'\s+"(?!.*", (?:R|""\)))')


def readmes():
    """Each README.md that is not in a folder of builds or of packages for node."""
    skipped = {"build", "node_modules"}
    return [path for path in sorted(ROOT.rglob("README.md")) if not skipped & set(path.parts)]


def texts():
    """(name, text, its words) of all that is looked at."""
    for page in [
        ROOT / "CONTRIBUTING.md",
        ROOT / "CHANGELOG.md",
        *readmes(),
        *sorted((ROOT / "docs").glob("[!R]*.md")),
    ]:
        if page.name == "diagnostics.md":
            continue  # made of the messages and their explanations
        name = str(page.relative_to(ROOT))
        text = prose(page.read_text())
        for where, exception in EXCEPTIONS:
            if where == name:
                text = text.replace(exception, "")
        yield name, text, WORDS | PAGE_WORDS
    yield "packaging/clipc.1.in", (ROOT / "packaging/clipc.1.in").read_text(), WORDS | PAGE_WORDS
    for name, beginning, words in (
        ("base/diagnostic_kinds.def", r"DIAG\(", WORDS),
        ("compiler/own_options.cpp", r'\s+(?:"|\{"|Topic)', WORDS | PAGE_WORDS),
    ):
        yield name, strings((ROOT / name).read_text(), beginning).replace("`", " "), words
    for file in sorted((ROOT / "compiler/explanations").glob("*.def")):
        yield (
            f"compiler/explanations/{file.name}",
            prose(rules(file.read_text())),
            WORDS | PAGE_WORDS,
        )


def test():
    """Each rule finds its word, and leaves alone what only looks like it."""
    found = {
        "A picture.": "picture",
        "a loop of 3 turns": "3 turns",
        "It takes a file.": "takes",
        "Done.\nOf HLSL, only this": "Of",
        "This is no error.": "is no",
        "    clipc x.hlsl\n\nIt stands before.": "stands",
        "what nobody mended": "mended",
    }
    silent = [
        "`--picture` and [x](pictures/x.png)",
        "    clipc picture.hlsl",
        "it turns warnings off",
        "there is no error",
        "kind",
        "mistaken",
        "`@FILE` stands for words",
        "Of course",
    ]
    words = WORDS | PAGE_WORDS
    bad = [
        text for text, word in found.items() if [f[1] for f in faults(prose(text), words)] != [word]
    ]
    bad += [text for text in silent if list(faults(prose(text), words))]
    print("\n".join(f"wrong about: {text}" for text in bad) or "every rule finds its word")
    return bool(bad)


def main():
    if "--test" in sys.argv:
        return test()
    found = [
        f"{name}:{line}: `{word}`: write {better}"
        for name, text, words in texts()
        for line, word, better in faults(text, words)
    ]
    print("\n".join(sorted(found)) or "every page and message uses the field's words")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
