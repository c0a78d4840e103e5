#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes an effect that clipc has compiled as a C header, for runtime/gl/effect.h.

    clipc --effect water.fx -o shaders --target=glsl330 --reflect=.json
    effect_table.py shaders/water.json -o water.effect.h [--name water_effect] [--flip-y]

The header has `static const clipc_gl_effect_table NAME`, with the GLSL in it. States, samplers and default values become
OpenGL's as docs/effects.md says; what has no OpenGL call, or depends on a parameter, is named on stderr, and --strict makes that an
error. Give --flip-y where clipc got it.
"""

import argparse
import json
import pathlib
import re
import sys

from effect_states import (
    CCW,
    CW,
    DIRECT3D9,
    GL_FUNC,
    GL_TARGET,
    GL_WRAP,
    OBJECT_DEFAULTS,
    OBJECTS,
    STATES,
    Unknown,
    float_bits,
    number,
    numbers,
    split,
    unsigned,
    word,
)


class Table:
    def __init__(self, path, flips):
        self.path = path
        self.effect = json.loads(path.read_text())
        self.flips = flips
        self.problems = []
        self.parameters = {p["name"]: p for p in self.effect["parameters"]}
        self.techniques, self.passes, self.states, self.programs, self.uses = [], [], [], [], []
        self.samplers, self.planes, self.textures, self.samplings, self.blocks = [], [], [], [], []
        self.places = {}  # by the parameter's name: what reflection says, and [block, offset, row_major]...
        self.by_files = {}

    def problem(self, text):
        if text not in self.problems:
            self.problems.append(text)

    # ---- states

    def object_states(self, call, value, where):
        """SetBlendState(Blend, float4(0, 0, 0, 0), 0xFFFFFFFF)"""
        arguments = split(value.strip()[1:-1])
        found = dict(OBJECT_DEFAULTS[call])
        name = arguments[0] if arguments else ""
        if name.upper() != "NULL":
            if name not in self.parameters or "states" not in self.parameters[name]:
                self.problem(f"{where}: `{name}` of {call} is not a block of states")
            else:
                for state in self.parameters[name]["states"]:
                    self.add_state(
                        found, OBJECTS[call], state["name"], state["value"], f"{where}: `{name}`"
                    )
        try:
            if call == "SETBLENDSTATE" and len(arguments) > 1:
                colors = numbers(arguments[1])
                for channel, color in zip(("RED", "GREEN", "BLUE", "ALPHA"), colors, strict=False):
                    found[f"BLEND_{channel}"] = float_bits(float(color))
            if call == "SETBLENDSTATE" and len(arguments) > 2:
                found["SAMPLE_MASK"] = unsigned(arguments[2])
            if call == "SETDEPTHSTENCILSTATE" and len(arguments) > 1:
                found["STENCIL_REFERENCE"] = unsigned(arguments[1])
        except Unknown as value:
            self.problem(f"{where}: `{value}` of {call} is not a constant")
        return found

    def add_state(self, found, known, name, value, where):
        index = re.search(r"\[\s*(\d+)\s*\]", name)
        key = re.sub(r"\[.*\]|_", "", name).strip().upper()
        number_of = int(index[1]) if index else 0
        if number_of and (key + str(number_of)) in known:
            key += str(number_of)
        elif number_of:
            return (
                None if key in known else self.problem(f"{where}: `{name}` has no OpenGL call here")
            )
        if key in ("BLENDFACTOR",):
            try:
                color = unsigned(value)
            except Unknown:
                return self.problem(f"{where}: `{name} = {value}` is not a constant")
            for channel, shift in (("RED", 16), ("GREEN", 8), ("BLUE", 0), ("ALPHA", 24)):
                found[f"BLEND_{channel}"] = float_bits((color >> shift & 255) / 255)
            return None
        if key not in known:
            return self.problem(f"{where}: `{name}` has no OpenGL call here")
        try:
            state, read = known[key]
            found[state] = read(value)
        except (Unknown, KeyError, ValueError):
            self.problem(f"{where}: `{name} = {value}` is not a constant of that state")
        return None

    def states_of(self, a_pass, where):
        found = {}
        for state in a_pass["states"]:
            name = state["name"].upper()
            if name in OBJECTS:
                found.update(self.object_states(name, state["value"], where))
            elif re.fullmatch(r"(SAMPLER|TEXTURE)\s*\[.*\]", name):
                continue  # the shader's own sampler says the same
            else:
                self.add_state(found, DIRECT3D9, state["name"], state["value"], where)
        if self.flips:
            found["FRONT_FACE"] = CW if found.get("FRONT_FACE") == CCW else CCW
        return [
            (STATES.index(state), value)
            for state, value in sorted(found.items(), key=lambda s: STATES.index(s[0]))
        ]

    # ---- samplers

    def sampling(self, name, is_old):
        states = {
            re.sub(r"_", "", s["name"]).upper(): s["value"]
            for s in self.parameters.get(name, {}).get("states", [])
        }
        texture = re.sub(r"[<>()\s]", "", states.pop("TEXTURE", ""))
        made = {"min": "POINT" if is_old else "LINEAR", "mag": "POINT" if is_old else "LINEAR", "mip": "NONE" if is_old else "LINEAR",
                "wrap": [GL_WRAP["WRAP" if is_old else "CLAMP"]] * 3, "compare": 0, "anisotropy": 1, "min_lod": -1000.0, "max_lod": 1000.0,
                "bias": 0.0, "border": [0.0] * 4 if is_old else [1.0] * 4, "anisotropic": False}  # fmt: skip
        for key, value in states.items():
            try:
                self.add_sampling(made, key, value)
            except (Unknown, KeyError, ValueError, IndexError):
                self.problem(f"sampler `{name}`: `{key} = {value}` has no OpenGL call here")
        linear = {"POINT": 0, "NONE": 0}
        filters = {
            (0, "NONE"): 0x2600,
            (1, "NONE"): 0x2601,
            (0, "POINT"): 0x2700,
            (1, "POINT"): 0x2701,
            (0, "LINEAR"): 0x2702,
            (1, "LINEAR"): 0x2703,
        }
        mip = made["mip"] if made["mip"] in ("NONE", "POINT") else "LINEAR"
        anisotropy = made["anisotropy"] if "ANISOTROPIC" in (made["min"], made["mag"]) else 1
        key = (filters[(linear.get(made["min"], 1), mip)], 0x2601 if linear.get(made["mag"], 1) else 0x2600, *made["wrap"], made["compare"],
               float(anisotropy), made["min_lod"], made["max_lod"], made["bias"], *made["border"])  # fmt: skip
        if key not in self.samplings:
            self.samplings.append(key)
        return self.samplings.index(key), texture

    def add_sampling(self, made, key, value):
        kinds = dict.fromkeys(("POINT", "LINEAR", "ANISOTROPIC", "NONE"))
        kinds = {kind: kind for kind in kinds}
        if key in ("MINFILTER", "MAGFILTER", "MIPFILTER"):
            made[key[:3].lower()] = word(value, kinds)
        elif key in ("ADDRESSU", "ADDRESSV", "ADDRESSW"):
            made["wrap"]["UVW".index(key[-1])] = word(value, GL_WRAP)
        elif key == "FILTER":
            self.add_filter(made, value.strip().upper())
        elif key == "BORDERCOLOR":
            color = numbers(value)
            if len(color) == 1 and isinstance(color[0], int):
                color = [(color[0] >> shift & 255) / 255 for shift in (16, 8, 0, 24)]
            made["border"] = [float(c) for c in (color + [1.0] * 4)[:4]]
        elif key in ("MAXANISOTROPY",):
            made["anisotropy"] = number(value)
        elif key in ("MIPMAPLODBIAS", "MIPLODBIAS"):
            made["bias"] = float(number(value))
        elif key in ("MAXMIPLEVEL", "MINLOD"):
            made["min_lod"] = float(number(value))
        elif key == "MAXLOD":
            made["max_lod"] = float(number(value))
        elif key == "COMPARISONFUNC":
            made["compare"] = word(value, GL_FUNC)
        else:
            raise Unknown(value)

    def add_filter(self, made, text):
        """MIN_MAG_LINEAR_MIP_POINT, COMPARISON_ANISOTROPIC"""
        text = re.sub(r"^D3D1[01]_FILTER_|^FILTER_", "", text)
        if text.startswith("COMPARISON_"):
            text = text[len("COMPARISON_") :]
            made["compare"] = made["compare"] or GL_FUNC["NEVER"]
        if text == "ANISOTROPIC":
            text = "MIN_MAG_MIP_LINEAR"
            made["min"] = made["mag"] = "ANISOTROPIC"
            made["mip"] = "LINEAR"
            return
        waiting = []
        for part in text.split("_"):
            if part in ("MIN", "MAG", "MIP"):
                waiting.append(part.lower())
            elif part in ("POINT", "LINEAR"):
                for name in waiting:
                    made[name] = part
                waiting = []
            else:
                raise Unknown(text)

    # ---- programs

    def program(self, files, where):
        key = (
            files.get("vertex"),
            files.get("fragment"),
            files.get("reflect") or files.get("reflection"),
        )
        if key in self.by_files:
            return self.by_files[key]
        folder = self.path.parent
        report = next((files[k] for k in ("reflection", "reflect") if k in files), None)
        if not files.get("vertex") or not report:
            self.problem(
                f"{where}: "
                + (
                    "there is no vertex shader"
                    if report
                    else "there is no reflection; give clipc --reflect=.json"
                )
            )
            return None
        text = [
            (folder / files[k]).read_text() if k in files else None for k in ("vertex", "fragment")
        ]
        reflection = json.loads((folder / report).read_text())
        uses, samplers = {}, []
        for stage, glsl_text in zip((reflection, reflection.get("pixelShader")), text, strict=True):
            if stage is None:
                continue
            for block in stage["cbuffers"]:
                self.add_block(block, uses, where)
            for resource in stage["resources"]:
                self.add_sampler(resource, glsl_text, samplers, where)
        planes = [(plane["index"], plane["text"]) for plane in reflection.get("clipPlanes", [])]
        made = (
            text,
            (len(self.uses), len(uses)),
            (len(self.samplers), len(samplers)),
            (len(self.planes), len(planes)),
        )
        self.uses += uses.items()
        self.samplers += samplers
        self.planes += planes
        self.programs.append(made)
        self.by_files[key] = len(self.programs) - 1
        return len(self.programs) - 1

    def add_block(self, block, uses, where):
        glsl = block.get("glsl", {})
        if not block["used"] or not block["size"]:
            return
        if glsl.get("layout") != "std140" or block.get("count", 1) != 1:
            self.problem(
                f"{where}: the buffer `{block['name']}` is not a block of std140; a target from glsl140 and essl300 on has them"
            )
            return
        members = tuple(
            (m["name"], m["type"], m["offset"], m["size"], m.get("rowMajor", False))
            for m in block["members"]
        )
        key = (block["name"], block["size"], members)
        if key not in self.blocks:
            self.blocks.append(key)
            for name, kind, offset, size, row_major in members:
                self.places.setdefault(name, (kind, size, []))[2].append(
                    (len(self.blocks) - 1, offset, int(row_major))
                )
        uses[glsl["block"]] = self.blocks.index(key)

    def add_sampler(self, resource, glsl_text, samplers, where):
        texture, sampler = resource.get("texture"), resource.get("sampler")
        if not texture or any(name == resource["glsl"] for name, *_ in samplers):
            return
        # A sampler of Direct3D 9 whose type does not say a dimension has that of its use, which the GLSL says.
        is_old = "sampler" in texture["type"].lower()
        declared = re.search(
            rf"uniform (?:\w+ )?[iu]?sampler(\w+?)(?:Shadow)? {re.escape(resource['glsl'])}\b",
            glsl_text,
        )
        target = GL_TARGET.get(declared[1].upper()) if declared else None
        if target is None:
            return self.problem(
                f"{where}: `{texture['name']}` of type {texture['type']} is set by the application"
            )
        sampling, named = self.sampling(
            texture["name"] if is_old or not sampler else sampler["name"], is_old
        )
        wanted = (named if is_old and named else texture["name"], target)
        if wanted not in self.textures:
            self.textures.append(wanted)
        samplers.append((resource["glsl"], self.textures.index(wanted), sampling))
        return None

    def read(self):
        for technique in self.effect["techniques"]:
            first = len(self.passes)
            for number_of, a_pass in enumerate(technique["passes"]):
                where = f"{technique['name'] or 'technique'}.{a_pass['name'] or number_of}"
                programs = [p for p in a_pass["programs"] if p["status"] == "compiled"]
                if not programs:
                    self.problem(f"{where} has no program")
                for number_of_program, program in enumerate(programs):
                    made = self.program(program["files"], where)
                    if made is None:
                        continue
                    states = self.states_of(a_pass, where)
                    suffix = "" if len(programs) == 1 else f".{number_of_program}"
                    self.passes.append(
                        (a_pass["name"] + suffix, made, len(self.states), len(states))
                    )
                    self.states += states
            self.techniques.append((technique["name"], first, len(self.passes) - first))

    # ---- parameters

    def shape(self, name):
        kind, size, _ = self.places[name]
        shape = re.fullmatch(
            r"(?:row_major |column_major )?(?:float|int|uint|bool|half|min\w+?(?=\d|$))(\d?)(?:x(\d))?((?:\[\d+\])*)",
            kind,
        )
        if not shape:
            return 0, size, 0
        rows, columns = (int(shape[1]), int(shape[2])) if shape[2] else (1, int(shape[1] or 1))
        elements = 1
        for dimension in re.findall(r"\d+", shape[3]):
            elements *= int(dimension)
        return rows, columns, elements if shape[3] else 0

    def value(self, name):
        """The words of the default value, as they lie in a buffer."""
        data = bytes.fromhex(self.parameters.get(name, {}).get("default", ""))
        return [int.from_bytes(data[at : at + 4], "little") for at in range(0, len(data), 4)]

    # ---- the header

    def render(self, name):
        out = ["/* Made by clipc's effect_table.py. */", "#ifndef CLIPC_EFFECT_" + name.upper(), "#define CLIPC_EFFECT_" + name.upper() + " 1", "",
               '#include <clipc/runtime/gl/effect.h>', ""]  # fmt: skip
        parameters, places = [], []
        for parameter in self.places:
            shape = self.shape(parameter)
            value = self.value(parameter)
            array = "0"
            if value:
                array = f"{name}_value_{len(parameters)}"
                out.append(
                    f"static const uint32_t {array}[] = {{{', '.join(f'0x{v:08X}u' for v in value)}}};"
                )
            at = self.places[parameter][2]
            semantic = self.parameters.get(parameter, {}).get("semantic", "")
            parameters.append(
                f"{{{quoted(parameter)}, {quoted(semantic)}, {shape[0]}, {shape[1]}, {shape[2]}, {len(places)}, {len(at)}, {array}, {len(value)}}}"
            )
            places += [f"{{{block}, {offset}, {row_major}}}" for block, offset, row_major in at]
        lists = [
            ("technique", [f"{{{quoted(t)}, {first}, {count}}}" for t, first, count in self.techniques]),
            ("pass", [f"{{{quoted(p)}, {program}, {first}, {count}}}" for p, program, first, count in self.passes]),
            ("state", [f"{{CLIPC_GL_{STATES[state]}, 0x{value:X}u}}" for state, value in self.states]),
            ("program", [f"{{{glsl(text[0])}, {glsl(text[1])}, {u[0]}, {u[1]}, {s[0]}, {s[1]}, {p[0]}, {p[1]}}}" for text, u, s, p in self.programs]),
            ("use", [f"{{{quoted(block)}, {i}}}" for block, i in self.uses]),
            ("sampler", [f"{{{quoted(s)}, {texture}, {sampling}}}" for s, texture, sampling in self.samplers]),
            ("plane", [f"{{{index}, {quoted(text)}}}" for index, text in self.planes]),
            ("texture", [f"{{{quoted(t)}, 0x{target:X}u}}" for t, target in self.textures]),
            ("sampling", ["{" + ", ".join(f"0x{v:X}u" if isinstance(v, int) else f"{v!r}f" for v in s[:10]) + ", {" + ", ".join(f"{v!r}f" for v in s[10:]) + "}}" for s in self.samplings]),
            ("parameter", parameters), ("place", places),
        ]  # fmt: skip
        for kind, rows in lists:
            if rows:
                body = ",\n    ".join(rows)
                out.append(
                    f"static const clipc_gl_effect_{kind} {name}_{plural(kind)}[] = {{\n    {body}}};"
                )
        if self.blocks:
            out.append(
                f"static const uint32_t {name}_block_sizes[] = {{{', '.join(str(b[1]) for b in self.blocks)}}};"
            )
        named = [f"{name}_{plural(kind)}" if rows else "0" for kind, rows in lists] + [
            f"{name}_block_sizes" if self.blocks else "0"
        ]
        counts = [
            len(x)
            for x in (
                self.techniques,
                self.programs,
                self.textures,
                self.samplings,
                parameters,
                self.blocks,
            )
        ]
        out.append(
            f"static const clipc_gl_effect_table {name} = {{\n    {', '.join(named)},\n    {', '.join(map(str, counts))}}};"
        )
        return "\n".join(out) + "\n\n#endif\n"


def plural(kind):
    return kind + ("es" if kind.endswith("s") else "s")


def quoted(text):
    return (
        '"'
        + "".join(
            c
            if c.isprintable() and c.isascii() and c not in '"\\?'
            else "".join(f"\\{b:03o}" for b in c.encode())
            for c in text
        )
        + '"'
    )


def glsl(text):
    return (
        "0"
        if text is None
        else "\n        " + "\n        ".join(quoted(line + "\n") for line in text.splitlines())
    )


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("effect", type=pathlib.Path, help="the JSON that clipc --effect wrote")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--name", help="of the table; the file's name and _effect without this")
    parser.add_argument("--flip-y", action="store_true")
    parser.add_argument("--strict", action="store_true", help="what is named on stderr is an error")
    arguments = parser.parse_args()
    name = arguments.name or re.sub(r"\W", "_", arguments.effect.stem) + "_effect"
    table = Table(arguments.effect, arguments.flip_y)
    table.read()
    text = table.render(name)
    for problem in table.problems:
        print(f"effect_table.py: {table.effect['effect']}: {problem}", file=sys.stderr)
    if arguments.strict and table.problems:
        return 1
    pathlib.Path(arguments.output).write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
