#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds the offsets that clipc reflects against Direct3D's packing rules, worked out here once more.

usage: check_packing.py CLIPC LIST                      a corpus: lines as compare_corpus.py has them
       check_packing.py CLIPC --shader FILE [options]   one shader, with clipc's options

The rules ("Packing rules for constant variables" in Microsoft's documentation, and the HLSL specification's "Constant Buffer
Layout"): memory is rows of sixteen bytes; no scalar or vector lies in two rows; arrays, structs and matrices of several
registers begin a row; so does each element of an array and each register of a matrix, but nothing is added behind the last one.
Types, dimensions and structs are read from --dump=ir, offsets and sizes from --reflect.
"""
import json
import re
import subprocess
import sys
import tempfile

ROW = 16
NUMERIC = re.compile(r"(bool|int|uint|float|half|double|int64_t|uint64_t|min\w+?)([1-4])?(?:x([1-4]))?$")
MEMBER = re.compile(r"((?:row_major |precise )*)(<unnamed struct>|\S+) ([^\s\[]+)((?:\[\d+\])*)(?: : \S+)?(?: [a-z]+)*(?: at \d+, \d+ bytes( explicit)?)?$")
BUFFERS = {"cbuffer", "tbuffer", "globals", "params", "constant_buffer"}


def round_up(value, multiple):
    return (value + multiple - 1) // multiple * multiple


class Ambiguous(Exception):
    """Several structs have that name."""


class Value:
    """A type as it lies in memory: its size, what its first byte must be a multiple of, and whether it must begin a row."""

    def __init__(self, size, alignment=4, begins_row=False):
        self.size, self.alignment, self.begins_row = size, alignment, begins_row

    def place(self, end):
        """Where it goes when what stands before it ends at `end`."""
        if self.begins_row:
            return round_up(end, ROW)
        at = round_up(end, self.alignment)
        return round_up(at, ROW) if at // ROW != (at + self.size - 1) // ROW and at % ROW else at


def array_of(value, count):
    return Value((count - 1) * round_up(value.size, ROW) + value.size, ROW, True) if count else Value(0)


def numeric(match, row_major):
    kind, first, second = match[1], int(match[2] or 1), int(match[3] or 0)
    unit = 8 if kind in ("double", "int64_t", "uint64_t") else 4
    if not second:
        return Value(unit * first, unit)
    registers, length = (first, second) if row_major else (second, first)
    register = Value(unit * length, unit)
    return register if registers == 1 else array_of(register, registers)


def struct(fields, structs):
    end = 0
    for field in fields:
        value = value_of(*field, structs)
        end = value.place(end) + value.size
    return Value(end, ROW, True)


def value_of(type_name, counts, row_major, structs):
    if counts:
        return array_of(value_of(type_name, counts[1:], row_major, structs), counts[0])
    match = NUMERIC.match(type_name)
    if match:
        return numeric(match, row_major)
    if any(other != structs[type_name][0] for other in structs[type_name]):
        raise Ambiguous
    return struct(structs[type_name][0], structs)


def parse(ir):
    """Lists of structs by name, and buffers by name with (name, type, dimensions, row_major, explicit) for each member."""
    structs, buffers, into, is_struct = {}, {}, None, False
    for line in ir.splitlines():
        words = line.split()
        if line.startswith("}"):
            into = None
        elif line.startswith("struct "):
            structs.setdefault(line[len("struct "):-2], []).append([])
            into, is_struct = structs[line[len("struct "):-2]][-1], True
        elif words and words[0] in BUFFERS and line.endswith("{"):
            into, is_struct = buffers.setdefault(words[1], []), False
        elif into is not None:
            match = MEMBER.match(line.strip())
            counts = [int(count) for count in re.findall(r"\d+", match[4])]
            field = (match[2], counts, "row_major" in match[1])
            into.append(field if is_struct else (match[3], *field, bool(match[5])))
    return structs, buffers


def parse_lines(ir):
    """Lines of the program before its first input, output or function: declarations only."""
    lines = []
    for line in ir.splitlines():
        if re.match(r"(input|output|entry|main|static|const|resource)\b", line):
            break
        lines.append(line)
    return "\n".join(lines)


def problems(ir, reflection):
    structs, buffers = parse(parse_lines(ir))
    members = 0
    found = []
    for cbuffer in reflection["cbuffers"]:
        declared = buffers[cbuffer["name"]]
        is_constant_buffer = cbuffer["kind"] == "ConstantBuffer"
        explicit = [m for m, d in zip(cbuffer["members"], declared) if d[4]]
        end = max((m["offset"] + m["size"] for m in explicit), default=0)
        for reflected, (name, type_name, counts, row_major, is_explicit) in zip(cbuffer["members"], declared):
            try:  # an array of ConstantBuffers is as many buffers
                value = value_of(type_name, [] if is_constant_buffer else counts, row_major, structs)
            except Ambiguous:
                end = reflected["offset"] + reflected["size"]
                continue
            at = reflected["offset"] if is_explicit else value.place(end)
            if not is_explicit:
                end = at + value.size
            members += 1
            if (at, value.size) != (reflected["offset"], reflected["size"]):
                found.append(f"{cbuffer['name']}.{name}: {type_name} at {reflected['offset']}, {reflected['size']} bytes; "
                             f"by the rules at {at}, {value.size} bytes")
    return members, found


def check(clipc, path, options):
    """The members of the shader's buffers and what is wrong with them; or None where clipc refuses the shader."""
    with tempfile.TemporaryDirectory() as folder:
        reflection = folder + "/reflection.json"
        reflect = subprocess.run([clipc, path, *options, "--target=vulkan", "--reflect=" + reflection, "-o", "/dev/null"],
                                 capture_output=True)
        ir = subprocess.run([clipc, path, *options, "--dump=ir"], capture_output=True, text=True, errors="replace")
        if reflect.returncode or ir.returncode:
            return None
        with open(reflection, encoding="utf-8") as file:
            return problems(ir.stdout, json.load(file))


def self_test():
    """Microsoft's own examples, and that a wrong offset is seen."""
    ir = "struct S {\n  float3 a\n  float2 b[2]\n}\ncbuffer C : b0, 96 bytes {\n  float2 x at 0, 8 bytes\n  float3 y at 16, 12 bytes\n" \
         "  S s at 32, 40 bytes\n  float z at 72, 4 bytes\n}\n"
    right = [("x", 0, 8), ("y", 16, 12), ("s", 32, 40), ("z", 72, 4)]

    def found(places):
        members = [{"name": name, "offset": offset, "size": size} for name, offset, size in places]
        return problems(ir, {"cbuffers": [{"name": "C", "kind": "cbuffer", "members": members}]})
    if found(right) != (4, []) or len(found(right[:3] + [("z", 80, 4)])[1]) != 1 or len(found([("x", 4, 8)] + right[1:])[1]) != 1:
        sys.exit(f"check_packing.py itself is wrong: {found(right)}")


def corpus(clipc, path):
    with open(path, encoding="utf-8") as file:
        lines = [(line.rstrip("\n").split("\t") + [""] * 5)[:5] for line in file]
    for shader, entry, profile, includes, defines in lines:
        options = ["-T", profile, "-E", entry]
        for flag, values in (("-I", includes), ("-D", defines)):
            for value in filter(None, values.split(";")):
                options += [flag, value]
        yield shader, options


def main():
    self_test()
    clipc = sys.argv[1]
    shaders = [(sys.argv[3], sys.argv[4:])] if sys.argv[2] == "--shader" else corpus(clipc, sys.argv[2])
    members = wrong = checked = 0
    for shader, options in shaders:
        result = check(clipc, shader, options)
        if result is None:
            continue
        checked += 1
        members += result[0]
        wrong += len(result[1])
        for problem in result[1]:
            print(f"{shader}: {problem}")
    print(f"{checked} shaders, {members} members of buffers: {wrong} wrong")
    return wrong != 0 or members == 0


sys.exit(main())
