#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles each mistake of the table mistakes.txt, and its cure.

    check_mistakes.py CLIPC                   fails where a message is another one, or a cure is not one
    check_mistakes.py CLIPC --page FILE       fails too if the page is not the table's
    check_mistakes.py CLIPC --page FILE --write

The table has chapters, `# Names`, and in them mistakes:

    --- -T ps_5_0                  options of the call
    float4 main() : SV_Target { return texure; }
    @ 1:36 undeclared-name: did you mean `texture`?
    - texure
    + texture

The line with `@` has the place and the name of the message, and what it or a note says there. `-` is the text at fault, and `+` is what
is written in its place, in the code or in the options, or a further option; after that no message is left. Without `+`, the cure is
for the reader to choose.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

TABLE = pathlib.Path(__file__).with_name("mistakes.txt")
MESSAGE = re.compile(
    r"^(?:[^:\n]*:(\d+:\d+)|clipc): (?:error|warning): (.*?)(?: \[(?:-W)?([a-z0-9-]+)[^\]]*\])?$",
    re.M,
)
NOTE = re.compile(r": note: (.*)$", re.M)


class Mistake:
    def __init__(self, chapter, line, options):
        self.chapter, self.line, self.options = chapter, line, options
        self.code, self.wrong, self.right = "", "", ""


def read_table():
    mistakes, chapter = [], ""
    for number, line in enumerate(TABLE.read_text().splitlines(), 1):
        if line.startswith("# "):
            chapter = line[2:]
        elif line.startswith("---"):
            mistakes.append(Mistake(chapter, number, line[3:].strip()))
        elif match := re.fullmatch(r"@ (\d+:\d+|-) ([\w-]+): (.*)", line):
            mistakes[-1].place, mistakes[-1].name, mistakes[-1].says = match.groups()
        elif line.startswith("- "):
            mistakes[-1].wrong = line[2:]
        elif line.startswith("+ "):
            mistakes[-1].right = line[2:]
        elif mistakes and line:
            mistakes[-1].code += line + "\n"
    return mistakes


def messages_of(clipc, options, code):
    """The place, the text and the name of each error and warning; and the texts of the notes."""
    with tempfile.TemporaryDirectory() as folder:
        is_effect = "--effect" in options
        path = pathlib.Path(folder, "a.fx" if is_effect else "a.hlsl")
        path.write_text(code)
        output = ["-o", folder] if is_effect else ["-o", str(path.with_suffix(".out"))]
        call = [clipc, path.name, *options.split(), *output]
        said = subprocess.run(call, cwd=folder, capture_output=True, text=True)
    return MESSAGE.findall(said.stderr), NOTE.findall(said.stderr)


def check(clipc, mistake):
    """What is wrong with the mistake's message or cure; empty if nothing is."""
    messages, notes = messages_of(clipc, mistake.options, mistake.code)
    if not messages:
        return "no message"
    place, text, name = messages[0]
    if (place or "-", name or "-") != (mistake.place, mistake.name):
        return f"the first message is {place or '-'} {name}: {text}"
    said = [one for one in [text, *notes] if mistake.says in one]
    mistake.says = "; ".join(dict.fromkeys([text, *said[:1]]))
    if not said:
        return f"the message is `{text}`"
    if not mistake.right:
        return ""
    if mistake.wrong not in mistake.code + mistake.options:
        return f"there is no `{mistake.wrong}`"
    options, code = mistake.options, mistake.code
    if mistake.right.startswith("-") and mistake.wrong in code:
        options += " " + mistake.right
    elif mistake.wrong in code:
        code = code.replace(mistake.wrong, mistake.right)
    else:
        options = options.replace(mistake.wrong, mistake.right)
    left, _ = messages_of(clipc, options, code)
    return f"after the cure: {left[0]}" if left else ""


def page(mistakes):
    """The page of the table."""
    text = (
        "<!-- SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception -->\n"
        "# Common mistakes\n\n"
        "What clipc says about mistakes that many people make, and what you write instead. `clipc --explain NAME` says more about a\n"
        "message; the name is in brackets at its end. [diagnostics.md](diagnostics.md) has all of them.\n"
    )
    chapter = ""
    for mistake in mistakes:
        if mistake.chapter != chapter:
            chapter = mistake.chapter
            text += f"\n## {chapter}\n\n| you wrote | clipc says | write |\n|---|---|---|\n"
        says = mistake.says.replace("|", "\\|")
        cells = [mistake.wrong, mistake.right]
        wrong, right = (f"`{cell}`".replace("|", "\\|") if cell else "" for cell in cells)
        text += f"| {wrong} | {says} | {right} |\n"
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("clipc")
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    clipc = str(pathlib.Path(options.clipc).resolve())
    mistakes, failed = read_table(), 0
    for mistake in mistakes:
        if problem := check(clipc, mistake):
            failed += 1
            print(f"{TABLE.name}:{mistake.line}: {problem}")
    if options.page and options.write:
        options.page.write_text(page(mistakes))
    elif options.page and options.page.read_text() != page(mistakes):
        failed += 1
        print(f"{options.page} is not the table's; --write makes it")
    print(f"{len(mistakes)} mistakes, {failed} wrong")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
