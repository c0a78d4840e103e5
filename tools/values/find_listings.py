#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Finds fxc's listings of pixel shaders with their HLSL, and prints the list that run_listings.py takes.

Listings are text files or C headers in the folders. Their HLSL and entry are those that the listing's comment names, that a line
`#pragma FXC NAME PROFILE ENTRY` of an HLSL file names, or that the file's name begins with. A listing without HLSL is named on the
standard error output.
"""

import argparse
import pathlib
import re
import sys

LISTING = re.compile(r"^(?: {4}|/ {4})?(ps_[1-5]_[0-9a-z]+)[ \t]*$", re.M)
COMMAND = re.compile(r"^//\s+fxc (.*(?:\n//    .*)*)", re.M)
PRAGMA = re.compile(r"^#pragma FXC (\w+) (ps_\w+) (\w+)(.*)$", re.M)
PIECE = re.compile(r"^#if 0$(.*?)const BYTE g_(\w+)\[\]", re.M | re.S)


def letters_of(name):
    """`LambertLit_PSSolid` and `LambertLitSolidPS` have the same letters."""
    return sorted(letter for letter in name.lower() if letter.isalnum())


def macros_of(options):
    return [f"-D{name}" for name in re.findall(r"[/-]D\s*([\w=.]+)", options)]


def read(path):
    return path.read_text(errors="replace").replace("\r", "")


def compiled_as(text, profile):
    """The only entry that a technique compiles with the profile."""
    names = set(re.findall(rf"compile {profile} (\w+)\s*\(", text))
    return names.pop() if len(names) == 1 else None


class Sources:
    def __init__(self, folders):
        self.texts = {}
        for folder in folders:
            for path in sorted(pathlib.Path(folder).rglob("*")):
                if path.suffix.lower() in (".hlsl", ".fx"):
                    self.texts[path] = read(path)

    def near(self, listing):
        """The HLSL files, those of the listing's own folder and the one above first."""
        folders = [listing.parent, listing.parent.parent]
        return sorted(self.texts, key=lambda path: path.parent not in folders)

    def has_function(self, path, name):
        return re.search(rf"\b{name}\s*\(", self.texts[path]) is not None

    def named(self, listing, stem, entry):
        """The file of that name which has the entry."""
        for path in self.near(listing):
            if path.stem.lower() == stem.lower() and self.has_function(path, entry):
                return path
        return None

    def by_pragma(self, listing, profile):
        found = [
            (listed != profile, path, [entry, *macros_of(rest)])
            for path, text in self.texts.items()
            for name, listed, entry, rest in PRAGMA.findall(text)
            if letters_of(name) == letters_of(listing.stem)
        ]
        return min(found)[1:] if found else None

    def by_name(self, listing, profile):
        """The file whose name the listing's begins with, and the entry of the words that follow."""
        for path in sorted(self.near(listing), key=lambda path: -len(path.stem)):
            if path.parent != listing.parent or not listing.stem.startswith(path.stem):
                continue
            if found := compiled_as(self.texts[path], profile):
                return path, [found]
            rest = letters_of(listing.stem[len(path.stem) :])
            wanted = [rest] if rest else [letters_of("main"), letters_of("PS")]
            names = re.findall(r"\b(\w+)\s*\(", self.texts[path])
            for name in names:
                if letters_of(name) in wanted:
                    return path, [name]
        return None


def find_sources(sources, listing, text, profile):
    """The HLSL file, and its entry with options, of each listing of a file."""
    if command := COMMAND.search(text):
        line = re.sub(r"\n//\s*", " ", command[1])
        entry = (re.search(r"[/-]E\s*(\w+)", line) or [None, "main"])[1]
        stem = pathlib.Path(line.split()[-1]).stem
        if path := sources.named(listing, stem, entry):
            return [(path, [entry, *macros_of(line)])]
    found = []
    for piece, array in PIECE.findall(text):
        entry = re.sub(r"^ps\d\d_", "", array)
        paths = [path for path in sources.near(listing) if sources.has_function(path, entry)]
        if entry == "main":
            paths = [sources.named(listing, listing.stem, entry)]
        if LISTING.search(piece) and paths and paths[0]:
            found.append((paths[0], [entry]))
    single = sources.by_name(listing, profile) or sources.by_pragma(listing, profile)
    return found or ([single] if single else [])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="+")
    arguments = parser.parse_args()
    sources = Sources(arguments.folder)
    for folder in arguments.folder:
        for path in sorted(pathlib.Path(folder).rglob("*")):
            if path.suffix.lower() not in (".asm", ".h", ".txt") or not path.is_file():
                continue
            text = read(path)
            profile = LISTING.search(text)
            if not profile:
                continue
            found = find_sources(sources, path, text, profile[1])
            for source, entry in found:
                print("\t".join([str(path), str(source), *entry]))
            if not found:
                print(f"{path}: no HLSL beside", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
