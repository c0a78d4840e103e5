# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Listings of ps_2_0 to ps_3_0 as GLSL.

What an instruction does is described in "Pixel Shader Instructions" of Direct3D 9's documentation, "ps_2_0", "ps_2_x" and "ps_3_0".
Products with 0 follow IEEE 754.
"""

import re

from listings.sampling import Texture
from listings.text import (
    COMPONENTS,
    LEVEL_9_BUFFER,
    LEVEL_9_SAMPLER,
    NotRun,
    split,
    swizzled,
)
from listings.written import size_of

# The value of an instruction of the sources a, b and c, each of four floats.
PLAIN = {
    "mov": "a",
    "abs": "abs(a)",
    "add": "a + b",
    "sub": "a - b",
    "mul": "a * b",
    "mad": "a * b + c",
    "lrp": "a * (b - c) + c",
    "min": "mix(b, a, lessThan(a, b))",
    "max": "mix(b, a, greaterThanEqual(a, b))",
    "frc": "fract(a)",
    "rcp": "1.0 / a",
    "rsq": "inversesqrt(abs(a))",  # the sign is ignored, as that of `log` and of the base of `pow`
    "exp": "exp2(a)",
    "log": "logarithm(a)",
    "pow": "pow(abs(a), b)",
    "nrm": "normalized(a)",
    "crs": "vec4(cross(a.xyz, b.xyz), 0.0)",
    "dp3": "vec4(dot(a.xyz, b.xyz))",
    "dp4": "vec4(dot(a, b))",
    "dp2add": "vec4(dot(a.xy, b.xy)) + c",
    "cmp": "mix(c, b, greaterThanEqual(a, vec4(0.0)))",
    "cnd": "mix(c, b, greaterThan(a, vec4(0.5)))",
    "sincos": "vec4(cos(a.x), sin(a.x), 0.0, 0.0)",  # ps_2_0 names two registers of constants too
    # y grows downwards in Direct3D and upwards in OpenGL.
    "dsx": "dFdx(a)",
    "dsy": "-dFdy(a)",
}
MATRICES = {"m4x4": (4, 4), "m4x3": (4, 3), "m3x4": (3, 4), "m3x3": (3, 3), "m3x2": (3, 2)}
COMPARISONS = {"gt": ">", "lt": "<", "ge": ">=", "le": "<=", "eq": "==", "ne": "!="}
FUNCTIONS = {
    "gt": "greaterThan",
    "lt": "lessThan",
    "ge": "greaterThanEqual",
    "le": "lessThanEqual",
    "eq": "equal",
    "ne": "notEqual",
}
FLOW = {
    "else": "} else {",
    "endif": "}",
    "endrep": "}",
    "endloop": "}",
    "break": "break;",
    "nop": "",
}
REGISTERS = 256  # ps_3_0 has 224 registers of floats
HELPERS = """
const float largest = 3.402823466e+38;
vec4 logarithm(vec4 v) { return mix(log2(abs(v)), vec4(-largest), equal(v, vec4(0.0))); }
vec4 normalized(vec4 v) {
  float square = dot(v.xyz, v.xyz);
  return v * (square == 0.0 ? largest : inversesqrt(square));
}
"""


def place_of(register):
    """GLSL's name of a register; `c4[aL]` is `c[4 + aL]`."""
    if register in ("vPos", "vFace", "oDepth", "aL"):
        return register
    if match := re.fullmatch(r"([rvt]\d+|oC[0-3]|p0)", register):
        return match[1]
    if match := re.fullmatch(r"([cib])(\d+)(?:\[(.*)\])?", register):
        return f"{match[1]}[{match[2]}{' + ' + match[3] if match[3] else ''}]"
    if match := re.fullmatch(r"([cib])\[(.*)\]", register):
        return f"{match[1]}[{match[2]}]"
    raise NotRun(f"operand {register}")


def source(text):
    """An operand as a vector of four floats."""
    sign = "-" if text.startswith("-") else ""
    register, _, swizzle = text[len(sign) :].partition(".")
    absolute = register.endswith("_abs")
    value = place_of(register.removesuffix("_abs"))
    value = (
        f"vec4({value})" if value in ("vFace", "aL", "oDepth") else f"{value}.{swizzled(swizzle)}"
    )
    if absolute:
        value = f"abs({value})"
    return f"({sign}{value})"


def condition(text):
    """An operand that is a bool: `b0`, `p0.x`, `!p0.x`."""
    sign = "!" if text.startswith("!") else ""
    register, _, swizzle = text[len(sign) :].partition(".")
    place = place_of(register)
    return f"{sign}{place}.{swizzle or 'x'}" if place == "p0" else f"{sign}{place}"


class Translator:
    def __init__(self, listing, written):
        self.samplers = samplers_of(listing, written)
        self.loops = 0

    def texture(self, sampler):
        if sampler not in self.samplers:
            raise NotRun(f"clipc has no texture {sampler}")
        return self.samplers[sampler]

    def sampled(self, op, parts):
        texture, place = self.texture(parts[2]), source(parts[1])
        if op == "texld":
            return texture.sample(place)
        if op == "texldp":
            return texture.sample(f"({place} / {place}.w)")
        if op == "texldb":
            return texture.sample(place, bias=f"{place}.w")
        if op == "texldl":
            return texture.sample_level(place, f"{place}.w")
        if op == "texldd":
            return texture.sample_gradients(place, source(parts[3]), source(parts[4]))
        raise NotRun(f"instruction {op}")

    def loop(self, count, step=""):
        self.loops += 1
        name = f"loop_{self.loops}"
        # A count is at most 255.
        return f"for (int {name} = 0; {name} < min({count}.x, 255); ++{name}{step}) {{"

    def flow(self, op, test, parts):
        """An instruction of control flow, or nothing."""
        if op in FLOW and not test:
            return FLOW[op]
        if op == "rep":
            return self.loop(place_of(parts[0]))
        if op == "loop":
            place = place_of(parts[1])
            return f"aL = {place}.y; " + self.loop(place, f", aL += {place}.z")
        effect = {"if": "{", "break": "break;", "breakp": "break;"}.get(op)
        if not effect:
            return None
        if test:
            return f"if ({source(parts[0])}.x {COMPARISONS[test]} {source(parts[1])}.x) {effect}"
        return f"if ({condition(parts[0])}) {effect}"

    def line(self, text):
        predicate = re.match(r"\((!?p0(?:\.[xyzw]+)?)\)\s*", text)
        if predicate:
            text = text[predicate.end() :]
        word, _, rest = text.partition(" ")
        op, *modifiers = word.split("_")
        parts = split(rest)
        test = next((each for each in modifiers if each in COMPARISONS), None)
        if (flow := self.flow(op, test, parts)) is not None:
            return flow
        if op == "texkill":
            # All components count since ps_2_0.
            return f"if (any(lessThan({source(parts[0])}, vec4(0.0)))) discard;"
        if op == "setp":
            operands = ", ".join(source(part) for part in parts[1:])
            value = f"{FUNCTIONS[test]}({operands})"
        elif op.startswith("texld"):
            value = self.sampled(op, parts)
        elif op in MATRICES:
            columns, rows = MATRICES[op]
            base = re.fullmatch(r"([a-z])(\d+)", parts[2])
            part = COMPONENTS[:columns]
            each = [
                f"dot({source(parts[1])}.{part}, {source(base[1] + str(int(base[2]) + i))}.{part})"
                for i in range(rows)
            ]
            value = f"vec4({', '.join(each + ['0.0'] * (4 - rows))})"
        elif op in PLAIN:
            operands = {letter: source(part) for letter, part in zip("abc", parts[1:])}
            value = re.sub(r"\b[abc]\b", lambda letter: operands[letter[0]], PLAIN[op])
        else:
            raise NotRun(f"instruction {op}")
        if "sat" in modifiers:
            value = f"clamp({value}, 0.0, 1.0)"
        return self.target(parts[0], value, predicate and predicate[1])

    def target(self, text, value, predicate):
        register, _, mask = text.partition(".")
        place = place_of(register)
        if place == "oDepth":
            return f"oDepth = ({value}).x;"
        mask = mask or COMPONENTS
        if predicate:
            sign, _, swizzle = predicate.lstrip("!").partition(".")
            test = f"{sign}.{swizzled(swizzle)}"
            test = f"not({test})" if predicate.startswith("!") else test
            value = f"mix({place}, {value}, {test})"
        return f"{place}.{mask} = ({value}).{mask};"


def samplers_of(listing, written):
    """The textures by sampler register. A row `sampler+texture` has a name of each."""
    if listing.is_level_9:
        return level_9_samplers(listing, written)
    textures = {}
    for resource, _, kind, name in written.textures():
        for part in ("texture", "sampler"):
            if part in resource:
                textures.setdefault(resource[part]["name"], []).append(Texture(kind, name))
    found = {}
    for name, kind, register, count in listing.registers():
        for i in range(count if kind == "s" else 0):
            given = textures.get(name.split("+")[-1].lstrip("$"), [])
            if i < len(given):
                found[f"s{register + i}"] = given[i]
    return found


def level_9_samplers(listing, written):
    textures = {}
    for resource, t, kind, name in written.textures():
        if "sampler" in resource:
            textures[t, int(resource["sampler"]["register"][1:])] = Texture(kind, name)
    return {
        f"s{register}": textures[int(t), int(s)]
        for register, s, t in LEVEL_9_SAMPLER.findall(listing.text)
        if (int(t), int(s)) in textures
    }


def level_9_constants(listing, written):
    blocks = {int(block["register"][1:]): block for block in written.reflection["cbuffers"]}
    begin, used = [], {}
    for register, buffer, start, count, kinds in LEVEL_9_BUFFER.findall(listing.text):
        block = blocks[int(buffer)]
        used[block["glsl"]["block"]] = block["size"]
        if set(re.findall(r"\w+", kinds)) != {"FLT"}:
            raise NotRun(f"constants of the kinds {kinds}")
        for i in range(int(count)):
            words = f"{block['glsl']['block']}_words[{int(start) + i}]"
            begin.append(f"c[{int(register) + i}] = {words};")
    return block_declarations(used), begin


def block_declarations(sizes):
    return [
        f"layout(std140) uniform {block} {{ vec4 {block}_words[{(size + 15) // 16}]; }};"
        for block, size in sizes.items()
    ]


def constants_of(listing, written):
    """Declarations of the blocks, and statements that fill the registers from them."""
    if listing.is_level_9:
        return level_9_constants(listing, written)
    begin, used = [], {}
    members = {
        member["name"].lstrip("$"): (block, member)
        for block in written.reflection["cbuffers"]
        for member in block["members"]
    }
    for name, kind, register, count in listing.registers():
        if kind == "s":
            continue
        if name.lstrip("$") not in members:
            raise NotRun(f"clipc has no constant {name}")
        block, member = members[name.lstrip("$")]
        scalar = re.match(r"(float|half|int|uint|bool|double)\w*", member["type"].split()[-1])
        if not scalar:
            raise NotRun(f"a constant of type {member['type']}")
        used[block["glsl"]["block"]] = block["size"]
        number = "{}" if scalar[1] in ("float", "half") else "vec4(ivec4(floatBitsToInt({})))"
        number = "vec4(notEqual(floatBitsToInt({}), ivec4(0)))" if scalar[1] == "bool" else number
        for i in range(count):
            offset = member["offset"] + 16 * i
            value = f"{block['glsl']['block']}_words[{offset // 16}].{swizzled(COMPONENTS[offset % 16 // 4 :])}"
            if kind == "i":
                value = f"floatBitsToInt({value})"
            elif kind == "b":
                value = f"floatBitsToInt({value}).x != 0"
            else:
                value = number.format(value)
            begin.append(f"{kind}[{register + i}] = {value};")
    return block_declarations(used), begin


def semantic_of(words, register, listing):
    """The semantic and index of an input: ps_2_0's t0 is TEXCOORD0 and its v0 COLOR0."""
    if listing.is_level_9:
        rows = [row for row in listing.rows("Input") if row.system == "NONE"]
        row = rows[int(register[1:])]
        return row.name.lower(), row.index
    usage = words[0] if words else "texcoord" if register[0] == "t" else "color"
    name, index = re.fullmatch(r"([a-z]+)(\d*)", usage).groups()
    return name, int((index if words else register[1:]) or 0)


def read_input(words, register, listing, written):
    """The statement that fills an input register."""
    register, _, mask = register.partition(".")
    mask = mask or COMPONENTS
    if register == "vPos":
        return "vPos = vec4(floor(gl_FragCoord.xy), 0.0, 0.0);"
    if register == "vFace":
        return "vFace = gl_FrontFacing ? 1.0 : -1.0;"
    words = [word for word in words if word not in ("pp", "centroid")]
    name, index = semantic_of(words, register, listing)
    given = written.inputs.get((name, index))
    if not given:
        raise NotRun(f"clipc does not read {name}{index}")
    value = f"vec4({given[3]}{', 0' * (4 - size_of(given[2]))})"
    return f"{register}.{mask} = {value}.{mask};"


def numbers(rest):
    return ", ".join(split(rest)[1:])


def translate(listing, written):
    """Declarations, statements before the others, statements, and the outputs."""
    declarations, begin = constants_of(listing, written)
    body, inputs, outputs = [], [], {}
    translator = Translator(listing, written)
    for line in listing.lines:
        word, _, rest = line.partition(" ")
        name, *words = word.split("_")
        register = split(rest)[0] if rest else ""
        if name == "def":
            begin.append(f"c[{register[1:]}] = vec4({numbers(rest)});")
        elif name == "defi":
            begin.append(f"i[{register[1:]}] = ivec4({numbers(rest)});")
        elif name == "defb":
            begin.append(f"b[{register[1:]}] = {numbers(rest)};")
        elif name == "dcl":
            if not register.startswith("s"):
                inputs.append(read_input(words, register, listing, written))
        else:
            body.append(translator.line(line))
            for output in re.findall(r"oC(\d)", register):
                outputs[f"target {output}"] = f"oC{output}"
            if register.startswith("oDepth"):
                outputs["depth"] = "vec4(oDepth)"
    registers = sorted(set(re.findall(r"\b[rvt]\d+|\boC\d", "\n".join([*inputs, *body]))))
    declarations += [f"vec4 {register};" for register in registers]
    declarations += [
        f"vec4 c[{REGISTERS}]; ivec4 i[16]; bool b[16]; bvec4 p0; int aL;",
        "vec4 vPos; float vFace, oDepth;",
        HELPERS,
    ]
    return declarations, begin + inputs, body, outputs


def shown(value, kind):
    """The register as GLSL's type of clipc's output."""
    return f"{kind}({value}.{COMPONENTS[: size_of(kind)]})"
