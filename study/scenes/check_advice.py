#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Holds the advice of `clipc-study scene` on scenes of make_scenes.py against arithmetic of its own.

usage: check_advice.py CLIPC-STUDY [--scenes COUNT] [--first NUMBER] [--blind]

Cuts are taken by shooting rays at the plane through random pixels. What is right follows from whole numbers of any length, and
float32 is every operation rounded by itself. A way that is said to meet the tolerance and does not is a failure. For one object in
two hundred a way may be overlooked that meets it with a margin of MARGIN, there and in a view nearby, and for one in a hundred a way
may be 15 % dearer than one that meets it so. --blind takes a hundredth of the tolerance and must fail."""

import array
import fractions
import functools
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

import make_scenes

COSTS = {
    "clip": 1,
    "xyw1": 1,
    "object": 1,
    "world": 1.2,
    "discard": 1.4,
    "discard-object": 1.4,
    "cpu": 1.6,
}
ARITHMETIC = {"discard": "clip", "discard-object": "object"}
EDGES = 300
# The advice is bound by three times its law, and the law of one draw in a hundred is more than twice the truth.
MARGIN = 6
F = fractions.Fraction


def f32(values):
    """Doubles, each rounded to float; infinite where float has no such number."""
    return array.array("f", values).tolist()


def dot32(components, by):
    """One float for each place of four lists: its dot product with a vector, every operation rounded by itself."""
    total = f32([x * by[0] for x in components[0]])
    for xs, factor in zip(components[1:], by[1:]):
        product = f32([x * factor for x in xs])
        total = f32([a + b for a, b in zip(total, product)])
    return total


def transform32(components, columns):
    return [dot32(components, column) for column in columns]


def multiply(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(4)) for j in range(4)] for i in range(4)]


def columns32(m):
    return [f32([m[i][j] for i in range(4)]) for j in range(4)]


def multiply32(a, b):
    """The columns of a product of matrices that are given by their columns, every operation rounded."""
    return [dot32(a, column) for column in b]


def solve(m, b):
    """x with m x = b, in fractions."""
    rows = [[F(x) for x in row] + [F(y)] for row, y in zip(m, b)]
    for i in range(4):
        pivot = next(r for r in range(i, 4) if rows[r][i] != 0)
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for r in range(4):
            if r != i:
                rows[r] = [x - rows[r][i] * y for x, y in zip(rows[r], rows[i])]
    return [row[4] for row in rows]


def before(m, plane):
    return [sum(F(x) * p for x, p in zip(row, plane)) for row in m]


class Draw:
    """One camera and one object."""

    def __init__(self, scene, thing):
        c = {"far": 1000, "half_height": 10, "offset": [0, 0]} | scene["cameras"][0]
        self.scene, self.thing, self.camera = scene, thing, c
        self.is_ortho = bool(c.get("orthographic"))
        s, t = math.sin(c["yaw"]), math.cos(c["yaw"])
        axes = [[t, 0, -s], [0, 1, 0], [s, 0, t]]
        eye = c["eye"]
        self.view = [[axes[j][i] for j in range(3)] + [0.0] for i in range(3)]
        self.view.append(
            [-sum(eye[i] * self.view[i][j] for i in range(3)) for j in range(3)] + [1.0]
        )
        near, far, reverse = c["near"], c["far"], c.get("reversed", False)
        at_near, at_far = (1, 0) if reverse else (0, 1)
        ox, oy = c["offset"]
        if self.is_ortho:
            a = (at_far - at_near) / (far - near)
            self.projection = [
                [1 / (c["aspect"] * c["half_height"]), 0, 0, 0],
                [0, 1 / c["half_height"], 0, 0],
                [0, 0, a, 0],
                [ox, oy, at_near - a * near, 1],
            ]
        else:
            py = 1 / math.tan(math.radians(c["fov"]) / 2)
            a, b = (
                (at_far, (at_near - at_far) * near)
                if c.get("infinite")
                else (
                    (at_far * far - at_near * near) / (far - near),
                    (at_near - at_far) * near * far / (far - near),
                )
            )
            self.projection = [
                [py / c["aspect"], 0, 0, 0],
                [0, py, 0, 0],
                [ox, oy, a, 1],
                [0, 0, b, 0],
            ]
        self.world = [thing["world"][4 * i : 4 * i + 4] for i in range(4)]
        self.world_view = multiply(self.world, self.view)
        self.all = multiply(self.world_view, self.projection)
        self.rows = scene["picture_height"]
        inverse = [solve(self.world_view, [float(i == j) for j in range(4)]) for i in range(4)]
        self.to_object = [[float(inverse[j][i]) for j in range(3)] for i in range(4)]
        self.cuts = {}

    def places(self, view_plane, others, r):
        """Random places of the cut that the image shows and the other planes keep, in view space."""
        kept = [[float(x) for x in other] for other in others]
        for place in self.places_of_plane(view_plane, r):
            for other in kept:
                a, b, c = other[0] * place[0], other[1] * place[1], other[2] * place[2]
                if a + b + c + other[3] < -1e-9 * (abs(a) + abs(b) + abs(c) + abs(other[3])):
                    break
            else:
                yield place

    def in_object(self, x, y, z):
        """A place of view space in the object's own."""
        a, b, c, d = self.to_object
        return [x * a[i] + y * b[i] + z * c[i] + d[i] for i in range(3)]

    def places_of_plane(self, view_plane, r):
        """Random places of the cut that the image shows, in view space. Most rays miss, so a miss is cheap."""
        random, camera = r.random, self.camera
        (a0, a1, a2), (b0, b1, b2), (c0, c1, c2), (d0, d1, d2) = self.to_object
        (low0, low1, low2), (high0, high1, high2) = low, high = (
            self.thing["low"],
            self.thing["high"],
        )
        near, far = camera["near"], math.inf if camera.get("infinite") else camera["far"]
        corners = [[(high if n >> k & 1 else low)[k] for k in range(3)] + [1] for n in range(8)]
        seen = [
            [sum(v[i] * self.world_view[i][j] for i in range(4)) for j in range(3)] for v in corners
        ]
        ranges = [(-1.0, 1.0), (-1.0, 1.0)]
        if self.is_ortho or min(p[2] for p in seen) > near:
            for axis in range(2):
                at = [self.onto(p, axis) for p in seen]
                ranges[axis] = max(-1, min(at)), min(1, max(at))
        n0, n1, n2, w = (float(x) for x in view_plane)
        # Of the ray through a pixel: from x = from_x + width * random() on, and so y.
        (from_x, width), (from_y, height) = (
            (
                (ranges[i][0] - camera["offset"][i]) / self.projection[i][i],
                (ranges[i][1] - ranges[i][0]) / self.projection[i][i],
            )
            for i in range(2)
        )
        for _ in range(0 if any(a >= b for a, b in ranges) else 40 * EDGES):
            x, y = from_x + width * random(), from_y + height * random()
            slope = n2 if self.is_ortho else n0 * x + n1 * y + n2
            if slope == 0:
                continue
            z = -(w + n0 * x + n1 * y if self.is_ortho else w) / slope
            if not near < z < far:
                continue
            if not self.is_ortho:
                x, y = z * x, z * y
            if (
                low0 <= x * a0 + y * b0 + z * c0 + d0 <= high0
                and low1 <= x * a1 + y * b1 + z * c1 + d1 <= high1
                and low2 <= x * a2 + y * b2 + z * c2 + d2 <= high2
            ):
                yield x, y, z
        # A plane that is seen edge on: no pixel's ray meets it, and its line in the image is where it cuts.
        norm = n0 * n0 + n1 * n1 + n2 * n2
        (e0, e1, e2, _), (f0, f1, f2, _), (g0, g1, g2, _), (h0, h1, h2, _) = self.world_view
        size0, size1, size2 = high0 - low0, high1 - low1, high2 - low2
        for _ in range(40 * EDGES if norm else 0):
            u, v, t = low0 + size0 * random(), low1 + size1 * random(), low2 + size2 * random()
            x = u * e0 + v * f0 + t * g0 + h0
            y = u * e1 + v * f1 + t * g1 + h1
            z = u * e2 + v * f2 + t * g2 + h2
            away = (n0 * x + n1 * y + n2 * z + w) / norm
            x, y, z = x - away * n0, y - away * n1, z - away * n2
            if (
                near < z < far
                and low0 <= x * a0 + y * b0 + z * c0 + d0 <= high0
                and low1 <= x * a1 + y * b1 + z * c1 + d1 <= high1
                and low2 <= x * a2 + y * b2 + z * c2 + d2 <= high2
                and all(abs(self.onto((x, y, z), axis)) <= 1 for axis in range(2))
            ):
                yield x, y, z

    def onto(self, p, axis):
        w = 1 if self.is_ortho else p[2]
        return p[axis] * self.projection[axis][axis] / w + self.camera["offset"][axis]

    def distances_by(self, way, cut):
        """The distances of a cut's vertices by a way's arithmetic."""
        if way == "cpu":
            exact = [float(x) for x in before(self.world, cut.world_plane)]
            return [sum(a * b for a, b in zip(v, exact)) for v in zip(*cut.vertices)]
        if way == "object":
            return dot32(cut.vertices, f32([float(x) for x in before(self.world, cut.world_plane)]))
        if way == "world":
            constant = f32([float(x) for x in cut.world_plane])
            return dot32(transform32(cut.vertices, columns32(self.world)), constant)
        p = [[F(x) for x in row] for row in self.projection]
        plane = cut.view_plane
        x, y = plane[0] / p[0][0], plane[1] / p[1][1]
        drawn = cut.positions
        if way == "clip":
            exact = solve(self.projection, plane)
        else:
            exact = [x, y, plane[2] - p[2][0] * x - p[2][1] * y, plane[3]]
            drawn = [drawn[0], drawn[1], drawn[3], [1.0] * len(drawn[0])]
        return dot32(drawn, f32([float(c) for c in exact]))

    def positions(self, vertices):
        """The vertices as the shader moves them, component by component."""
        for columns in self.chain:
            vertices = transform32(vertices, columns)
        return vertices

    @functools.cached_property
    def chain(self):
        """The columns of the matrices that the shader multiplies a vertex by, by the scene's `one_matrix`."""
        w, v, p = (columns32(m) for m in (self.world, self.view, self.projection))
        return {
            True: lambda: [columns32(self.all)],
            False: lambda: [w, columns32(multiply(self.view, self.projection))],
            "world-view": lambda: [columns32(self.world_view), p],
            "three": lambda: [w, v, p],
            "float-world-view": lambda: [multiply32(multiply32(w, v), p)],
            "float": lambda: [multiply32(w, multiply32(v, p))],
        }[self.scene["one_matrix"]]()

    def edges(self, view_plane, others, exact, r):
        """Edges through the cut: their ends, and the ends' true distances as whole numbers."""
        normal = [float(x) for x in view_plane[:3]]
        length = math.sqrt(sum(x * x for x in normal))
        normal = [x / length for x in normal]
        diagonal = math.sqrt(
            sum(
                sum(
                    (self.thing["high"][i] - self.thing["low"][i]) * abs(self.world[i][j])
                    for i in range(3)
                )
                ** 2
                for j in range(3)
            )
        )
        made = []
        for place in self.places(view_plane, others, r):
            while True:
                along = [r.gauss(0, 1) for _ in range(3)]
                size = math.sqrt(sum(x * x for x in along))
                along = [x / size for x in along]
                if abs(sum(a * b for a, b in zip(along, normal))) > 0.05:
                    break
            depth = self.camera["half_height"] if self.is_ortho else place[2]
            reach = min(0.05 * depth, diagonal / 2) * r.uniform(0.3, 1)
            part = r.uniform(0.2, 0.8)
            ends = []
            for t in (-part * reach, (1 - part) * reach):
                v = self.in_object(*(p + t * a for p, a in zip(place, along)))
                ends.append([*f32(v), 1.0])
            true = [sum(c * int(math.ldexp(x, 100)) for c, x in zip(exact, v)) for v in ends]
            if (true[0] >= 0) != (true[1] >= 0):
                made.append((ends, true))
            if len(made) == EDGES:
                break
        return made

    def cut(self, i, planes, in_view):
        """The cut of a plane that others may hide. It is the same for every way, and made once."""
        key = tuple(plane["name"] for plane in planes), i
        if key not in self.cuts:
            world_plane = [F(x) for x in planes[i]["plane"]]
            in_object = before(self.world, world_plane)
            scale = max(abs(x) for x in in_object) or 1
            exact = [int(x / scale * 2**160) for x in in_object]
            others = in_view[:i] + in_view[i + 1 :]
            edges = self.edges(in_view[i], others, exact, random.Random(planes[i]["name"]))
            self.cuts[key] = Cut(self, world_plane, in_view[i], edges)
        return self.cuts[key]

    def lost(self, way, names, every_plane=False):
        """The 99th percentile of displacements, of the plane where it is largest; none where hardly a cut of any plane is
        seen or, with `every_plane`, where hardly a cut of one of them is, but some of it."""
        worst = None
        planes = [plane for plane in self.scene["planes"] if plane["name"] in names]
        in_view = [solve(self.view, plane["plane"]) for plane in planes]
        for i in range(len(planes)):
            cut = self.cut(i, planes, in_view)
            if cut.count < EDGES // 3:
                if every_plane and cut.count:
                    return None
                continue
            pixels = sorted(cut.displacements(self.distances_by(way, cut), way == "cpu"))
            worst = max(worst or 0, pixels[int(0.99 * len(pixels))])
        return worst


class Cut:
    """Edges through the cut of a plane: lists of their components, the two ends of an edge one after the other."""

    def __init__(self, draw, world_plane, view_plane, edges):
        self.draw, self.world_plane, self.view_plane = draw, world_plane, view_plane
        self.count = len(edges)
        ends = [v for edge, _ in edges for v in edge]
        self.vertices = [[v[i] for v in ends] for i in range(4)]
        # Where the cut crosses each edge, its pixel there, and whether the first end is kept.
        shares = [true[0] / (true[0] - true[1]) for _, true in edges]
        self.keeps_first = [true[0] >= 0 for _, true in edges]
        m = draw.all
        clip = [[sum(v[i] * m[i][j] for i in range(4)) for j in range(4)] for v in ends]
        self.right = [self.pixel(*clip[2 * n : 2 * n + 2], share) for n, share in enumerate(shares)]

    @functools.cached_property
    def positions(self):
        return self.draw.positions(self.vertices)

    def pixel(self, first, second, share):
        """The pixel at a share of the way between two positions in clip space."""
        x, y, _, w = (a + share * (b - a) for a, b in zip(first, second))
        half = self.draw.rows / 2
        return x / w * half * self.draw.camera["aspect"], y / w * half

    def displacements(self, distances, makes_vertices):
        """How far the cut of each edge is off in the image, in pixels."""
        drawn = list(zip(*self.positions))
        ends = list(zip(distances[::2], distances[1::2], drawn[::2], drawn[1::2]))
        shares = [
            a / (a - b)
            if (a >= 0) != (b >= 0) and math.isfinite(a - b)
            else float(keeps_first == (a >= 0))
            for (a, b, *_), keeps_first in zip(ends, self.keeps_first)
        ]
        if makes_vertices:
            made = [
                f32([a + s * (b - a) for a, b, s in zip(xs[::2], xs[1::2], shares)])
                for xs in self.vertices
            ]
            made = list(zip(*self.draw.positions(made)))
        pixels = []
        for n, (a, b, first, second) in enumerate(ends):
            if (
                not all(map(math.isfinite, (a, b, *first, *second)))
                or min(first[3], second[3]) <= 0
            ):
                pixels.append(math.inf)
                continue
            if makes_vertices and (a >= 0) != (b >= 0):
                where = self.pixel(made[n], made[n], 0)
            else:
                where = self.pixel(first, second, shares[n])
            pixels.append(math.dist(where, self.right[n]))
        return pixels


def is_possible(way, scene, thing):
    # The shader moves the vertices first.
    if way in ("object", "discard-object", "cpu") and not thing["rigid"]:
        return False
    if way == "xyw1" and scene["cameras"][0].get("orthographic"):
        return False
    return not way.startswith("discard") or scene["can_discard"]


def moved(scene):
    """The scene with its camera moved and turned a little, so that none of its numbers is round."""
    camera, r = scene["cameras"][0], random.Random(scene["name"])
    is_ortho = camera.get("orthographic")
    step = camera["half_height"] if is_ortho else camera["near"]
    turn = 0 if is_ortho else 0.01 * math.tan(math.radians(camera["fov"]) / 2)
    eye = [x + 0.01 * step * r.uniform(-1, 1) for x in camera["eye"]]
    return scene | {
        "cameras": [camera | {"eye": eye, "yaw": camera["yaw"] + turn * r.uniform(-1, 1)}]
    }


def check(study, scene, folder, factor, found):
    path, out = folder / "scene.json", folder / "advice.json"
    path.write_text(json.dumps(scene))
    code = subprocess.run(
        [study, "scene", str(path), "--costs", str(folder / "costs.csv"), "--json", str(out)],
        stdout=subprocess.DEVNULL,
    ).returncode
    if code not in (0, 1):
        found["problems"].append(f"{scene['name']}: clipc-study ends with {code}")
        return
    advice = json.loads(out.read_text())[0]["objects"]
    if code != any(not a["meets"] for a in advice):
        found["problems"].append(f"{scene['name']}: the exit code is {code}")
    tolerance = scene["tolerance"] * factor
    for thing, said in zip(scene["objects"], advice):
        if said["drawn"] != "yes" or "refused" in said or not said["planes"]:
            continue
        draw, nearby = Draw(scene, thing), Draw(moved(scene), thing)
        found["advised"] += 1
        if said["meets"]:
            found["meets"] += 1
            lost = draw.lost(ARITHMETIC.get(said["method"], said["method"]), said["planes"])
            if lost is None:
                found["unseen"] += 1
            elif lost > tolerance:
                found["problems"].append(
                    f"{scene['name']}, {thing['name']}: {said['method']} loses {lost:.3g} of {tolerance:g} pixels"
                )
        for way, cost in COSTS.items():
            if not is_possible(way, scene, thing) or (
                said["meets"] and cost * 1.15 >= said["cost"]
            ):
                continue
            # Round numbers of one view may be exact; the law is for the views around it.
            if any(
                lost is None or lost > tolerance / MARGIN
                for lost in (
                    view.lost(ARITHMETIC.get(way, way), said["planes"], every_plane=True)
                    for view in (draw, nearby)
                )
            ):
                continue
            if said["meets"]:
                found["dearer"] += 1
            else:
                found["overlooked"] += 1
            break


def main():
    arguments = sys.argv[2:]
    count = int(arguments[arguments.index("--scenes") + 1]) if "--scenes" in arguments else 500
    first = int(arguments[arguments.index("--first") + 1]) if "--first" in arguments else 0
    found = {"advised": 0, "meets": 0, "unseen": 0, "dearer": 0, "overlooked": 0, "problems": []}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        lines = ["workload,way,planes,median_ms,least_ms,ratio,paired_ratio"]
        lines += [
            f"image,{way},{planes},1,1,{cost},{cost}"
            for way, cost in COSTS.items()
            for planes in (1, 3, 6)
        ]
        (folder / "costs.csv").write_text("\n".join(lines) + "\n")
        for number in range(first, first + count):
            check(
                sys.argv[1],
                make_scenes.scene(number),
                folder,
                0.01 if "--blind" in arguments else 1,
                found,
            )
    for what, share in {"dearer": 100, "overlooked": 200}.items():
        if found[what] > max(1, found["advised"] / share):
            found["problems"].append(f"more than one in {share} is {what}")
    if "--blind" in arguments:
        print(f"{len(found['problems'])} problems are seen")
        return not found["problems"]
    print("".join(f"{problem}\n" for problem in found["problems"]), end="")
    print(
        f"{count} scenes, {found['advised']} objects that a plane cuts, {found['meets']} said to meet ({found['unseen']} with hardly a cut in the image): "
        f"{len(found['problems'])} problems, {found['dearer']} dearer than needed, {found['overlooked']} overlooked"
    )
    return bool(found["problems"])


sys.exit(main())
