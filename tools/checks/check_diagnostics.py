#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds the catalogue of diagnostics against its document and its tests.

    check_diagnostics.py [--write] [--coverage] [--explanations CLIPC]

Fails when two kinds share a name, when one has no explanation in compiler/compile/explanations/, but those that
no user sees, or, with --coverage, when no test expects a kind. A test expects a kind where
its printed name is as clipc prints it: in brackets after a message (`[-Wclip-plane-repeated]`,
`[clip-plane-not-float4, X3084]`), as the code of the msvc form, or as a name of the JSON form, which
is the only one that names notes.

With --explanations, clipc must report the kind about each example of an explanation, and accept the fixed
one without it. docs/diagnostics.md must then be what base/diagnostic_kinds.def and the explanations say,
with what clipc prints about each example; --write makes it so."""

import itertools
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
catalogue = root / "base/diagnostic_kinds.def"
document = root / "docs/diagnostics.md"

DIAG = re.compile(
    r'^DIAG\((\w+), k(Note|Warning|Error), "(\w*)",\s*((?:"(?:[^"\\]|\\.)*"\s*)+)', re.M
)
EXPLANATION = re.compile(
    r'^(?:EXPLANATION|RULE)\((\w+),\s*((?:"(?:[^"\\]|\\.)*"\s*)+)'
    r'(?:,\s*"([^"]*)", R"\((.*?)\)",\s*"([^"]*)", (?:R"\((.*?)\)"|""))?\)$',
    re.M | re.S,
)
STRING = re.compile(r'"((?:[^"\\]|\\.)*)"')


def unquoted(literals):
    """The text of C++ string literals that follow each other."""
    return "".join(STRING.findall(literals)).replace('\\"', '"').replace("\\\\", "\\")


def kinds():
    """(section, name, severity, fxc code, format) of every kind, in the order of the catalogue."""
    section = ""
    text = catalogue.read_text()
    heads = [(m.start(), m.group(1)) for m in re.finditer(r"^// ---- (.*)$", text, re.M)]
    for m in DIAG.finditer(text):
        section = next((title for start, title in reversed(heads) if start < m.start()), "")
        yield section, m.group(1), m.group(2).lower(), m.group(3), unquoted(m.group(4))


def explanations():
    """(name, rule, options and text of an example, those of the fixed one) of each explained kind."""
    list_of_files = (root / "compiler/compile/explanations.def").read_text()
    files = re.findall(r'^#include "(.*)"$', list_of_files, re.M)
    text = "\n".join((root / file).read_text() for file in files)
    found = list(EXPLANATION.finditer(text))
    if len(found) != len(re.findall(r"^(?:EXPLANATION|RULE)\(", text, re.M)):
        sys.exit("compiler/compile/explanations: a row was not understood")
    for name, rule, options, example, fixed_options, fixed in (m.groups() for m in found):
        yield name, unquoted(rule), options, example, fixed_options, fixed


def compiled(clipc, words, text):
    """What clipc does with a shader that is x.hlsl. A line `// x.frag:` begins another file."""
    with tempfile.TemporaryDirectory() as folder:
        parts = re.split(r"^// (\w+\.\w+):\n", text, flags=re.M)
        for name, part in zip(["x.hlsl", *parts[1::2]], parts[0::2]):
            pathlib.Path(folder, name).write_text(part.rstrip("\n") + "\n")
        output = "." if "--effect" in words else "x.out"
        return subprocess.run(
            [clipc, "x.hlsl", "-o", output, *words.split()],
            cwd=folder,
            capture_output=True,
            text=True,
            check=False,
        )


def try_explanations(clipc):
    """What clipc prints about each example, by the kind; and the mistakes: what it does not report
    about an example, or reports about a fixed one."""
    outputs, mistakes = {}, []
    for name, _, options, example, fixed_options, fixed in explanations():
        if example is None:
            continue
        said = re.compile(rf"\[(-W)?{printed(name)}[],]")
        outputs[name] = compiled(clipc, options, example).stderr
        if not said.search(outputs[name]):
            mistakes.append(f"{name}: `{options}` says\n{outputs[name]}")
        done = compiled(clipc, fixed_options, fixed or example)
        if done.returncode or said.search(done.stderr):
            mistakes.append(f"{name}, fixed: `{fixed_options}` says\n{done.stderr}")
    return outputs, mistakes


def printed(name):
    return re.sub(r"(?<!^)([A-Z])", r"-\1", name).lower()


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

# No user sees these: what would bring them about is refused before.
NOT_SEEN = {"InitListAsValue", "SwitchWithoutBlock", "TargetClipVertex"}

HEAD = """# Diagnostics

Everything that clipc reports about a shader. A message ends with its name in brackets: `[-Wclip-plane-repeated]` after a warning,
`[clip-plane-not-float4, X3084]` after an error. The code is fxc's for the same rule, if fxc has one. `clipc --explain NAME` and
`clipc --explain CODE` print the explanations below.

`-Wno-NAME` switches a warning off, `-WNAME` switches it on again, and `-Werror` turns all warnings into errors. In the tables, `{}`
stands for what was seen.
"""


def link(name):
    return f"[`{printed(name)}`](#{printed(name)})"


def anchor(title):
    """The anchor of a headline, as GitHub makes it."""
    return re.sub(r"[^\w-]", "", title.lower().replace(" ", "-"))


def contents(sections):
    """The lists at the top: the groups, the names by their first letter, and fxc's codes."""
    yield "## Contents\n"
    for title, rows in sections.items():
        yield f"- [{title}](#{anchor(title)}): {len(rows)} kinds"
    yield "- [By name](#by-name)"
    yield "- [By fxc's code](#by-fxcs-code)"
    names = sorted((name for rows in sections.values() for name, *_ in rows), key=printed)
    yield "\n## By name\n"
    for letter, group in itertools.groupby(names, key=lambda name: name[0]):
        yield f"- {letter}: {', '.join(map(link, group))}"
    codes = {}
    for rows in sections.values():
        for name, _, code, _ in rows:
            if code:
                codes.setdefault(code, []).append(name)
    yield "\n## By fxc's code\n"
    for code, group in sorted(codes.items()):
        yield f"- {code}: {', '.join(map(link, group))}"


def explained(name, severity, code, explanation, output):
    """The section of a kind: the rule, the example with what clipc prints, and the fixed one."""
    rule, options, broken, fixed_options, fixed = explanation
    kind = "An error" if severity == "error" else "A warning"
    of_fxc = f", fxc's {code}" if code else ""
    yield f"\n### {printed(name)}\n\n{kind}{of_fxc}. {rule}"
    if broken is None:
        return
    command = f"// clipc x.hlsl {options}".rstrip()
    yield f"\n```text\n{command}\n{broken}\n\n{output.rstrip()}\n```"
    command = f"// clipc x.hlsl {fixed_options}".rstrip()
    title, text = ("Fixed", f"\n{fixed}") if fixed else ("Fixed, with the same file", "")
    yield f"\n{title}:\n\n```text\n{command}{text}\n```"


def render(all_kinds, outputs):
    sections = {}
    for section, name, severity, code, message in all_kinds:
        if severity != "note" and name not in NOT_SEEN:
            title = section[:1].upper() + section[1:]
            sections.setdefault(title, []).append((name, severity, code, message))
    pages = {name: explanation for name, *explanation in explanations()}
    lines = [HEAD, *contents(sections)]
    for title, rows in sections.items():
        lines += [f"\n## {title}\n", "| name | kind | fxc | message |", "|---|---|---|---|"]
        for name, severity, code, message in rows:
            cell = message.replace("|", "\\|").replace("{{", "{").replace("}}", "}")
            lines.append(f"| {link(name)} | {severity} | {code} | {cell} |")
        for name, severity, code, _ in rows:
            if name in pages:
                lines += explained(name, severity, code, pages[name], outputs.get(name, ""))
    return "\n".join(lines) + "\n"


# A printed name in an expected message.
EXPECTED = re.compile(
    r'\[(?:-Werror,)?(?:-W)?([a-z0-9-]+)(?=[],])|: (?:error|warning) ([a-z0-9-]+):|"name": "([a-z0-9-]+)"'
)


def expected_names():
    """Every name that a line of a test expects, except in the RUN lines."""
    tests = [
        file for file in sorted((root / "testdata").rglob("*")) if file.suffix in {".hlsl", ".test"}
    ]
    tests += [
        file
        for file in sorted(root.rglob("*_test.cpp"))
        if "build" not in file.relative_to(root).parts
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
    declared = len(re.findall(r"^DIAG\(", catalogue.read_text(), re.M))
    if declared != len(all_kinds):
        problems.append(f"{declared} kinds are declared but {len(all_kinds)} were understood")
    problems += [
        f"{name}: compiler/compile/explanations has no page of `{printed(name)}`"
        for name in unexplained(all_kinds)
    ]
    if "--explanations" in sys.argv:
        clipc = pathlib.Path(sys.argv[sys.argv.index("--explanations") + 1]).resolve()
        outputs, mistakes = try_explanations(clipc)
        problems += mistakes
        text = render(all_kinds, outputs)
        if "--write" in sys.argv:
            document.write_text(text)
        elif not document.exists() or document.read_text() != text:
            problems.append(
                "docs/diagnostics.md is out of date: run tools/checks/check_diagnostics.py "
                "--write --explanations CLIPC"
            )
    if "--coverage" in sys.argv:
        problems += [f"{name}: no test expects `{printed(name)}`" for name in untested(all_kinds)]
    print("\n".join(problems) or f"{len(all_kinds)} kinds of diagnostics, each documented")
    return bool(problems)


sys.exit(main())
