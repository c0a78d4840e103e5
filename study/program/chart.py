# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The chart of speed against accuracy, which report.py puts first: a row for each way, with what it loses beside what it costs. It
is made of directions.csv, edges.csv and speed.csv alone, has no number of its own, and its axes fit any run's numbers."""

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

number = float  # of a cell
STEP = 1 / 256  # pixels: the grid that a rasteriser snaps to
# The arithmetic (edges.csv) of the ways (speed.csv, pixels.csv) that is not named like them.
ARITHMETIC = {
    "level9": "clip",
    "discard": "clip",
    "discard-object": "object",
    "discard-world": "world",
}
# The ways from top to bottom, those of one arithmetic together; beside each, what it is.
WAYS = {
    "object": "--plane-space=object",
    "xyw1": "--plane-space=xyw1",
    "clip": "[clipplanes] of fxc and dxc",
    "level9": "SetClipPlane",
    "world": "SV_ClipDistance by hand",
    "near-plane": "--lower=near-plane",
    "near-plane-f32": "the same in float",
    "cpu": "the application clips",
    "discard-object": "--lower=discard, object",
    "discard": "--lower=discard",
    "discard-world": "as in three.js",
}
COLORS = {
    "object": "#0f7d68",
    "xyw1": "#2471a3",
    "clip": "#c0392b",
    "level9": "#c0392b",
    "world": "#7d3c98",
    "near-plane": "#1e8449",
    "near-plane-f32": "#6e2c00",
    "cpu": "#2c3e50",
    "discard-object": "#0f7d68",
    "discard": "#c0392b",
    "discard-world": "#7d3c98",
}
# The situations of docs/study.md that are worse for some way than a plane 400 near distances away: the point of edges.csv, the
# ending of the methods there, and the name.
SITUATIONS = (
    (("mesh offset / depth", "1000"), "", "baked mesh"),
    (("world offset", "10000"), "-steps", "10,000 from the origin"),
    (("orthographic, depth / half height", "3000"), "", "orthographic"),
)
TEXT = {"fontsize": 7.5, "color": "#333333"}


def costs_of(speed, workload, way):
    """The cost with the most planes that the way has, and its interval; none where it was not measured."""
    for planes in ("6", "1"):
        for r in speed:
            if (r["workload"], r["way"], r["planes"]) == (workload, way, planes):
                return [number(r[c]) for c in ("paired_ratio", "paired_low", "paired_high")]
    return None


def worst_of(edges, method):
    """The largest loss of a method in the situations, and where; none where the tables lack them."""
    found = []
    for point, ending, name in SITUATIONS:
        there = {
            r["method"]: r
            for r in edges
            if (r["sweep"], r["parameter"]) == point and r["applies"] == "1"
        }
        row = there.get(method + ending) or there.get(method)
        if row:
            found.append((number(row["p99_in_image_px"]), name))
    return max(found, default=None)


def beside(axis, x, y, text, points):
    """Text to the right of a place."""
    axis.annotate(text, (x, y), (points, 0), textcoords="offset points", va="center", **TEXT)


def draw_losses(axis, rows, directions, edges):
    lost = {
        (r["depth"], r["method"], number(r["eye_to_plane"])): number(r["p99_in_image_px"])
        for r in directions
    }
    ends, values = (10, 400, 10000), []
    for y, way in enumerate(rows):
        method, color = ARITHMETIC.get(way, way), COLORS[way]
        if ("standard", method, 400) not in lost:
            continue
        near, middle, far = (lost["standard", method, ratio] for ratio in ends)
        values += [near, middle, far]
        worst = worst_of(edges, method)
        if worst and worst[0] > middle:
            values.append(worst[0])
            axis.plot([middle, worst[0]], [y, y], color="#999999", linewidth=0.8, zorder=2)
            hollow = {"markerfacecolor": "white", "markeredgecolor": color, "zorder": 4}
            axis.plot(worst[0], y, "o", markersize=7, **hollow)
            axis.text(worst[0], y + 0.2, worst[1], ha="center", va="top", **TEXT)
        axis.plot([near, far], [y, y], color=color, linewidth=5, solid_capstyle="butt", zorder=3)
        axis.plot(middle, y, "o", color=color, markersize=7, zorder=5)
        if way == "clip":
            for ratio, at in zip(ends, (near, middle, far)):
                axis.text(at, y - 0.2, f"{ratio:,} n", ha="center", va="bottom", **TEXT)
            reversed_depth = [lost.get(("reversed", method, ratio)) for ratio in ends]
            if all(reversed_depth):
                values += reversed_depth
                left, right = min(reversed_depth) / 1.25, max(reversed_depth) * 1.25
                axis.plot(
                    [left, right, right, left, left],
                    [y - 0.13, y - 0.13, y + 0.13, y + 0.13, y - 0.13],
                    color=color,
                    linewidth=1.2,
                )
                middle_at = (left * right) ** 0.5
                axis.text(middle_at, y + 0.2, "depth reversed", ha="center", va="top", **TEXT)
    left, right = min([1e-4, *values]) / 2.2, max(values) * 12
    axis.set_xscale("log")
    axis.set_xlim(left, right)
    axis.axvspan(left, STEP, color="#e4f1e4", zorder=0)
    ticks = [10.0**e for e in range(-9, 9) if left <= 10.0**e <= right]
    axis.set_xticks(ticks)
    axis.set_xticklabels([f"{t:g}" if t >= 1e-4 else f"{t:.5f}" for t in ticks])
    axis.minorticks_off()
    green = {"fontsize": 7.5, "color": "#2e6b2e", "va": "bottom"}
    axis.text(STEP / 1.15, -0.62, "below a rasteriser's step", ha="right", **green)
    axis.text(STEP * 1.15, -0.62, "1/256", ha="left", **green)
    axis.set_xlabel("pixels that a cut is off in the image, 99th percentile")
    axis.set_title("accuracy, standard depth (dot: 400 n, circle: worst situation)", fontsize=10)


def draw_costs(axis, rows, speed, workload, title):
    most = 1
    for y, way in enumerate(rows):
        cost = costs_of(speed, workload, way)
        if cost is None:
            continue
        middle, low, high = cost
        most = max(most, high)
        axis.plot([low, high], [y, y], color=COLORS[way], linewidth=1.5, zorder=3)
        for end in (low, high):
            axis.plot([end, end], [y - 0.14, y + 0.14], color=COLORS[way], linewidth=1.5, zorder=3)
        axis.plot(middle, y, "o", color=COLORS[way], markersize=5, zorder=4)
        beside(axis, max(high, middle), y, f"{middle:.2f}", 6)
    axis.axvline(1, color="#555555", linewidth=0.9, zorder=1)
    beside(axis, 1, -0.7, "no planes", 3)
    least = min([1] + [c[1] for c in (costs_of(speed, workload, w) for w in rows) if c])
    axis.set_xlim(least - 0.12 * (most - least), most + 0.4 * (most - least))
    axis.set_xlabel("time of a frame")
    axis.set_title(title, fontsize=10)


def draw(directions, edges, speed):
    """The figure."""
    rows = [way for way in WAYS if costs_of(speed, "image", way)]
    figure, axes = plt.subplots(
        1, 3, figsize=(11, 5.6), sharey=True, gridspec_kw={"width_ratios": [5.2, 2, 2]}
    )
    draw_losses(axes[0], rows, directions, edges)
    draw_costs(axes[1], rows, speed, "image", "six planes cut nothing")
    draw_costs(axes[2], rows, speed, "cut", "six planes cut most away")
    one = ("near-plane", "near-plane-f32")
    axes[0].set_yticks(range(len(rows)))
    axes[0].set_yticklabels(
        [f"{way}\n{WAYS[way]}{', 1 plane' * (way in one)}" for way in rows], fontsize=8
    )
    axes[0].set_ylim(len(rows) - 0.4, -1.05)
    for axis in axes:
        axis.grid(axis="y", color="#eeeeee")
        axis.tick_params(axis="y", length=0)
    return figure


CAPTION = (
    "Further left is better in each panel. 1920x1080, 60 degrees. A bar is from a plane 10 near distances (n) before the eye over 400 (dot) "
    "to 10,000. A hollow circle is the way's own worst of the situations of docs/study.md, joined to its dot. Times are those of a software "
    "rasteriser's CPU, relative to no planes, with intervals of 95 % of one run's repeats."
)
