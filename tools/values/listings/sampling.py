# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""GLSL's calls that read textures, for each kind of texture."""

import re

from listings.text import NotRun

# The components of a coordinate with the element, and those of a texel offset.
FORMS = {
    "1D": (1, 1),
    "1DArray": (2, 1),
    "2D": (2, 2),
    "2DArray": (3, 2),
    "3D": (3, 3),
    "Cube": (3, 0),
    "CubeArray": (4, 0),
    "2DMS": (2, 2),
    "2DMSArray": (3, 2),
    "Buffer": (1, 1),
}
VECTORS = {"": ("float", "vec2", "vec3", "vec4"), "i": ("int", "ivec2", "ivec3", "ivec4")}
PARTS = ("x", "xy", "xyz", "xyzw")


class Texture:
    """A sampler of clipc's shader, by GLSL's type and name."""

    def __init__(self, kind, name):
        match = re.fullmatch(r"([iu]?)sampler(\w+?)(Shadow)?", kind)
        if not match or match[2] not in FORMS:
            raise NotRun(f"a texture of type {kind}")
        self.name, self.family, self.form = name, match[1], match[2]
        self.compares = bool(match[3])
        self.coordinates, self.axes = FORMS[self.form]

    def at(self, coordinate):
        return f"{coordinate}.{PARTS[self.coordinates - 1]}"

    def steps(self, value):
        """Derivatives have no component for the element of an array."""
        axes = 3 if self.form.startswith("Cube") else self.axes
        return f"{value}.{PARTS[axes - 1]}"

    def offset(self, numbers):
        if not self.axes:
            raise NotRun(f"an offset into a texture {self.form}")
        return f"{VECTORS['i'][self.axes - 1]}({', '.join(numbers[: self.axes])})"

    def read(self, function, coordinate, more=(), offset=None, bias=None):
        """A call of `function`, with its Offset form where there is an offset."""
        arguments = [self.name, coordinate, *more]
        if offset:
            function += "Offset"
            arguments.append(self.offset(offset))
        if bias:
            arguments.append(bias)
        return f"{function}({', '.join(arguments)})"

    def sample(self, coordinate, offset=None, bias=None):
        return self.read("texture", self.at(coordinate), (), offset, bias)

    def sample_level(self, coordinate, level, offset=None):
        return self.read("textureLod", self.at(coordinate), (level,), offset)

    def sample_gradients(self, coordinate, x, y, offset=None):
        steps = (self.steps(x), self.steps(y))
        return self.read("textureGrad", self.at(coordinate), steps, offset)

    def compare(self, coordinate, reference, at_level_0, offset=None):
        """Compares the texel with the reference; the result is one number."""
        if not self.compares:
            raise NotRun("a comparison with a texture that clipc does not compare")
        if self.form == "CubeArray":
            if at_level_0:
                raise NotRun("GLSL compares no level of an array of cubes")
            return f"vec4(texture({self.name}, {coordinate}, {reference}))"
        size = self.coordinates + 1
        unused = "0.0, " if self.form == "1D" else ""
        place = f"vec{size + bool(unused)}({self.at(coordinate)}, {unused}{reference})"
        if not at_level_0:
            call = self.read("texture", place, (), offset)
        elif self.form in ("1D", "2D"):
            call = self.read("textureLod", place, ("0.0",), offset)
        else:
            steps = 3 if self.form == "Cube" else self.axes
            zero = f"{VECTORS[''][steps - 1]}(0)"
            call = self.read("textureGrad", place, (zero, zero), offset)
        return f"vec4({call})"

    def gather(self, coordinate, component, offset=None):
        return self.read(
            "textureGather", self.at(coordinate), (), offset, None if self.compares else component
        )

    def gather_compared(self, coordinate, reference, offset=None):
        return self.read("textureGather", self.at(coordinate), (reference,), offset)

    def fetch(self, coordinate, sample=None, offset=None):
        """`coordinate` has ints, the level in its last component."""
        more = () if self.form == "Buffer" else (sample or f"{coordinate}.w",)
        return self.read("texelFetch", self.at(coordinate), more, offset)

    def size(self, level):
        """Width, height, depth or elements, and levels, as uints."""
        if self.form == "Buffer":
            return f"uvec4(textureSize({self.name}))"
        is_multisampled = "MS" in self.form
        size = f"textureSize({self.name}{'' if is_multisampled else ', ' + level})"
        count = 2 if self.form == "Cube" else 3 if self.form == "CubeArray" else self.coordinates
        levels = "1" if is_multisampled else f"textureQueryLevels({self.name})"
        return f"uvec4({size}{', 0' * (3 - count)}, {levels})"

    def bits(self, value):
        """The bits of a texel."""
        return {"": f"floatBitsToUint({value})", "i": f"uvec4({value})", "u": value}[self.family]
