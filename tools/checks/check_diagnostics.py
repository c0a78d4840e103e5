#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds the catalogue of diagnostics against its document and its tests.

    check_diagnostics.py [--write] [--coverage] [--examples CLIPC] [--explanations CLIPC]

Fails when docs/diagnostics.md is not what base/diagnostic_kinds.def says (--write makes it so), when
two kinds share a name, or, with --coverage, when no test expects a kind. A test expects a kind where
its printed name stands as clipc prints it: in brackets after a message (`[-Wclip-plane-repeated]`,
`[clip-plane-not-float4, X3084]`), as the code of the msvc form, or as a name of the JSON form, which
is the only one that names notes.

Each section of the document has an example, tools/checks/snippets/diagnostics/SECTION.hlsl, whose first line is its command, and
SECTION.txt, what clipc prints: --examples holds it against that, and writes it with --write.
Each kind has an explanation in compiler/explanations/, but those that no user sees. With --explanations,
clipc must report the kind about each example there, and accept the fixed one without it."""

import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parents[2]
catalogue = root / "base/diagnostic_kinds.def"
document = root / "docs/diagnostics.md"
examples = root / "tools/checks/snippets/diagnostics"

DIAG = re.compile(
    r'^DIAG\((\w+), k(Note|Warning|Error), "(\w*)",\s*((?:"(?:[^"\\]|\\.)*"\s*)+)', re.M
)
EXPLANATION = re.compile(
    r'^(?:EXPLANATION|RULE)\((\w+),\s*((?:"(?:[^"\\]|\\.)*"\s*)+)'
    r'(?:,\s*"([^"]*)", R"\((.*?)\)",\s*"([^"]*)", (?:R"\((.*?)\)"|""))?\)$',
    re.M | re.S,
)
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


def explanations():
    """(name, rule, options and text of an example, those of the fixed one) of each explained kind."""
    list_of_files = (root / "compiler/explanations.def").read_text()
    files = re.findall(r'^#include "(.*)"$', list_of_files, re.M)
    text = "\n".join((root / file).read_text() for file in files)
    found = list(EXPLANATION.finditer(text))
    if len(found) != len(re.findall(r"^(?:EXPLANATION|RULE)\(", text, re.M)):
        sys.exit("compiler/explanations: a row was not understood")
    for name, rule, options, example, fixed_options, fixed in (m.groups() for m in found):
        yield name, "".join(STRING.findall(rule)), options, example, fixed_options, fixed


def wrong_explanations(clipc):
    """What clipc does not report about an example, or reports about a fixed one."""
    for name, _, options, example, fixed_options, fixed in explanations():
        if example is None:
            continue
        said = re.compile(rf"\[(-W)?{printed(name)}[],]")
        for words, text, is_wrong in (
            (options, example, True),
            (fixed_options, fixed or example, False),
        ):
            with tempfile.TemporaryDirectory() as folder:
                pathlib.Path(folder, "x.hlsl").write_text(text + "\n")
                done = subprocess.run(
                    [clipc, "x.hlsl", *words.split(), "-o", "x.out"],
                    cwd=folder,
                    capture_output=True,
                    text=True,
                    check=False,
                )
            if bool(said.search(done.stderr)) != is_wrong or (done.returncode and not is_wrong):
                yield f"{name}: `{words}` says\n{done.stderr}"


def printed(name):
    return re.sub(r"(?<!^)([A-Z])", r"-\1", name).lower()


def example(section):
    """The lines of the section's example."""
    file = examples / (re.sub(r"[^a-z0-9]+", "-", section.lower()) + ".hlsl")
    shader, printed_text = file.read_text().strip(), file.with_suffix(".txt").read_text().strip()
    return ["```text", *shader.splitlines(), "", *printed_text.splitlines(), "```", ""]


def wrong_examples(clipc, write):
    """Compiles each example. Yields those that print something else, unless they are written."""
    for file in sorted(examples.glob("*.hlsl")):
        with tempfile.TemporaryDirectory() as folder:
            text = file.read_text()
            (pathlib.Path(folder) / "water.hlsl").write_text(text)
            words = shlex.split(text.splitlines()[0].removeprefix("// clipc "))
            done = subprocess.run(
                [clipc, *words], cwd=folder, capture_output=True, text=True, check=False
            )
        kept = file.with_suffix(".txt")
        if write:
            kept.write_text(done.stderr)
        elif done.stderr != kept.read_text():
            yield f"{file.name}: clipc prints\n{done.stderr}"


def render(all_kinds):
    lines = [
        "# Diagnostics",
        "",
        "Everything clipc can say about a shader, from `base/diagnostic_kinds.def` by `tools/checks/check_diagnostics.py --write`.",
        "A message ends with its name in brackets: `[-Wclip-plane-repeated]` after a warning, `[clip-plane-not-float4, X3084]`",
        "after an error, with fxc's code for the same rule where fxc has one. `{}` stands for what was seen.",
        "`-Wno-NAME` switches a warning off, `-WNAME` switches it on again, `-Werror` turns all warnings into errors.",
    ]
    pages = {name for name, *_ in explanations()}
    current = None
    for section, name, severity, code, message in all_kinds:
        if severity == "note":
            continue
        if section != current:
            lines += [
                "",
                f"## {section[:1].upper()}{section[1:]}",
                "",
                *example(section),
                "| name | | fxc | message |",
                "|---|---|---|---|",
            ]
            current = section
        cell = message.replace("|", "\\|")
        cell_of_name = (
            f"[`{printed(name)}`](#{printed(name)})" if name in pages else f"`{printed(name)}`"
        )
        lines.append(f"| {cell_of_name} | {severity} | {code} | {cell} |")
    lines += ["", "## Explained", "", "`clipc --explain NAME` prints these pages too.", ""]
    for name, rule, options, broken, fixed_options, fixed in explanations():
        lines += [f"### {printed(name)}", "", rule]
        if broken is None:
            lines.append("")
            continue
        for what, words, shader in (
            ("Example:", options, [broken]),
            ("Fixed:", fixed_options, [fixed] if fixed else []),
        ):
            command = f"// clipc x.hlsl {words}".rstrip()
            lines += ["", what, "", "```text", command, *shader, "```"]
        lines.append("")
    return "\n".join(lines)


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
    if "--examples" in sys.argv:
        clipc = pathlib.Path(sys.argv[sys.argv.index("--examples") + 1]).resolve()
        problems += wrong_examples(clipc, "--write" in sys.argv)
    problems += [
        f"{name}: compiler/explanations has no page of `{printed(name)}`"
        for name in unexplained(all_kinds)
    ]
    text = render(all_kinds)
    if "--write" in sys.argv:
        document.write_text(text)
    elif not document.exists() or document.read_text() != text:
        problems.append(
            "docs/diagnostics.md is out of date: run tools/checks/check_diagnostics.py --write"
        )
    if "--explanations" in sys.argv:
        clipc = sys.argv[sys.argv.index("--explanations") + 1]
        problems += wrong_explanations(pathlib.Path(clipc).resolve())
    if "--coverage" in sys.argv:
        problems += [f"{name}: no test expects `{printed(name)}`" for name in untested(all_kinds)]
    print("\n".join(problems) or f"{len(all_kinds)} kinds of diagnostics, each documented")
    return bool(problems)


sys.exit(main())
