#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Fails when the files of a room include each other in a circle: x.h and x.cpp count as one, so that a reader who begins with the file
that includes none of the others comes to the end without a step back.

A circle of a tree's walk, whose functions call each other as the nodes contain each other, is one of WALKS. Its size may fall.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ROOMS = (
    "base clip-table ir frontend passes legalize backend-glsl backend-spirv link rewrite compiler "
    "runtime"
).split()
INCLUDE = re.compile(r'^#include "([^"]+)"', re.MULTILINE)
# The files of the largest circle, and why there is one.
WALKS = {
    "frontend/check": (50, "expressions hold types, types hold expressions, and statements both"),
    "backend-glsl": (9, "an expression's text needs that of its operands, of any kind"),
    "ir": (3, "the evaluator's machine calls functions, which run on the machine"),
}


def units():
    """The units that each unit includes, by its path without a suffix."""
    graph = {}
    for room in ROOMS:
        for file in (ROOT / room).rglob("*"):
            if (
                file.suffix not in (".h", ".hpp", ".cpp")
                or file.stem.endswith("_test")
                or file.name.startswith("test_")
            ):
                continue
            unit = str(file.relative_to(ROOT).with_suffix(""))
            names = {
                str(pathlib.Path(name).with_suffix(""))
                for name in INCLUDE.findall(file.read_text())
            }
            graph.setdefault(unit, set()).update(names - {unit})
    return {unit: {name for name in names if name in graph} for unit, names in graph.items()}


def reached(graph, unit):
    found, open_units = set(), [unit]
    while open_units:
        for name in graph[open_units.pop()] - found:
            found.add(name)
            open_units.append(name)
    return found


def circles(graph):
    """The sets of units that reach each other."""
    reach = {unit: reached(graph, unit) for unit in graph}
    found = {
        frozenset(other for other in reach[unit] if unit in reach[other])
        for unit in graph
        if unit in reach[unit]
    }
    return sorted(found, key=lambda circle: (-len(circle), min(circle)))


def self_test():
    graph = {"a": {"b"}, "b": {"c"}, "c": {"b"}, "d": {"a"}}
    assert circles(graph) == [frozenset({"b", "c"})], circles(graph)
    assert circles({"a": {"b"}, "b": set()}) == []


def main():
    self_test()
    failed = 0
    for circle in circles(units()):
        room = next(
            (room for room in WALKS if all(unit.startswith(room + "/") for unit in circle)), None
        )
        if room and len(circle) <= WALKS[room][0]:
            continue
        failed += 1
        print(f"{len(circle)} files include each other: {', '.join(sorted(circle))}")
    if not failed:
        print(f"no circle in {len(ROOMS)} rooms but the walks of trees")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
