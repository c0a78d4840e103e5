# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The parts of a listing: its profile, its tables and its instructions."""

import re

COMPONENTS = "xyzw"
CODE = re.compile(
    r"^(?: {4}|/ {4})?(ps_[1-5]_[0-9a-z]+)[ \t]*\n(.*?)(?=^// [Aa]pprox|^#endif|\Z)", re.M | re.S
)
ROW = re.compile(
    r"^// (\w+)\s+(\d+)\s+([xyzw]+|N/A)\s+(\w+)\s+([A-Za-z]\w*)\s+(\w+)(?:[ \t]+([xyzw ]*|YES))?$"
)
BINDING = re.compile(
    r"^// (\S+)\s+(sampler|texture|cbuffer)\s+\S+\s+\S+\s+(?:\S+\s+)??[a-z]*(\d+)(?:,space\d+)?\s+\d+ *$",
    re.M,
)
LEVEL_9_BUFFER = re.compile(r"^// c(\d+)\s+cb(\d+)\s+(\d+)\s+(\d+)\s+\(([\w, ]+)\)$", re.M)
LEVEL_9_SAMPLER = re.compile(r"^// s(\d+)\s+s(\d+)\s+t(\d+)$", re.M)
REGISTER = re.compile(r"^//\s+(\S+)\s+([csbi])(\d+)\s+(\d+)\s*$", re.M)


class NotRun(Exception):
    """What these tools do not draw."""


def split(text):
    """The operands of an instruction: commas in parentheses and brackets do not count."""
    parts, depth = [""], 0
    for c in text:
        depth += (c in "([") - (c in ")]")
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    return [part.strip() for part in parts if part.strip()]


def swizzled(swizzle):
    """Four components of a swizzle: the last one is repeated."""
    swizzle = swizzle or COMPONENTS
    return swizzle.ljust(4, swizzle[-1])


class Row:
    """A row of a signature."""

    def __init__(self, fields):
        self.name, index, self.mask, self.register, self.system, self.format, used = fields
        self.index = int(index)
        self.used = bool((used or "").strip())
        self.is_float = self.format in ("float", "min16f", "min2_8f")


def listings_of(text, entry):
    """The listings of the entry: one, or that of level 9 and that of ps_4_0."""
    text = text.replace("\r", "")
    # A header has a listing before each array of bytes.
    before = re.split(rf"const BYTE g_\w*{entry}\[\]", text)
    if len(before) > 1:
        text = before[0][max(before[0].rfind("#if 0"), 0) :]
    codes = CODE.findall(text)
    if not codes:
        raise NotRun("no listing of a pixel shader")
    return [Listing(text, profile, code, len(codes) > 1) for profile, code in codes]


class Listing:
    def __init__(self, text, profile, code, is_one_of_two):
        self.text = text
        self.profile = profile
        self.major = int(profile[3])
        self.is_level_9 = is_one_of_two and self.major < 4
        # An array of constants extends over lines.
        one_line = re.sub(
            r"dcl_immediateConstantBuffer.*?\}\s*\}",
            lambda rows: rows[0].replace("\n", " "),
            code,
            flags=re.S,
        )
        lines = [line.split("//")[0].strip() for line in one_line.splitlines()]
        self.lines = [line for line in lines if line]

    def rows(self, title):
        """The rows of a signature."""
        start = self.text.find(f"// {title} signature:")
        found = []
        for line in self.text[start:].splitlines()[1:] if start >= 0 else []:
            if row := ROW.match(line):
                if row[1] != "Name":
                    found.append(Row(row.groups()))
            elif "signature:" in line or not line.startswith("//"):
                break
        return found

    def bindings(self):
        """The numbers of samplers, textures and buffers, by their kind and name."""
        return {(kind, name): int(number) for name, kind, number in BINDING.findall(self.text)}

    def registers(self):
        """Rows of name, kind, number and count, of Direct3D 9's table of constants."""
        return [
            (name, kind, int(number), int(count))
            for name, kind, number, count in REGISTER.findall(self.text)
        ]

    def reads_inputs(self):
        return any(re.match(r"dcl_input|dcl(_\w+)? [vt]", line) for line in self.lines)
