#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws fxc's listings beside clipc's GLSL of the same HLSL.

A listing of ps_2_0 to ps_5_1 becomes a fragment shader, instruction by instruction; `clipc-draw pair` draws it and clipc's with the same
vertices, uniforms and textures, once for each output. The list has lines of a listing, an HLSL file, an entry and further options of
clipc, with tabs between; find_listings.py writes it.
"""

import argparse
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

from listings import shader_model_3, shader_model_4
from listings.text import NotRun, listings_of
from listings.written import Written, drawn


def fragment_shader(parts, written, output, model):
    """The listing as GLSL, with one output as a color."""
    declarations, begin, body, outputs = parts
    head = "#version 450\n#extension GL_ARB_shader_texture_image_samples : enable"
    kind = written.outputs[output][0]
    lines = [
        head,
        "layout(origin_upper_left) in vec4 gl_FragCoord;",
        "layout(location = 0) out vec4 drawn;",
        *written.input_declarations(),
        *written.sampler_declarations(),
        *declarations,
        "void run() {",
        *body,
        "}",
        "void main() {",
        *begin,
        "run();",
        f"drawn = {drawn(kind, model.shown(outputs[output], kind))};",
        "}",
    ]
    return "\n".join(lines) + "\n"


# What becomes of random inputs in [0, 1[: larger ones reach more texels, and ones take branches that are for a single number.
CHANGES = ("{}", "8.0 * {}", "0.0 * {} + 1.0")


def draw_both(draw, shaders, folder):
    """The numbers of pixels that are drawn, of colors, and of pixels that differ."""
    for name, shader in shaders.items():
        (folder / name).write_text(shader)
    paths = [folder / name for name in ("a.vert", "a.frag", "a.vert", "b.frag")]
    done = subprocess.run([draw, "pair", *paths], capture_output=True, text=True, timeout=60)
    text = done.stdout + done.stderr
    # The exit code asks for more colors than a small shader has.
    counts = re.search(r"(\d+) of \d+ pixels drawn in (\d+) colors, (\d+) different", text)
    if done.returncode not in (0, 1) or not counts:
        raise NotRun("draw: " + " ".join(text.strip().split("\n")[:3]))
    return [int(count) for count in counts.groups()]


def compare(draw, written, shaders, folder, has_inputs):
    """What differs between the images, or nothing. They show something if there are two colors."""
    seen = set()
    for change in CHANGES if has_inputs else CHANGES[:1]:
        shaders["a.vert"] = written.vertex_shader(change)
        drawn_pixels, colors, different = draw_both(draw, shaders, folder)
        if different:
            return f"{different} pixels differ of {drawn_pixels}, which have {colors} colors"
        seen.add(drawn_pixels)
        if colors > 1 or len(seen) > 1 or (colors and not has_inputs):
            return ""
    raise NotRun("one color, which shows nothing")


def run(arguments, listing, row, folder):
    _, hlsl, entry, *options = row
    model = shader_model_3 if listing.major < 4 else shader_model_4
    profile = "ps_4_0_level_9_3" if listing.is_level_9 else listing.profile
    written = Written(arguments.clipc, hlsl, entry, profile, options, folder)
    parts = model.translate(listing, written)
    found = []
    for output in parts[3]:
        if output not in written.outputs:
            raise NotRun(f"clipc does not write {output}")
        shaders = {
            "a.frag": written.drawing(output),
            "b.frag": fragment_shader(parts, written, output, model),
        }
        difference = compare(arguments.draw, written, shaders, folder, listing.reads_inputs())
        if difference:
            found.append(f"{output}: {difference}")
    return "; ".join(found)


def results(arguments, row, folder):
    """The profile, `equal`, `different` or `not run`, and why, of each listing of a row."""
    try:
        text = pathlib.Path(row[0]).read_text(errors="replace")
        listings = listings_of(text, row[2])
    except NotRun as error:
        yield "", "not run", str(error)
        return
    for listing in listings:
        try:
            difference = run(arguments, listing, row, folder)
            yield listing.profile, "different" if difference else "equal", difference
        except (NotRun, subprocess.TimeoutExpired) as error:
            yield listing.profile, "not run", str(error)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("clipc")
    parser.add_argument("draw", help="clipc-draw")
    parser.add_argument("list")
    parser.add_argument("--keep", metavar="FOLDER", help="where the last shaders stay")
    arguments = parser.parse_args()
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(arguments.keep or temporary)
        folder.mkdir(exist_ok=True)
        for line in pathlib.Path(arguments.list).read_text().splitlines():
            row = line.split("\t")
            if len(row) < 3:
                continue
            for profile, word, why in results(arguments, row, folder):
                counts[word] += 1
                if word != "equal":
                    print(f"{row[0]} {row[2]} {profile}: {word}: {why}", flush=True)
    print(", ".join(f"{counts[word]} {word}" for word in ("equal", "different", "not run")))
    return 1 if counts["different"] else 0


if __name__ == "__main__":
    sys.exit(main())
