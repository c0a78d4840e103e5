#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes scenes for `clipc-study scene` as people build them: round numbers, right angles, planes that are axes, places that
touch, and extremes of every kind.

scene(number) is the scene of that number, the same on every machine."""

import math
import random


def turn(axis, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    if degrees % 90 == 0:
        c, s = round(c), round(s)
    i, j = [k for k in range(3) if k != axis]
    m = [[float(a == b) for b in range(3)] for a in range(3)]
    m[i][i] = m[j][j] = c
    m[i][j], m[j][i] = s, -s
    return m


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def flat(m, place):
    """Sixteen numbers for row vectors."""
    return [x for row in m for x in (*row, 0.0)] + [*place, 1.0]


class Style:
    """One way that people build scenes: a camera at `eye` that looks along +z, and things at `depth`."""

    def __init__(self, r):
        self.r = r
        self.camera = {
            "name": "c",
            "aspect": r.choice([1, 4 / 3, 16 / 9, 21 / 9]),
            "near": 0.1,
            "far": 1000,
            "fov": 60,
        }
        self.depth = r.choice([2, 5, 10, 30, 100])
        self.size = 0.3
        self.eye = [0.0, 0.0, 0.0]
        self.baked = False
        self.away = 0.0  # of the object's vertices from their origin
        self.shape = [[1.0, 0, 0], [0, 1.0, 0], [0, 0, 1.0]]
        self.normal = None
        self.parts = [1]  # of the way from the eye to the things, where the planes are


def game(s):
    s.camera |= {
        "near": s.r.choice([0.01, 0.05, 0.1, 0.3]),
        "far": s.r.choice([1000, 10000]),
        "fov": s.r.choice([50, 60, 75, 90, 110]),
    }
    s.eye = [s.r.randrange(-200, 200), 1.7, s.r.randrange(-200, 200)]


def cockpit(s):
    s.camera |= {"near": s.r.choice([0.001, 0.0001]), "far": 1e6, "reversed": s.r.random() < 0.3}
    s.depth = s.r.choice([0.5, 50, 2000])


def telescope(s):
    s.camera |= {"fov": s.r.choice([0.25, 0.5, 1, 2, 5]), "near": 1, "far": 1e6}
    s.depth = s.r.choice([100, 1000, 30000])


def survey(s):
    """Vertices in coordinates of a country's grid."""
    s.eye = [
        s.r.choice([1, -1]) * s.r.randrange(10**4, 7 * 10**6),
        s.r.randrange(0, 3000),
        s.r.randrange(10**4, 7 * 10**6),
    ]
    s.camera |= {"near": 1, "far": 20000}
    s.depth, s.baked = s.r.choice([100, 1000]), s.r.random() < 0.6


def drawing(s):
    """A part in a CAD program: orthographic, cut by sections along the axes."""
    half = s.r.choice([0.001, 0.05, 1, 25, 1000])
    s.camera |= {"orthographic": True, "half_height": half, "reversed": s.r.random() < 0.3}
    s.depth = half * s.r.choice([0.5, 10, 300, 20000])
    s.camera |= {"near": s.depth / 1000, "far": s.depth * s.r.choice([3, 20])}
    s.normal = s.r.choice([[1, 0, 0], [0, 1, 0], [0, 0, -1], [1, 1, 0]])


def sun(s):
    s.camera |= {
        "orthographic": True,
        "half_height": 2.0 ** s.r.randrange(2, 9),
        "near": 1,
        "far": 60000,
        "aspect": 1,
    }
    s.depth = s.r.choice([500, 20000])


def tile(s):
    s.camera |= {
        "offset": [s.r.choice([-5, -3, -1, 1, 3, 5]), s.r.choice([-3, -1, 1, 3])],
        "near": 0.5,
    }


def mirror(s):
    s.shape = [
        [s.r.choice([-1, -2, 0.01]), 0, 0],
        [0, s.r.choice([1, 100]), 0],
        [0, 0, s.r.choice([-1, 1, 0.125])],
    ]
    s.camera |= {"infinite": True, "near": s.r.choice([0.02, 0.2]), "reversed": s.r.random() < 0.5}


def sheared(s):
    s.shape = [
        [1, s.r.choice([0, 0.5, 3]), 0],
        [0, 1, s.r.choice([0, 0.25])],
        [s.r.choice([0, 2]), 0, 1],
    ]


def terrain(s):
    """One mesh of a whole country, of which a part is seen."""
    s.away = s.r.choice([100, 1e4, 1e6])
    s.camera |= {"near": 0.5, "far": 1e5}


def edge_on(s):
    """A plane that nearly holds the eye."""
    s.normal = [s.r.choice([-1, 1]), s.r.choice([0, 0.5]), s.r.choice([0, 1e-3, 1e-6])]
    s.camera |= {"near": s.r.choice([0.01, 1])}


def hall(s):
    """One mesh around the eye, which one plane cuts next to the eye and another far away."""
    s.camera |= {"near": s.depth / 2000, "far": 100 * s.depth}
    s.size = s.r.choice([10, 40])
    s.parts = [s.r.choice([0.003, 0.01]), s.r.choice([1, 3])]
    s.normal = s.r.choice([[1, 0.2, 0.7], [-0.6, 0.3, -0.9]])


STYLES = (
    game,
    cockpit,
    telescope,
    survey,
    drawing,
    sun,
    tile,
    mirror,
    sheared,
    terrain,
    edge_on,
    hall,
)


def add_object(s, number, middle, scene):
    r = s.r
    half = s.high * s.size * r.choice([0.1, 0.5, 1, 3])
    box = [half * r.choice([1, 1, 0.25]) for _ in range(3)]
    shape = s.shape
    for _ in range(r.randrange(3)):
        shape = times(shape, turn(r.randrange(3), r.choice([30, 45, 90, 180, 17.3])))
    origin = [s.away * r.choice([-1, 0.5, 1]) for _ in range(3)]
    if s.baked:
        shape, origin, place = turn(0, 0), list(middle), [0.0, 0.0, 0.0]
    else:
        place = [middle[j] - sum(origin[i] * shape[i][j] for i in range(3)) for j in range(3)]
    scene["objects"].append(
        {
            "name": f"object {number}",
            "rigid": r.random() < 0.7,
            "world": flat(shape, place),
            "low": [o - b for o, b in zip(origin, box)],
            "high": [o + b for o, b in zip(origin, box)],
        }
    )


def scene(number):
    r = random.Random(f"scene {number}")
    s = Style(r)
    style = STYLES[number % len(STYLES)]
    style(s)
    # A third of all scenes have things so large that planes at several depths cut them.
    if len(s.parts) == 1 and r.random() < 0.3:
        s.size = r.choice([1, 3, 10])
        s.parts = [1, r.choice([0.02, 0.1, 0.5]), r.choice([0.3, 1.5, 3])]
    # Looks along an axis, or nearly; a turned camera has its things before it.
    yaw = math.radians(r.choice([0, 90, 180, 30, 0.01]))
    s.camera |= {"eye": s.eye, "yaw": yaw}
    tangent = math.tan(math.radians(s.camera["fov"]) / 2)
    s.high = s.camera["half_height"] if s.camera.get("orthographic") else s.depth * tangent
    off = s.camera.get("offset", [0, 0])
    across = [-off[0] * s.high * s.camera["aspect"], -off[1] * s.high]
    forward, right = [math.sin(yaw), 0, math.cos(yaw)], [math.cos(yaw), 0, -math.sin(yaw)]

    def before(x, y, depth):
        return [s.eye[j] + depth * forward[j] + x * right[j] + y * (j == 1) for j in range(3)]

    made = {
        "schema": "clipc.study-scene",
        "version": 1,
        "name": f"{style.__name__} {number}",
        "cameras": [s.camera],
        "planes": [],
        "objects": [],
        "picture_height": r.choice([480, 1080, 2160, 4096]),
        "tolerance": r.choice([0.01, 0.05, 0.1, 0.25, 0.5, 1]),
        "one_matrix": r.choice(
            [True, True, False, "world-view", "three", "float", "float-world-view"]
        ),
        "can_discard": r.random() < 0.7,
    }
    middle = before(*across, s.depth)
    for plane in range(max(len(s.parts), r.choice([1, 1, 2, 3]))):
        normal = s.normal or r.choice(
            [
                [0, 1, 0],
                [0, -1, 0],
                [1, 0, 0],
                [0, 0, 1],
                [1, 1, 0],
                [3, 4, 0],
                [1, 2, 2],
                [r.uniform(-1, 1) for _ in range(3)],
            ]
        )
        length = r.choice([1, 1, 1, 0.5, 1e-9, 1e9])
        normal = [length * n for n in normal]
        through = (
            middle
            if s.normal and not s.camera.get("orthographic") and style is not edge_on
            else [m + s.high * r.choice([0, 0.1, -0.2]) for m in middle]
        )
        part = s.parts[plane % len(s.parts)]
        through = [e + part * (t - e) for e, t in zip(s.eye, through)]
        made["planes"].append(
            {
                "name": f"plane {plane}",
                "plane": [*normal, -sum(n * t for n, t in zip(normal, through))],
            }
        )
    if number % 29 == 0:
        made["planes"].append({"name": "nothing", "plane": [0, 0, 0, r.choice([0, 1])]})
    for each in range(r.choice([1, 3, 6])):
        add_object(s, each, [m + s.high * r.choice([0, 0.25, -0.3]) for m in middle], made)
    return made
