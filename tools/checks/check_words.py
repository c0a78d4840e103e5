#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails when a page, a message or a comment uses a word for which the field has a better known one, or a page has too long a sentence.

    check_words.py            the pages, the man page, the help, the messages and the comments of this repository
    check_words.py --test     the check's own examples

The list below is that of a technical editor. Pages are those below docs/, CONTRIBUTING.md, CHANGELOG.md and each README.md, without code, paths and links;
messages are the texts of base/diagnostic_kinds.def, their explanations are those in compiler/compile/explanations/, and the help is that of compiler/command/own_options.cpp.
Comments are those of the sources in C, C++, HLSL, Python, JavaScript and CMake, without code and quotations; a part of the list is for
them.
"""

import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]

IS_NO = r"(?<!there )is no(?! (?:longer|more|less|better|larger|bigger|smaller|greater)\b)"

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
    IS_NO: "is not a",
    r"(?:^|[.:;] )Of (?!course\b|(?:the )?\d)": "In",
}
# More words for pages and the help. Messages say "takes 2 arguments", as compilers of C++ do.
PAGE_WORDS = {r"tak(?:es?|en|ing)|took": "accept, read, use, need or last"}
# For comments. The sources have other meanings of the words that are not here: "turns X into Y", a plane that meets a point.
COMMENT_WORDS = {
    pattern: WORDS[pattern]
    for pattern in (r"pictures?", r"settings?", r"peers?", r"mend(?:s|ed)?", IS_NO)
} | {
    r"(?:\d|\bN|each|every|fewer|first|further|last|loop's|more|next|of|whose) turns?": "iteration",
}

LONGEST = 40  # words of a sentence on a page, where a piece of code is one

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


PIECE = re.compile(r"(?<!`)`[^`\n]+`(?!`)")  # of code
# The end of a sentence: a full stop, a paragraph, an item of a list, or a cell of a table.
END = re.compile(r"[.!?][*)\"]*\s|\n\s*\n|\n\s*(?:[-*]|\d+\.) |\|")


def long_sentences(page):
    """(line, words) of each sentence of a page that has too many."""
    text, begin = prose(PIECE.sub("code", page)), 0
    for end in [*(match.end() for match in END.finditer(text)), len(text)]:
        words = re.findall(r"\w\S*", text[begin:end])
        if len(words) > LONGEST:
            yield text.count("\n", 0, text.index(words[0], begin)) + 1, words
        begin = end


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


SLASHES = re.compile(r"(?:^|\s)//+(.*)|^\s*(?:/\*+|\*(?= ))(.*)")
SIGN = re.compile(r"(?:^|\s)#(.*)")
COMMENT = dict.fromkeys([".c", ".cpp", ".h", ".hlsl", ".hpp", ".js", ".mjs"], SLASHES)
COMMENT |= dict.fromkeys([".cmake", ".py"], SIGN)
# What is quoted, and what a lit test runs or expects.
QUOTED = re.compile(r"`[^`]*`|\"[^\"]*\"|^ ?[A-Z][A-Z0-9_-]*:.*")


def comments(source, comment):
    """The comment of each line, without code; the other lines become empty."""
    found = (comment.search(line) for line in source.split("\n"))
    return "\n".join(QUOTED.sub("", match[match.lastindex]) if match else "" for match in found)


def files():
    """Each file that is not in a folder of builds, of packages for node or of a fuzzer's corpus."""
    for folder, folders, names in os.walk(ROOT):
        folders[:] = sorted(set(folders) - {"build", "node_modules", "corpus", ".git"})
        yield from (pathlib.Path(folder, name) for name in sorted(names))


def pages():
    """(name, text) of each page that is not made of the messages and their explanations."""
    for page in [
        ROOT / "CONTRIBUTING.md",
        ROOT / "CHANGELOG.md",
        *(path for path in files() if path.name == "README.md"),
        *sorted((ROOT / "docs").rglob("[!R]*.md")),
    ]:
        if page.name != "diagnostics.md":
            yield str(page.relative_to(ROOT)), page.read_text()


def explanations():
    """(name, text) of the rules of each file of explanations."""
    for file in sorted((ROOT / "compiler/compile/explanations").glob("*.def")):
        yield f"compiler/compile/explanations/{file.name}", rules(file.read_text())


def texts():
    """(name, text, its words) of all that is looked at."""
    for name, page in pages():
        text = prose(page)
        for where, exception in EXCEPTIONS:
            if where == name:
                text = text.replace(exception, "")
        yield name, text, WORDS | PAGE_WORDS
    yield "packaging/clipc.1.in", (ROOT / "packaging/clipc.1.in").read_text(), WORDS | PAGE_WORDS
    for name, beginning, words in (
        ("base/diagnostic_kinds.def", r"DIAG\(", WORDS),
        ("compiler/command/own_options.cpp", r'\s+(?:"|\{"|Topic)', WORDS | PAGE_WORDS),
    ):
        yield name, strings((ROOT / name).read_text(), beginning).replace("`", " "), words
    for name, text in explanations():
        yield name, prose(text), WORDS | PAGE_WORDS
    for path in files():
        comment = SIGN if path.name == "CMakeLists.txt" else COMMENT.get(path.suffix)
        if comment and path.name != pathlib.Path(__file__).name:
            text = comments(path.read_text(errors="replace"), comment)
            yield str(path.relative_to(ROOT)), text, COMMENT_WORDS


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
    long = " ".join(["word"] * LONGEST)
    pages = {
        f"{long}.\n{long}, `a b`.": [2],
        f"{long}\n\n- {long}\n- {long} word": [4],
        f"| {long} | {long} |\n`{long} word`\n\n    {long} word\n": [],
    }
    bad += [page for page, lines in pages.items() if [f[0] for f in long_sentences(page)] != lines]
    source = """
int peers;  // the peers
# no comment: peers
/* This is no error. */
 * The loop's turns. It turns `settings` on, in turn, and "pictures" too.
int n;  // mended
// CHECK: image2D picture;
"""
    seen = [fault[:2] for fault in faults(comments(source, SLASHES), COMMENT_WORDS)]
    if sorted(seen) != [(2, "peers"), (4, "is no"), (5, "loop's turns"), (6, "mended")]:
        bad.append(f"comments: {seen}")
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
    found += [
        f"{name}:{line}: a sentence of {len(words)} words: `{' '.join(words[:8])} ...`: write shorter ones"
        for name, page in (*pages(), *explanations())
        for line, words in long_sentences(page)
    ]
    print("\n".join(sorted(found)) or "every page, message and comment uses the field's words")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
