#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes the pages of the diagnostics: one for each chapter of the catalogue, and README.md, which lists them.

    diagnostic_pages.py FOLDER [CLIPC]

A page has the explanations of compiler/compile/explanations/, and what CLIPC prints about each example; without
CLIPC it is without that."""

import itertools
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
CATALOGUE = ROOT / "base/diagnostic_kinds.def"
PAGE = ROOT / "docs/diagnostics.md"

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
    """(section, name, severity, fxc code, format) of every kind, in the order of the CATALOGUE."""
    section = ""
    text = CATALOGUE.read_text()
    heads = [(m.start(), m.group(1)) for m in re.finditer(r"^// ---- (.*)$", text, re.M)]
    for m in DIAG.finditer(text):
        section = next((title for start, title in reversed(heads) if start < m.start()), "")
        yield section, m.group(1), m.group(2).lower(), m.group(3), unquoted(m.group(4))


def explanations():
    """(name, rule, options and text of an example, those of the fixed one) of each explained kind."""
    list_of_files = (ROOT / "compiler/compile/explanations.def").read_text()
    files = re.findall(r'^#include "(.*)"$', list_of_files, re.M)
    text = "\n".join((ROOT / file).read_text() for file in files)
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


# No user sees these: what would bring them about is refused before.
NOT_SEEN = {"InitListAsValue", "SwitchWithoutBlock", "TargetClipVertex"}

HOW = """A message ends with its name in brackets: `[-Wclip-plane-repeated]` after a warning, `[clip-plane-not-float4, X3084]`
after an error. The code is fxc's for the same rule, if fxc has one. `-Wno-NAME` switches a warning off, `-WNAME` switches it on
again, and `-Werror` turns all warnings into errors.
"""

PAGES = f"""# Diagnostics

Everything that clipc reports about a shader: a page for each chapter. `clipc --explain NAME` prints the same.

{HOW}"""


def anchor(title):
    """The name of a chapter's page, and the anchor of a headline as GitHub makes it."""
    return re.sub(r"[^\w-]", "", title.lower().replace(" ", "-"))


def chapters(all_kinds):
    """The kinds that a user can see, by the chapter of the catalogue."""
    found = {}
    for section, name, severity, code, message in all_kinds:
        if severity != "note" and name not in NOT_SEEN:
            title = section[:1].upper() + section[1:]
            found.setdefault(title, []).append((name, severity, code, message))
    return found


def contents(found):
    """The page of the lists: the chapters, the names by their first letter, and fxc's codes."""
    pages = {name: anchor(title) for title, rows in found.items() for name, *_ in rows}
    link = lambda name: f"[`{printed(name)}`]({pages[name]}.md#{printed(name)})"
    yield PAGES
    yield "## Chapters\n"
    for title, rows in found.items():
        yield f"- [{title}]({anchor(title)}.md): {len(rows)} kinds"
    yield "\n## By name\n"
    for letter, group in itertools.groupby(sorted(pages, key=printed), key=lambda name: name[0]):
        yield f"- {letter}: {', '.join(map(link, group))}"
    codes = {}
    for rows in found.values():
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


def chapter(title, rows, outputs):
    """The page of a chapter: a table of its messages, in which `{}` stands for what was seen, and its explanations."""
    pages = {name: explanation for name, *explanation in explanations()}
    yield f"# {title}\n\nIn the messages, `{{}}` stands for what was seen. [All chapters](README.md)\n"
    yield "| name | kind | fxc | message |\n|---|---|---|---|"
    for name, severity, code, message in rows:
        cell = message.replace("|", "\\|").replace("{{", "{").replace("}}", "}")
        yield f"| [`{printed(name)}`](#{printed(name)}) | {severity} | {code} | {cell} |"
    for name, severity, code, _ in rows:
        if name in pages:
            yield from explained(name, severity, code, pages[name], outputs.get(name, ""))


def write_pages(folder, found, outputs):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "README.md").write_text("\n".join(contents(found)) + "\n")
    for title, rows in found.items():
        page = folder / f"{anchor(title)}.md"
        page.write_text("\n".join(chapter(title, rows, outputs)) + "\n")


def link_from(page):
    """Makes the sentence about a package's pages, in the copy of docs/diagnostics.md that lies in the package, a link to them."""
    text = page.read_text()
    linked, count = re.subn(
        r"A package has all of that as pages, one a chapter, in `\S+`\. In the sources,\s+`[^`]+` writes them\.",
        "[The chapters](diagnostics/README.md) have all of that as pages.",
        text,
    )
    assert count == 1 or "(diagnostics/README.md)" in text, page
    page.write_text(linked)


def main():
    if len(sys.argv) not in {2, 3}:
        sys.exit(__doc__)
    outputs = try_explanations(pathlib.Path(sys.argv[2]).resolve())[0] if len(sys.argv) == 3 else {}
    folder = pathlib.Path(sys.argv[1]).resolve()
    write_pages(folder, chapters(kinds()), outputs)
    page = folder.parent / "diagnostics.md"
    if page.is_file() and not page.samefile(PAGE):
        link_from(page)


if __name__ == "__main__":
    main()
