#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Rewrites the CHECK lines of tests from what their RUN lines print. Read the difference before you commit it.

usage: testdata/update_checks.py [--clipc PROGRAM] [FILE...]

Only a test with the line `// AUTOUPDATE` is touched; a FILE that is named gets that line. Without FILE: every such test.
A message about a line of the test is checked just above that line; everything else at the end of the test, or before the first
part of a split-file test. No test runs this script.
"""

import argparse
import dataclasses
import os
import pathlib
import re
import subprocess
import sys
import tempfile

TESTDATA = pathlib.Path(__file__).resolve().parent
TOOL_FOLDERS = ["/usr/lib/llvm-19/bin", "/usr/lib/llvm-22/bin"]
RUN = re.compile(r"^(?P<comment>.*?)RUN:\s*(?P<command>.*)$")
FILE_CHECK = re.compile(r"\|\s*FileCheck\s+(?P<arguments>[^|]*)$")
SPLIT = re.compile(r"^\S{0,3}---\s")


class Refusal(Exception):
    """The test cannot be updated; the text says why."""


@dataclasses.dataclass
class Check:
    """One CHECK line to be: its directive, and its text in which `\\0` stands for the line number of source line `line`."""

    directive: str
    text: str
    line: int | None = None


def run_lines(lines):
    """The commands, with lines that end in a backslash joined."""
    joined = ""
    for line in lines:
        if match := RUN.match(line):
            joined += match["command"].rstrip()
            if joined.endswith("\\"):
                joined = joined[:-1] + " "
            else:
                yield joined
                joined = ""


def outputs(path, lines, substitutions):
    """What each FileCheck prefix sees, as {prefix: text}."""
    seen = {}
    environment = dict(os.environ, PATH=os.pathsep.join(TOOL_FOLDERS + [os.environ["PATH"]]))
    for command in run_lines(lines):
        for name, value in substitutions:
            command = re.sub(re.escape(name) + r"\b", lambda _, value=value: value, command)
        file_check = FILE_CHECK.search(command)
        if file_check:
            command = command[: file_check.start()]
        result = subprocess.run(
            ["bash", "-o", "pipefail", "-c", command],
            env=environment,
            stdout=subprocess.PIPE,
            check=False,
        )
        if result.returncode:
            raise Refusal(f"exit status {result.returncode} from: {command}")
        if not file_check:
            continue
        arguments = file_check["arguments"]
        prefixes = re.findall(r"--?check-prefix(?:es)?[= ](\S+)", arguments)
        text = result.stdout.decode(errors="replace")
        if input_file := re.search(r"--?input-file[= ](\S+)", arguments):
            text = pathlib.Path(input_file[1]).read_text(errors="replace")
        for prefix in ",".join(prefixes or ["CHECK"]).split(","):
            if seen.setdefault(prefix, text) != text:
                raise Refusal(
                    f"two RUN lines print different things for {prefix}; give each a --check-prefix"
                )
    return seen


def escape(text):
    """`text` as FileCheck matches it literally."""
    return text.replace("{{", r"{{\{\{}}").replace("[[", r"{{\[\[}}")


def checks_for(prefix, text, path, scratch, source_line):
    """The CHECK lines for one output: a list of (source line they stand above or None, Check)."""
    placed = []
    position = None
    pending = []  # lines before the first that names a line of the test
    message = re.compile(rf"^\S*?{re.escape(path.name)}[:(](\d+)")
    for line in text.strip("\n").splitlines():
        number = None
        shown = line.rstrip()
        match = message.match(shown) or (
            re.match(r"^\s*(\d+) \|", shown) if position is not None else None
        )
        if match and (number := source_line.get(int(match[1]))) is not None:
            begin, end = match.span(1)
            shown = escape(shown[:begin]) + "\0" + escape(shown[end:])
            if message.match(line):
                position = number if position is None else max(position, number)
                shown = shown[shown.index(path.name) :]
        else:
            shown = escape(shown)
        shown = shown.replace(str(path), "{{.*}}" + path.name).replace(scratch, "{{.*}}")
        if not shown:
            check = Check("-EMPTY", "")
        else:
            check = Check("-NEXT" if placed or pending else "", shown, number)
        if position is None:
            pending.append(check)
        else:
            placed += [(position, earlier) for earlier in pending] + [(position, check)]
            pending = []
    return [
        (where, prefix, check) for where, check in placed + [(None, check) for check in pending]
    ]


def update(path, clipc, adopt):
    """Rewrites one test; says whether it changed."""
    old = path.read_text()
    lines = old.splitlines()
    runs = [index for index, line in enumerate(lines) if RUN.match(line)]
    if not runs:
        raise Refusal("no RUN line")
    comment = RUN.match(lines[runs[0]])["comment"]
    marker = f"{comment}AUTOUPDATE"
    if marker not in lines:
        if not adopt:
            return False
        lines.insert(runs[-1] + 1, marker)

    with tempfile.TemporaryDirectory() as scratch:
        # The command must see the line numbers that the map below speaks of.
        path.write_text("\n".join(lines) + "\n")
        try:
            seen = outputs(
                path,
                lines,
                [
                    ("%clipc", str(clipc)),
                    ("%draw", str(clipc.parent.parent / "tools/draw/clipc-draw")),
                    ("%validate", "glslangValidator"),
                    ("%python", sys.executable),
                    ("%s", str(path)),
                    ("%S", str(path.parent)),
                    ("%t", f"{scratch}/t"),
                    ("%T", scratch),
                ],
            )
        except Refusal:
            path.write_text(old)
            raise
        names = "|".join(map(re.escape, sorted(seen, key=len, reverse=True)))
        is_check = re.compile(
            rf"^\s*{re.escape(comment.strip())}\s*({names})(-NEXT|-EMPTY|-SAME|-NOT|-DAG|-LABEL|-COUNT-\d+)?:"
        )
        kept = [
            (number, line)
            for number, line in enumerate(lines, 1)
            if not (seen and is_check.match(line))
        ]
        while kept and not kept[-1][1].strip():
            kept.pop()
        source_line = {number: index for index, (number, _) in enumerate(kept)}
        checks = [
            check
            for prefix, text in seen.items()
            for check in checks_for(prefix, text, path, scratch, source_line)
        ]

    rest = next((index for index, (_, line) in enumerate(kept) if SPLIT.match(line)), len(kept))
    path.write_text(layout([line for _, line in kept], checks, rest, comment))
    return path.read_text() != old


def layout(source, checks, rest, comment):
    """The new text: `source` with each check above its line, and those without one above line `rest`."""
    out = []  # source lines as (index, text), checks as (prefix, Check)
    for index in range(len(source) + 1):
        here = [(prefix, check) for where, prefix, check in checks if where == index]
        rest_here = (
            [(prefix, check) for where, prefix, check in checks if where is None]
            if index == rest
            else []
        )
        previous = None
        for prefix, check in rest_here:
            if prefix != previous and out and out[-1][1] != "":
                out.append((None, ""))
            out.append((prefix, check))
            previous = prefix
        if rest_here and index < len(source):
            out.append((None, ""))
        out += here
        if index < len(source):
            out.append((index, source[index]))
    number_of = {key: number for number, (key, _) in enumerate(out, 1) if isinstance(key, int)}
    text = []
    for number, (key, what) in enumerate(out, 1):
        if isinstance(what, Check):
            shown = what.text
            if what.line is not None:
                shown = shown.replace("\0", f"[[#@LINE{number_of[what.line] - number:+d}]]")
            what = f"{comment}{key}{what.directive}: {shown}".rstrip()
        text.append(what)
    return "\n".join(text) + "\n"


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--clipc", type=pathlib.Path, default=TESTDATA.parent / "build/release/bin/clipc"
    )
    parser.add_argument("files", type=pathlib.Path, nargs="*")
    arguments = parser.parse_args()
    files = [file.resolve() for file in arguments.files]
    if not files:
        files = sorted(
            f
            for f in TESTDATA.rglob("*")
            if f.suffix in {".hlsl", ".test"} and "AUTOUPDATE" in f.read_text(errors="replace")
        )
    refused = False
    for file in files:
        try:
            if update(file, arguments.clipc.resolve(), bool(arguments.files)):
                print(f"updated {file}")
        except Refusal as refusal:
            print(f"{file}: {refusal}", file=sys.stderr)
            refused = True
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main())
