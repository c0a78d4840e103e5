#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws the pictures of an example and holds them against the pictures in docs/pictures.

usage: check_pictures.py FOLDER SCRATCH_FOLDER [--write] PICTURE... -- PROGRAM [ARGUMENT...]

PROGRAM, started in SCRATCH_FOLDER, writes the PICTUREs there. A pixel is another one where a channel differs by more than
8; of those at most one in a thousand may be, for drivers differ. --write renews the pictures: look at them before you
commit them.
"""

import pathlib
import shutil
import struct
import subprocess
import sys
import zlib


def pixels(path):
    """Width, height and rows of an RGB picture of 8 bits, which is all that the examples write."""
    data = path.read_bytes()
    at, packed, width, height = 8, b"", 0, 0
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">IIBBBBB", body)
            if form != [8, 2, 0, 0, 0]:
                sys.exit(f"{path}: not a plain RGB picture")
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    raw, stride, rows, above = zlib.decompress(packed), 3 * width, [], bytes(3 * width)
    for y in range(height):
        kind, row = (
            raw[y * (stride + 1)],
            bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)]),
        )
        for x in range(stride):
            left, up, corner = (row[x - 3], above[x], above[x - 3]) if x >= 3 else (0, above[x], 0)
            if kind == 4:  # Paeth
                guess = left + up - corner
                base = min((left, up, corner), key=lambda value: abs(guess - value))
            else:
                base = (0, left, up, (left + up) // 2)[kind]
            row[x] = (row[x] + base) & 255
        rows.append(row)
        above = row
    return width, height, rows


def differing(one, other):
    """The share of pixels that differ, or 1 for another size."""
    (width, height, rows), (other_width, other_height, other_rows) = pixels(one), pixels(other)
    if (width, height) != (other_width, other_height):
        return 1
    count = 0
    for row, other_row in zip(rows, other_rows):
        if row != other_row:
            count += sum(
                any(abs(row[x + c] - other_row[x + c]) > 8 for c in range(3))
                for x in range(0, 3 * width, 3)
            )
    return count / (width * height)


def main():
    split = sys.argv.index("--")
    write = "--write" in sys.argv[:split]
    folder, scratch, *pictures = [
        argument for argument in sys.argv[1:split] if argument != "--write"
    ]
    scratch = pathlib.Path(scratch)
    scratch.mkdir(parents=True, exist_ok=True)
    for picture in pictures:
        (scratch / picture).unlink(missing_ok=True)
    subprocess.run(sys.argv[split + 1 :], cwd=scratch, check=True)
    bad = 0
    for picture in pictures:
        kept = pathlib.Path(folder) / picture
        if write:
            shutil.copyfile(scratch / picture, kept)
        share = differing(scratch / picture, kept)
        print(f"{picture}: {100 * share:.3f} % of the pixels differ from {kept}")
        bad += share > 0.001
    return bad != 0


if __name__ == "__main__":
    sys.exit(main())
