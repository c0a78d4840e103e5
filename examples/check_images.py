#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws the images of an example and holds them against the images in docs/images.

usage: check_images.py FOLDER SCRATCH_FOLDER [--write] IMAGE[=KEPT][@X,Y,A,B]... -- PROGRAM [ARGUMENT...]

PROGRAM, started in SCRATCH_FOLDER, writes the IMAGEs there. Each is compared with the file KEPT in FOLDER, which has the
same name unless it is given; with `@`, after an ellipse around the pixel X, Y with the radii A and B is drawn into it. A
pixel is another one where a channel differs by more than 8; of those at most one in a thousand may be, for drivers
differ. --write renews the kept images: look at them before you commit them.
"""

import pathlib
import re
import struct
import subprocess
import sys
import zlib


def pixels(path):
    """Width, height and rows of an RGB image of 8 bits, which is all that the examples write."""
    data = path.read_bytes()
    at, packed, width, height = 8, b"", 0, 0
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        body = data[at + 8 : at + 8 + size]
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">IIBBBBB", body)
            if form != [8, 2, 0, 0, 0]:
                sys.exit(f"{path}: not a plain RGB image")
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


def write_png(path, image):
    width, height, rows = image

    def chunk(kind, body):
        return (
            struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        )

    raw = b"".join(b"\0" + row for row in rows)
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
        + chunk(b"IDAT", zlib.compress(raw, 9))
        + chunk(b"IEND", b"")
    )


def mark(image, x, y, a, b):
    """Draws a red ellipse, three pixels wide, around the pixel x, y with the radii a and b."""
    width, height, rows = image
    for row in range(height):
        for column in range(width):
            radius = (((column - x) / a) ** 2 + ((row - y) / b) ** 2) ** 0.5
            if abs(radius - 1) * min(a, b) <= 1.5:
                rows[row][3 * column : 3 * column + 3] = b"\xe0\x20\x20"


def differing(one, other):
    """The share of pixels that differ, or 1 for another size."""
    (width, height, rows), (other_width, other_height, other_rows) = one, other
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
    folder, scratch, *images = [argument for argument in sys.argv[1:split] if argument != "--write"]
    scratch = pathlib.Path(scratch)
    scratch.mkdir(parents=True, exist_ok=True)
    images = [
        re.fullmatch(r"([^=@]+)(?:=([^@]+))?(?:@([\d,]+))?", image).groups() for image in images
    ]
    for name, _, _ in images:
        (scratch / name).unlink(missing_ok=True)
    subprocess.run(sys.argv[split + 1 :], cwd=scratch, check=True)
    bad = 0
    for name, kept_name, ellipse in images:
        kept, drawn = pathlib.Path(folder) / (kept_name or name), pixels(scratch / name)
        if ellipse:
            mark(drawn, *map(int, ellipse.split(",")))
        if write:
            write_png(kept, drawn)
        share = differing(drawn, pixels(kept))
        print(f"{name}: {100 * share:.3f} % of the pixels differ from {kept}")
        bad += share > 0.001
    return bad != 0


if __name__ == "__main__":
    sys.exit(main())
