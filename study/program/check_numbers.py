#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds the numbers of the documents against the tables in study/tables.

usage: check_numbers.py [--write] [--take FOLDER]
       check_numbers.py --chart [--write]

A document has blocks between `<!-- numbers: NAME -->` and `<!-- end of numbers -->`, which are made of the tables: a block
that differs is an error, and --write writes it. Numbers in sentences are compared one by one (INLINE). --take copies the
tables of a whole `./run study` from its folder first. --chart holds study/speed-accuracy.svg against the chart that report.py
makes of the tables; the exit code is 77 where Matplotlib is another than the one that made it, which places text elsewhere."""

import csv
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import bench_limits

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLES = ROOT / "study/tables"
CHART, MATPLOTLIB = ROOT / "study/speed-accuracy.svg", "3.6.3"
# The points of edges.csv and the columns of flicker.csv that documents speak of, with their methods.
POINTS = (
    ("world offset", "10000"),
    ("mesh offset / depth", "1000"),
    ("orthographic, depth / half height", "3000"),
)
RATIOS = ("10", "100", "400", "1000")
MOVED = ("clip", "xyw1", "near-plane", "object", "world", "cpu")
FAR = "10000"  # world_offset in flicker.csv
TAKEN = {
    "directions": lambda row: True,
    "edges": lambda row: (row["sweep"], row["parameter"]) in POINTS,
    "flicker": lambda row: (
        row["world_offset"] == FAR or (row["eye_to_plane"] in RATIOS and row["method"] in MOVED)
    ),
    "laws": lambda row: True,
    "scene-costs": lambda row: True,
    "speed": lambda row: True,
}


def read(name):
    with open(TABLES / f"{name}.csv", newline="") as file:
        return list(csv.DictReader(file))


def take(folder):
    for name, is_taken in TAKEN.items():
        with (
            open(folder / f"{name}.csv", newline="") as source,
            open(TABLES / f"{name}.csv", "w", newline="") as target,
        ):
            rows = csv.DictReader(source)
            writer = csv.DictWriter(target, rows.fieldnames, lineterminator="\n")
            writer.writeheader()
            writer.writerows(filter(is_taken, rows))


def short(number):
    """The number with two digits, without an exponent."""
    if number == 0:
        return "0"
    return f"{number:.{max(0, 1 - math.floor(math.log10(abs(number))))}f}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(map(str, row)) + " |" for row in rows])


def code(names):
    return ", ".join(f"`{name}`" for name in names)


def situations():
    speed = {(r["workload"], r["way"], r["planes"]): r for r in read("speed")}
    edges = {(r["sweep"], r["parameter"], r["method"]): r for r in read("edges")}
    # In the image; and along the object, where that is less by a tenth or more.
    both = lambda row: (
        short(float(row["p99_in_image_px"]))
        + (
            f" (along it {short(float(row['p99_px']))})"
            if float(row["p99_px"]) < 0.9 * float(row["p99_in_image_px"])
            else ""
        )
    )
    lost = lambda point: lambda method: both(edges[(*point, method)])
    usual = lambda method: both(direction(method))
    world, mesh, sun = map(lost, POINTS)
    cost = lambda way: f"{float(speed['image', way, '6']['paired_ratio']):.2f}"
    rows = [
        ["vertices around their own origin", "`object`", usual("object"), usual("clip")],
        [
            "a large or baked mesh, 1,000 depths from its own origin",
            "an origin near the cut, and `object`",
            f"{usual('object')}; without such an origin {mesh('object')}",
            mesh("clip"),
        ],
        [
            "vertices that the shader moves: skins, waves, instances",
            "`xyw1`",
            usual("xyw1"),
            usual("clip"),
        ],
        [
            "10,000 units from the world's origin, seen at 10, `mul(mul(v, world), view_projection)`",
            "`object`, and one matrix in double",
            f"{world('object')}; without that {world('object-steps')}, `xyw1` {world('xyw1-steps')}",
            world("clip-steps"),
        ],
        ["orthographic, 1,500 heights of the image away", "`object`", sun("object"), sun("clip")],
    ]
    ways = ["object", "object", "xyw1", "object", "object"]
    return table(
        ["you have", "use", "it loses, pixels", "`clip` loses", "it costs"],
        [row + [cost(way)] for row, way in zip(rows, ways, strict=True)],
    )


def advantage():
    times = lambda method, ratio: (
        float(direction("clip", ratio)["p99_in_image_px"])
        / float(direction(method, ratio)["p99_in_image_px"])
    )
    near, middle = ([times(m, ratio) for m in ("xyw1", "object")] for ratio in ("10", "400"))
    return (
        f"{short(near[1])} and {short(near[0])} times less if the plane is 10 near distances from the eye, "
        f"{round(middle[1], -2):,.0f} and {round(middle[0], -1):,.0f} times less at 400."
    )


def saved_time():
    """For each scene of scene-costs.csv."""
    rows = {(r["scene"], r["planes"]): float(r["least_ms"]) for r in read("scene-costs")}
    return {
        scene: 100 * max(0, 1 - ms / rows[scene, "all"])
        for (scene, planes), ms in rows.items()
        if planes == "needed"
    }


def saved():
    saved = saved_time()
    return (
        f"{short(saved['water'])} % for a reflection in water, {short(saved['portal'])} % for a portal, "
        f"{short(saved['cut-away'])} % for a cut-away and {short(saved['cascade'])} % for a slice of a shadow cascade."
    )


def held():
    rows = read("laws")
    least, most = min(float(r["least"]) for r in rows), max(float(r["most"]) for r in rows)
    draws = sum(int(r["draws"]) for r in rows) // 2
    outside = {
        judged_in: sum(int(r["low"]) + int(r["high"]) for r in rows if r["judged_in"] == judged_in)
        for judged_in in ("image", "surface")
    }
    medians = [float(r["median"]) for r in rows]
    return (
        f"Held against {draws:,} random draws, 10,000 of each order of matrices and of each of nine other regimes:\n\n"
        f"- In the middle of each regime, a draw loses {min(medians):.2f} to {max(medians):.2f} of the prediction.\n"
        f"- All but {outside['image']} draws lose 0.2 to 3 of it in the image, all but {outside['surface']} along the object. "
        f"The others lose {short(least)} to {short(most)} of it."
    )


def flicker():
    rows = read("flicker")
    found = {
        (r["method"], r["eye_to_plane"]): [
            short(float(r[c])) for c in ("p99_px", "p99_in_image_px")
        ]
        for r in rows
        if r["world_offset"] == "0"
    }
    far = {r["method"]: float(r["p99_in_image_px"]) for r in rows if r["world_offset"] == FAR}
    lines = []
    for method in MOVED:
        along, seen = zip(*(found[method, ratio] for ratio in RATIOS), strict=True)
        # Along the object alone where the image shows the same, or nothing moves.
        moves = any(number != "0" for number in along)
        lines.append((method, along if moves else ["0"] * len(RATIOS), far[f"{method}-steps"]))
    merged = {}  # methods by their numbers
    for method, numbers, at in lines:
        merged.setdefault((*numbers, short(at)), []).append(method)
    return table(
        ["eye to plane, near distances"]
        + [f"{int(r):,}" for r in RATIOS]
        + ["in the image, 10,000 units from the origin"],
        [[code(methods), *numbers] for numbers, methods in merged.items()],
    )


def costs():
    rows = {(r["workload"], r["way"], r["planes"]): r for r in read("speed")}
    cell = lambda r: (
        "-"
        if r is None
        else f"{float(r['paired_ratio']):.2f} ({float(r['paired_low']):.2f} to {float(r['paired_high']):.2f})"
    )
    ways = ("object", "xyw1", "clip", "cpu", "discard-world")
    columns = [("image", "1"), ("image", "3"), ("image", "6"), ("cut", "1"), ("cut", "6")]
    head = ["way", "1 plane", "3", "6", "1, cutting", "6, cutting"]
    return table(
        head, [[f"`{way}`"] + [cell(rows.get((s, way, p))) for s, p in columns] for way in ways]
    )


def planned():
    rows = {(r["scene"], r["planes"]): r for r in read("scene-costs")}
    names = {
        "water": "reflection in water",
        "portal": "portal",
        "cut-away": "cut-away",
        "cascade": "slice of a shadow cascade",
    }
    lines = []
    for scene, name in names.items():
        every, needed = (rows[scene, planes] for planes in ("all", "needed"))
        count, planned = (int(row["planes_drawn"]) for row in (every, needed))
        each = count // int(every["draws"])
        lines.append(
            [
                f"{name}, {each} plane{'s' * (each > 1)}",
                count,
                planned,
                short(count / planned),
                f"{short(saved_time()[scene])} %",
            ]
        )
    head = ["scene", "all planes for all objects", "planned", "times fewer", "CPU time saved"]
    return table(head, lines)


def limits():
    rows = bench_limits.read((ROOT / "tools/bench/main.cpp").read_text())
    return table(["a shader of 60 lines", "at most"], rows)


BLOCKS = {
    f.__name__: f
    for f in (
        limits,
        situations,
        advantage,
        saved,
        held,
        flicker,
        costs,
        planned,
    )
}

U, ROWS, PY = 2.0**-24, 1080, 1 / math.tan(math.radians(30))
ANY = U * ROWS / 2 / 0.1  # the unit of PredictEdgeError for surfaces of every direction


def direction(method, ratio="400", depth="standard"):
    """The row of directions.csv."""
    return next(
        r
        for r in read("directions")
        if (r["method"], r["eye_to_plane"], r["depth"]) == (method, ratio, depth)
    )


def constant(path, pattern):
    """A number that a source file has."""
    return float(re.search(pattern, (ROOT / path).read_text())[1].replace("'", ""))


# A document, a pattern with one number in it, and the number.
INLINE = [
    (
        "docs/study.md",
        r"image of 1920x(\d+)",
        lambda: constant("study/setup.h", r"kImageHeight = (\d+);"),
    ),
    (
        "docs/study.md",
        r"1/256 of a pixel, ([\d.]*\d)",
        lambda: 1 / constant("study/advice.h", r"kInvisible = 1.0 / (\d+);"),
    ),
    (
        "docs/laws.md",
        r"1.5 R: ([\d.]+) for an object no larger",
        lambda: ANY * 0.75,
    ),
    (
        "docs/study.md",
        r"`clip` does within (\d+) %",
        lambda: 100 * constant("study/program/check_tables.py", r"more <= 1(\.\d+)"),
    ),
    (
        "docs/laws.md",
        r"u H/2 ([\d.]+) R, with",
        lambda: constant("runtime/plane_space.cpp", r"kVertexFactor = ([\d.]+);"),
    ),
    (
        "docs/testing.md",
        r"reads (\d+) scenes, which",
        lambda: constant("study/scenes/check_advice.py", r"arguments else (\d+)"),
    ),
    (
        "docs/scene.md",
        r"which (\d+) of [\d,]+ random draws exceed",
        lambda: sum(int(r["high"]) for r in read("laws") if r["judged_in"] == "image"),
    ),
    (
        "docs/scene.md",
        r"which \d+ of ([\d,]+) random draws exceed",
        lambda: sum(int(r["draws"]) for r in read("laws") if r["judged_in"] == "image"),
    ),
    (
        "docs/scene.md",
        r"costs differ by less than (\d+) %",
        lambda: 100 * constant("study/advice.h", r"kSameCost = ([\d.]+);"),
    ),
    ("docs/runtime.md", r"once the plane is ([\d,]+)\nhalf-heights", lambda: 0.5 / ANY),
    (
        "docs/runtime.md",
        r"needs at most ([\d.]+) times\nas long as reading",
        lambda: constant("tools/bench/runtime_bench.cpp", r'cold / cold_read, "x", ([\d.]+)\)'),
    ),
    (
        "docs/runtime.md",
        r"needs at most ([\d.]+) times as long as\n`ObjectPlaneFromWorld`",
        lambda: constant("tools/bench/runtime_bench.cpp", r'ours / least, "x", ([\d.]+)\)'),
    ),
    (
        "docs/runtime.md",
        r"for ([\d,]+) boxes and 6 planes",
        lambda: constant("tools/bench/runtime_bench.cpp", r"kObjects = ([\d']+)"),
    ),
    (
        "docs/runtime.md",
        r"nothing \| ([\d.]+) pixels × \(eye-plane distance / near",
        lambda: ANY * 1.4 * (PY + 1),
    ),
    (
        "docs/runtime.md",
        r"needs a perspective \| nothing \| ([\d.]+) pixels at 60°",
        lambda: ANY * (2 + PY),
    ),
    (
        "docs/runtime.md",
        r"a constant for each object \| ([\d.]+) pixels, in any view",
        lambda: ANY * 0.75,
    ),
    (
        "docs/runtime.md",
        r"default plane space the cut is off by about ([\d.]+) px",
        lambda: ANY * 1.4 * (PY + 1),
    ),
]


def check_blocks(path, write):
    problems = []
    text = path.read_text()

    def replace(match):
        name = match[1]
        if name not in BLOCKS:
            problems.append(f"{path.name}: there is no block `{name}`")
            return match[0]
        right = f"<!-- numbers: {name} -->\n{BLOCKS[name]()}\n<!-- end of numbers -->"
        if right != match[0] and not write:
            problems.append(
                f"{path.name}: the block `{name}` is not what the tables say; see check_numbers.py --write"
            )
        return right

    made = re.sub(r"<!-- numbers: (\S+) -->\n.*?<!-- end of numbers -->", replace, text, flags=re.S)
    if write:
        path.write_text(made)
    return problems, len(re.findall("<!-- numbers: ", text))


def check_inline():
    problems = []
    for name, pattern, value in INLINE:
        found = re.search(pattern, (ROOT / name).read_text())
        if not found:
            problems.append(f"{name}: no sentence like `{pattern}`")
        elif abs(float(found[1].replace(",", "")) - value()) > 0.51 * 10 ** -len(
            found[1].partition(".")[2]
        ):
            problems.append(
                f"{name}: {found[1]} is {value():.4g} by the tables or the law (`{pattern}`)"
            )
    return problems


# The numbers that describe the measurements and not their results: images' sizes, factors of the laws and of the checks, defaults of
# files, specifications.
GIVEN = {
    "docs/study.md": {"2.0", "100", "1920", "256", "400", "10,000"},
    "docs/laws.md": {"2.0", "100", "0.0002", "1.5"},
    "docs/scene.md": {"2.0", "100", "0.5", "1080", "256"},
    "docs/runtime.md": {"1080", "100"},
    "README.md": {"2.0", "4.5"},
    "docs/speed.md": {
        "12.0",
        "1.3",
        "740,000",
        "793",
        "906",
        "17.3",
        "16.8",
        "20.1",
        "19.4",
    },  # counts, with the command that makes them
}


def check_rest():
    """The problems of every other number with a point or three digits that is not one of GIVEN; versions are not numbers."""
    problems = []
    for name, given in GIVEN.items():
        text = (ROOT / name).read_text()
        held = [
            found.span(1) for row in INLINE if row[0] == name for found in re.finditer(row[1], text)
        ]
        for begin, end in held:
            text = text[:begin] + " " * (end - begin) + text[end:]
        text = re.sub(
            r"<!-- numbers: (\S+) -->\n.*?<!-- end of numbers -->|```.*?```|`[^`]*`|\]\([^)]*\)",
            "",
            text,
            flags=re.S,
        )
        for line in text.splitlines():
            for number in re.findall(
                r"(?<![\w.])(?:\d+\.\d+(?!\.?\d)|\d{1,3}(?:,\d{3})+|\d{3,})", line
            ):
                if number not in given:
                    problems.append(f"{name}: {number} comes from no table: {line.strip()[:100]}")
    return problems


def chart(write):
    """The exit code: 77 where this Matplotlib makes other bytes of the same tables."""
    python = "/usr/bin/python3"  # as clipc-study has it
    version = subprocess.run(
        [python, "-c", "import matplotlib; print(matplotlib.__version__)"],
        capture_output=True,
        text=True,
        check=False,
    ).stdout.strip()
    if version != MATPLOTLIB:
        print(f"the chart was made by Matplotlib {MATPLOTLIB}, and here is {version or 'none'}")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(
            [python, ROOT / "study/program/report.py", "--chart", TABLES, folder], check=True
        )
        made = (pathlib.Path(folder) / CHART.name).read_bytes()
    if write:
        CHART.write_bytes(made)
    is_same = made == CHART.read_bytes()
    print(
        "the chart is that of the tables"
        if is_same
        else f"{CHART.name} is not what report.py makes of the tables; see check_numbers.py --chart --write"
    )
    return not is_same


def main():
    arguments = sys.argv[1:]
    write = "--write" in arguments
    if "--chart" in arguments:
        return chart(write)
    if "--take" in arguments:
        take(pathlib.Path(arguments[arguments.index("--take") + 1]))
    problems, blocks = [], 0
    for name in (
        "docs/study.md",
        "docs/laws.md",
        "docs/scene.md",
        "docs/runtime.md",
        "docs/speed.md",
        "README.md",
    ):
        found, count = check_blocks(ROOT / name, write)
        problems += found
        blocks += count
    problems += check_inline() + check_rest()
    print("\n".join(problems) or f"{blocks} blocks and {len(INLINE)} sentences as in the tables")
    return bool(problems)


sys.exit(main())
