# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares what the examples of a page print with what the page shows.

A block of `console` has commands, each after `$ `, and what they print. A line `...` stands for any lines, and `...` in a line for any
text. A command fails exactly where an error is shown.

A table whose first heading is a command in backticks and `with` has options in its first column; "or" is between alternatives. Each line
of code in the second column is in what the command prints with these options, and not in what it prints without them. After "no " it
is the other way round, and after "still " the line is in both.
"""

import re
import shlex
import subprocess

BLOCK = re.compile(r"^```console\n(.*?)^```$", re.M | re.S)
TABLE = re.compile(r"^\| `([^`]+)` with \|.*\n\|[-|]+\n((?:\|.*\n)+)", re.M)
FAILURE = re.compile(r"(?:: |\): |: \")error\b|\d+ of \d+ failed")  # in text, msvc's form or JSON
CELL = re.compile(r"(?<!\\)\|")


def commands(block):
    """(command, the lines that it prints) of each in a block."""
    for part in re.split(r"^\$ ", block, flags=re.M)[1:]:
        command, _, lines = part.partition("\n")
        yield command, lines


def printed(command, folder, path):
    """The exit code and what is printed. With --watch a command is interrupted after a second."""
    if "--watch" in command:
        command = f"timeout --preserve-status -s INT 1 {command}"
    done = subprocess.run(
        ["bash", "-c", command],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        stdin=subprocess.DEVNULL,
        text=True,
        check=False,
        timeout=120,
        env={"PATH": path, "LC_ALL": "C.UTF-8"},
    )
    return done.returncode, done.stdout


def is_shown(shown, text):
    """Whether a text is what a page shows of it."""
    pattern = re.escape(shown)
    pattern = re.sub(r"^\\\.\\\.\\\.\n", "(?:.*\n)*?", pattern.replace("\\\n", "\n"), flags=re.M)
    pattern = pattern.replace(r"\.\.\.", ".*")
    return re.fullmatch(pattern, text) is not None


def check_block(run, page, block, folder):
    for command, shown in commands(block):
        code, text = printed(command, folder, run.path)
        fails = re.search(FAILURE, shown) is not None
        if not is_shown(shown, text) or (code != 0) != fails:
            run.problems.append(
                f"{page.name}: `{command}`, exit code {code}, prints\n{text[:2000]}"
            )
        run.show(shlex.split(command))


def check_row(run, page, base, options, effect, folder):
    code, text = printed(f"{base} {options}", folder, run.path)
    lines = [line.strip() for line in text.splitlines()]
    before = [line.strip() for line in printed(base, folder, run.path)[1].splitlines()]
    shown = re.findall(r"(no |still )?`([^`]+)`", effect)
    for word, line in shown:
        if (line in lines, line in before) != (word != "no ", word != ""):
            run.problems.append(f"{page.name}: `{line}` with `{options}`, which prints\n{text}")
    if code != 0 or not shown:
        run.problems.append(f"{page.name}: `{base} {options}` is {code}, or shows nothing")
    run.show(shlex.split(options))


def check_table(run, page, base, rows, folder):
    for row in rows.splitlines():
        options, effect = (cell.replace(r"\|", "|") for cell in CELL.split(row)[1:3])
        for alternative in options.split(" or "):
            words = " ".join(re.findall("`([^`]+)`", alternative))
            check_row(run, page, base, words, effect, folder)


def check_transcripts(run, page, folder):
    """Runs the blocks and the tables of a page, in their order."""
    text = page.read_text()
    found = [*BLOCK.finditer(text), *TABLE.finditer(text)]
    for match in sorted(found, key=lambda match: match.start()):
        if match.re is BLOCK:
            check_block(run, page, match[1], folder)
        else:
            check_table(run, page, match[1], match[2], folder)
