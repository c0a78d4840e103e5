#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes report.html and its charts of the tables that clipc-study wrote into a folder.

usage: report.py FOLDER
       report.py --chart TABLES FOLDER

The report is one file that loads nothing: charts are inline SVG, images are data URLs. Every number in it is read from
the tables. --chart makes only the chart of speed against accuracy, of tables anywhere."""

import base64
import collections
import csv
import html
import io
import math
import pathlib
import sys

import chart
import matplotlib
import matplotlib.pyplot as plt
from chart import STEP

plt.rcParams.update(
    {
        "svg.fonttype": "none",
        "font.size": 9,
        "axes.grid": True,
        "grid.color": "#dddddd",
        "axes.axisbelow": True,
        "figure.autolayout": True,
        "font.family": "sans-serif",
    }
)

COLORS = {
    "clip": "#c0392b",
    "level9": "#e67e22",
    "xyw1": "#2980b9",
    "object": "#16a085",
    "world": "#8e44ad",
    "view": "#7f8c8d",
    "document-f32": "#d35400",
    "inverse-f32": "#b7950b",
    "near-plane": "#27ae60",
    "near-plane-f32": "#6e2c00",
    "clip-steps": "#e57373",
    "xyw1-steps": "#7fb3d5",
    "object-steps": "#73c6b6",
    "world-steps": "#bb8fce",
    "near-plane-steps": "#82e0aa",
    "cpu-steps": "#85929e",
    "clip-product": "#f1948a",
    "xyw1-product": "#aed6f1",
    "discard": "#e84393",
    "discard-object": "#fd79a8",
    "discard-world": "#6c5ce7",
    "cpu": "#2c3e50",
    "none": "#aaaaaa",
}
HOW = {
    "clip": "[clipplanes] as fxc means it; also DXC and wined3d",
    "xyw1": "--plane-space=xyw1",
    "object": "--plane-space=object",
    "level9": "--lower=level9 and glClipPlane: SetClipPlane, Mesa's lowering",
    "world": "SV_ClipDistance of the world-space vertex, by hand",
    "near-plane": "--lower=near-plane --plane-space=object, Lengyel's scale",
    "near-plane-f32": "near plane by float matrix products (the paper)",
    "discard": "--lower=discard",
    "discard-object": "--lower=discard --plane-space=object",
    "discard-world": "dot product in each fragment (three.js)",
    "cpu": "the application clips in double",
    "clip-steps": "clip, where the shader multiplies by world and then by view * projection",
    "xyw1-steps": "xyw1, likewise",
    "object-steps": "object, likewise",
    "world-steps": "world, likewise",
    "near-plane-steps": "near-plane, likewise",
    "cpu-steps": "cpu, likewise",
    "clip-product": "clip, with one matrix that was multiplied in float",
    "xyw1-product": "xyw1, likewise",
    "view": "SV_ClipDistance of the view-space vertex",
    "document-f32": "the published closed form in float",
    "inverse-f32": "float inverse of view * projection",
}
number = float  # of a cell
LEAST = 1e-5  # pixels: smaller errors are drawn there


def read(folder, name):
    with open(folder / name, newline="") as file:
        return list(csv.DictReader(file))


class Charts:
    def __init__(self, folder):
        self.folder, self.parts = folder, []

    def add(self, name, title, figure, alt):
        matplotlib.rcParams["svg.hashsalt"] = name
        text = io.StringIO()
        figure.savefig(text, format="svg", metadata={"Date": None, "Creator": None})
        plt.close(figure)
        svg = text.getvalue()
        (self.folder / f"{name}.svg").write_text(svg)
        svg = svg[svg.index("<svg") :].replace(
            "<svg", f'<svg id="chart-{name}" role="img" aria-label="{html.escape(alt)}"', 1
        )
        self.parts.append(
            f'<figure class="chart"><figcaption>{html.escape(title)}</figcaption>{svg}</figure>'
        )

    def text(self, text):
        self.parts.append(text)


def cost_of(speed, way, planes=1, workload="image"):
    """To the frames just before and after: other work of the machine slows both alike."""
    at = (workload, way, str(planes))
    rows = (r for r in speed if (r["workload"], r["way"], r["planes"]) == at)
    return next((number(r["paired_ratio"]) for r in rows), None)


def by_sweep(rows, key):
    sweeps = collections.OrderedDict()
    for row in rows:
        if row["applies"] == "1":
            sweeps.setdefault(row["sweep"], collections.OrderedDict()).setdefault(
                row[key], []
            ).append(row)
    return sweeps


def main_chart(charts, directions, edges, speed):
    figure = chart.draw(directions, edges, speed)
    charts.add(
        "speed-accuracy",
        chart.CAPTION,
        figure,
        "each way to clip by what it loses and what it costs",
    )


def flicker_chart(charts, flicker):
    figure, axis = plt.subplots(figsize=(8.5, 4.2))
    for method in collections.OrderedDict.fromkeys(r["method"] for r in flicker):
        if method not in ("object", "world", "cpu", "near-plane", "xyw1", "clip", "near-plane-f32"):
            continue
        rows = [r for r in flicker if r["method"] == method and r["world_offset"] == "0"]
        values = [number(r["p99_px"]) for r in rows]
        label = method + (" (exactly 0)" if not any(values) else "")
        axis.plot(
            [number(r["eye_to_plane"]) for r in rows],
            [max(v, LEAST) for v in values],
            color=COLORS[method],
            marker="o",
            markersize=3,
            label=label,
        )
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.axhline(STEP, color="#555555", linewidth=0.9, linestyle=":")
    axis.axhline(0.5, color="#555555", linewidth=0.9, linestyle="--")
    axis.set_xlabel("eye to plane, near distances")
    axis.set_ylabel("p99, pixels a frame")
    axis.legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    title = "Flicker along a surface of a cut that stands still, while the camera pans"
    charts.add("flicker", title, figure, "flicker by distance of eye and plane")


def sweep_charts(charts, edges):
    for index, (sweep, methods) in enumerate(by_sweep(edges, "method").items()):
        figure, axis = plt.subplots(figsize=(6.1, 3.7))
        values = [number(r["parameter"]) for rows in methods.values() for r in rows]
        for method, rows in methods.items():
            at = [number(r["parameter"]) for r in rows]
            lost = [max(number(r["p99_px"]), LEAST) for r in rows]
            style = {"color": COLORS[method], "linewidth": 1.2, "label": method}
            axis.plot(at, lost, marker="o", markersize=3, **style)
        axis.set_yscale("log")
        if min(values) > 0 and max(values) / min(values) > 20:
            axis.set_xscale("log")
        elif min(values) <= 0:
            axis.set_xscale("symlog", linthresh=1e-4)
        axis.axhline(0.5, color="#555555", linewidth=0.8, linestyle="--")
        axis.axhline(STEP, color="#555555", linewidth=0.8, linestyle=":")
        axis.set_xlabel(sweep)
        axis.set_ylabel("p99, pixels, over 20 views")
        axis.legend(fontsize=7, ncol=2, loc="center left", bbox_to_anchor=(1.0, 0.5))
        charts.add(
            f"edges-{index}", f"Displaced edges: {sweep}", figure, f"displaced edges by {sweep}"
        )


def pixel_chart(charts, pixels):
    sweeps = by_sweep(pixels, "way")
    figure, axes = plt.subplots(
        math.ceil(len(sweeps) / 3),
        3,
        figsize=(12.5, 2.7 * math.ceil(len(sweeps) / 3)),
        squeeze=False,
    )
    for axis, (sweep, ways) in zip(axes.flat, sweeps.items()):
        for way, rows in ways.items():
            axis.plot(
                [r["parameter"] for r in rows],
                [number(r["wrong"]) for r in rows],
                color=COLORS[way],
                marker="o",
                markersize=3,
                linewidth=1,
                label=way,
            )
        axis.set_yscale("symlog", linthresh=1)
        axis.set_title(sweep, fontsize=9)
        axis.tick_params(axis="x", labelrotation=45, labelsize=7)
    for axis in list(axes.flat)[len(sweeps) :]:
        axis.set_axis_off()
    axes.flat[0].legend(fontsize=6, ncol=2)
    charts.add(
        "pixels",
        "Wrong fragments on Mesa's software OpenGL, against exactly clipped polygons",
        figure,
        "wrong fragments of every way",
    )


def cost_chart(charts, speed):
    workloads = ["image", "vertices", "cut"]
    figure, axes = plt.subplots(1, 3, figsize=(12.5, 4.2))
    for axis, workload in zip(axes, workloads):
        ways = [w for w in chart.WAYS if cost_of(speed, w, 1, workload) is not None]
        for offset, planes in enumerate((1, 3, 6)):
            bars = [(i, cost_of(speed, w, planes, workload)) for i, w in enumerate(ways)]
            bars = [(i, c) for i, c in bars if c is not None]
            axis.barh(
                [i + 0.26 * (offset - 1) for i, _ in bars],
                [c for _, c in bars],
                height=0.24,
                color=["#9ec9e2", "#3f8fc4", "#1c4f7c"][offset],
                label=f"{planes} planes" if planes > 1 else "1 plane",
            )
        axis.set_yticks(range(len(ways)))
        axis.set_yticklabels(ways)
        axis.invert_yaxis()
        axis.axvline(1, color="#555555", linewidth=0.8)
        axis.set_title(
            {
                "image": "1280x720, nothing cut",
                "vertices": "64x64, nothing cut",
                "cut": "1280x720, most cut away",
            }[workload]
        )
        axis.set_xlabel("CPU time / that without planes")
    axes[0].legend(fontsize=7)
    charts.add("cost", "What each way costs", figure, "cost with one, three and six planes")


def scene_chart(charts, scenes):
    figure, axis = plt.subplots(figsize=(8.5, 3.2))
    columns = [
        ("outside", "not in view", "#eeeeee"),
        ("culled", "clipped away whole", "#bbbbbb"),
        ("need0", "no plane", "#9ec9e2"),
        ("need1", "1 plane", "#3f8fc4"),
        ("need2", "2 planes", "#1c4f7c"),
        ("need3", "3 or more", "#c0392b"),
    ]
    left = [0.0] * len(scenes)
    for column, label, color in columns:
        widths = [number(r[column]) for r in scenes]
        axis.barh(range(len(scenes)), widths, left=left, color=color, label=label)
        left = [a + b for a, b in zip(left, widths)]
    axis.set_yticks(range(len(scenes)))
    axis.set_yticklabels([f"{r['scene']} ({r['planes']})" for r in scenes])
    axis.invert_yaxis()
    axis.set_xlabel("objects")
    axis.legend(fontsize=7, ncol=6, loc="upper center", bbox_to_anchor=(0.5, 1.2))
    charts.add(
        "planes-needed",
        "Planes that objects need (in brackets: planes of the scene)",
        figure,
        "planes needed per object in four scenes",
    )


def table(head, rows):
    cells = "".join(f"<th>{html.escape(h)}</th>" for h in head)
    body = "".join(
        "<tr>" + "".join(f"<td>{html.escape(str(c))}</td>" for c in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{cells}</tr></thead><tbody>{body}</tbody></table>"


def which_table(scenes):
    rows = [
        [
            f"{r['scene']}: {r['planes']} planes",
            r["way"],
            HOW[r["way"]],
            f"{number(r['bound_px']):.2g}",
            f"{number(r['cost']):.2f}",
            f"{100 * number(r['share']):.0f} % of the objects that a plane cuts",
        ]
        for r in scenes
    ]
    return table(["scene", "method", "how", "error at most, px", "cost", "for"], rows)


def failure_table(edges):
    rows = []
    for method in collections.OrderedDict.fromkeys(r["method"] for r in edges):
        worst = collections.OrderedDict()
        for r in edges:
            if r["method"] == method and r["applies"] == "1" and number(r["p99_px"]) > 0.5:
                worst.setdefault(r["sweep"], []).append(number(r["parameter"]))
        text = "; ".join(
            f"{sweep} {min(v):g} to {max(v):g}" if len(v) > 1 else f"{sweep} {v[0]:g}"
            for sweep, v in worst.items()
        )
        refused = collections.OrderedDict.fromkeys(
            r["sweep"] for r in edges if r["method"] == method and r["applies"] == "0"
        )
        rows.append([method, HOW[method], text or "nowhere", "; ".join(refused) or "-"])
    return table(
        ["method", "how", "more than half a pixel off at", "not usable somewhere in"], rows
    )


def special_table(special):
    """Odd planes and odd triangles by way; wrong ones in bold."""
    cases = list(collections.OrderedDict.fromkeys((r["sweep"], r["what"]) for r in special))
    ways = list(collections.OrderedDict.fromkeys(r["way"] for r in special))
    found = {
        (r["sweep"], r["what"], r["way"]): (number(r["got"]), number(r["right"])) for r in special
    }
    rows = []
    for sweep, what in cases:
        cells = []
        for way in ways:
            got, right = found.get((sweep, what, way), (None, None))
            cells.append(
                "-"
                if got is None
                else f"{got:.3f}"
                if abs(got - right) < 0.02
                else f"{got:.3f}, wrong"
            )
        rights = sorted(
            {f"{found[sweep, what, way][1]:.2f}" for way in ways if (sweep, what, way) in found}
        )
        rows.append([sweep, what, " to ".join(dict.fromkeys((rights[0], rights[-1])))] + cells)
    return table(["sweep", "what", "right"] + ways, rows)


def laws_table(laws):
    return table(
        "regime, judged in, draws, below 0.2, above 3, least, median, most, all edges together".split(
            ", "
        ),
        [
            [r["regime"], r["judged_in"], r["draws"], r["low"], r["high"]]
            + [f"{number(r[c]):.2f}" for c in ("least", "median", "most", "pooled_p99")]
            for r in laws
        ],
    )


def images(folder):
    parts = []
    for path in sorted(folder.glob("image-*.png")):
        way = path.stem.removeprefix("image-")
        data = base64.b64encode(path.read_bytes()).decode()
        parts.append(
            f'<figure class="image"><img alt="{way}" src="data:image/png;base64,{data}"><figcaption>{way}</figcaption></figure>'
        )
    return "".join(parts)


STYLE = """body{font:15px/1.45 sans-serif;max-width:1240px;margin:1em auto;padding:0 1em;color:#222}
.sweeps{display:grid;grid-template-columns:1fr 1fr;gap:0 12px}figure{margin:1em 0}figcaption{font-weight:bold;margin-bottom:.3em}.chart svg{max-width:100%;height:auto}
.images{display:flex;flex-wrap:wrap;gap:8px}.image img{width:290px;border:1px solid #ccc}.image figcaption{font-weight:normal}
table{border-collapse:collapse;font-size:13px}td,th{border:1px solid #ccc;padding:3px 7px;text-align:left;vertical-align:top}th{background:#f3f3f3}"""


def main():
    if sys.argv[1] == "--chart":
        tables, folder = map(pathlib.Path, sys.argv[2:])
        names = ("directions.csv", "edges.csv", "speed.csv")
        main_chart(Charts(folder), *(read(tables, name) for name in names))
        return
    folder = pathlib.Path(sys.argv[1])
    edges, pixels, speed = (read(folder, f"{n}.csv") for n in ("edges", "pixels", "speed"))
    scenes = read(folder, "scenes.csv")
    charts = Charts(folder)
    main_chart(charts, read(folder, "directions.csv"), edges, speed)
    charts.text("<h2>In motion</h2>")
    flicker_chart(charts, read(folder, "flicker.csv"))
    charts.text("<h2>Which method for which scene</h2>" + which_table(scenes))
    charts.text("<h2>Where each method fails</h2>" + failure_table(edges) + '<div class="sweeps">')
    sweep_charts(charts, edges)
    charts.text(
        "</div><h2>The laws, on draws that nobody chose</h2><p>What a draw loses, the 99th percentile of 20 views of it that differ by a "
        "hundredth, over what PredictEdgeError says of it; draws that are hardly in the image, or lose more than 20 pixels, are left out.</p>"
        + laws_table(read(folder, "laws.csv"))
    )
    charts.text("<h2>On a real rasteriser</h2>")
    pixel_chart(charts, pixels)
    charts.text(
        "<h3>Special values, triangles through w = 0, multisampling</h3><p>Special values: the share of the fragments without a plane "
        "that are drawn. Through w = 0: the same, and with the opposite plane's added. Multisampling: the share of rows in which the cut "
        "is smooth. The runtime refuses planes that are so short or so long, or changes their length.</p>"
        + special_table(read(folder, "special.csv"))
    )
    charts.text("<h2>Cost</h2>")
    cost_chart(charts, speed)
    charts.text("<h2>No more planes than needed</h2>")
    scene_chart(charts, scenes)
    charts.text(
        table(
            "scene, planes, draws, planes of all, least CPU ms, image as with all".split(", "),
            [
                [
                    r["scene"],
                    r["planes"],
                    r["draws"],
                    r["planes_drawn"],
                    f"{number(r['least_ms']):.1f}",
                    "yes" if r["same_image"] == "1" else "no",
                ]
                for r in read(folder, "scene-costs.csv")
            ],
        )
    )
    charts.text(
        f'<h2>A cut 230,000 near distances away</h2><div class="images">{images(folder)}</div>'
    )
    body = "\n".join(charts.parts)
    (folder / "report.html").write_text(
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>clipc: speed against accuracy</title><style>{STYLE}</style></head>\n'
        f"<body><h1>Clip planes: speed against accuracy</h1>\n{body}\n</body></html>\n"
    )
    print(folder / "report.html")


main()
