#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds the catalogue of diagnostics against its document and its tests.

    check_diagnostics.py [--write] [--coverage]

Fails when docs/diagnostics.md is not what base/diagnostic_kinds.def says (--write makes it so), when two kinds share a
name, or, with --coverage, when a kind's message occurs in no test: the longest literal piece of its format must stand
in a file under testdata/ or in a *_test.cpp."""
import pathlib
import re
import sys

root = pathlib.Path(__file__).resolve().parents[2]
catalogue = root / "base/diagnostic_kinds.def"
document = root / "docs/diagnostics.md"

DIAG = re.compile(r'^DIAG\((\w+), k(Note|Warning|Error), "(\w*)",\s*((?:"(?:[^"\\]|\\.)*"\s*)+)', re.M)
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


def kinds():
    """(section, name, severity, fxc code, format) of every kind, in the order of the catalogue."""
    section = ""
    text = catalogue.read_text()
    heads = [(m.start(), m.group(1)) for m in re.finditer(r"^// ---- (.*)$", text, re.M)]
    for m in DIAG.finditer(text):
        section = next((title for start, title in reversed(heads) if start < m.start()), "")
        message = "".join(STRING.findall(m.group(4))).replace('\\"', '"').replace("\\\\", "\\")
        yield section, m.group(1), m.group(2).lower(), m.group(3), message


def printed(name):
    return re.sub(r"(?<!^)([A-Z])", r"-\1", name).lower()


def render(all_kinds):
    lines = [
        "# Diagnostics",
        "",
        "Everything clipc can say about a shader, from `base/diagnostic_kinds.def` by `tools/checks/check_diagnostics.py --write`.",
        "`{}` stands for what was seen. `-Wno-NAME` switches a warning off, `-WNAME` on again; `-Werror` makes errors of all.",
        "The code is fxc's for the same rule.",
    ]
    current = None
    for section, name, severity, code, message in all_kinds:
        if severity == "note":
            continue
        if section != current:
            lines += ["", f"## {section[:1].upper()}{section[1:]}", "", "| name | | fxc | message |", "|---|---|---|---|"]
            current = section
        cell = message.replace("|", "\\|")
        lines.append(f"| `{printed(name)}` | {severity} | {code} | {cell} |")
    return "\n".join(lines) + "\n"


# Nets below others: the parser or the driver says what is wrong before these could, or only a fault of clipc's brings them.
NOT_PROVOKED = {"InvalidGlsl", "InternalError", "InitListAsValue", "SwitchWithoutBlock", "TargetClipVertex"}


def untested(all_kinds):
    texts = [p.read_text(errors="replace") for p in sorted((root / "testdata").rglob("*")) if p.is_file()]
    texts += [p.read_text() for p in sorted(root.rglob("*_test.cpp")) if "build" not in p.relative_to(root).parts]
    corpus = "\n".join(texts)
    for _, name, _, _, message in all_kinds:
        pieces = [piece.strip(" `;") for piece in re.split(r"\{[^{}]*\}", message.replace("{{", "{").replace("}}", "}"))]
        longest = max(pieces, key=len)
        if name not in NOT_PROVOKED and longest and longest not in corpus:
            yield name, longest


def main():
    all_kinds = list(kinds())
    problems = []
    names = [name for _, name, *_ in all_kinds]
    problems += [f"{name}: listed twice" for name in sorted(set(names)) if names.count(name) > 1]
    declared = len(re.findall(r"^DIAG\(", catalogue.read_text(), re.M))
    if declared != len(all_kinds):
        problems.append(f"{declared} kinds are declared but {len(all_kinds)} were understood")
    text = render(all_kinds)
    if "--write" in sys.argv:
        document.write_text(text)
    elif not document.exists() or document.read_text() != text:
        problems.append("docs/diagnostics.md is out of date: run tools/checks/check_diagnostics.py --write")
    if "--coverage" in sys.argv:
        problems += [f"{name}: no test shows `{piece}`" for name, piece in untested(all_kinds)]
    print("\n".join(problems) or f"{len(all_kinds)} kinds of diagnostics, each documented")
    return bool(problems)


sys.exit(main())
