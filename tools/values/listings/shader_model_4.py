# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Listings of ps_4_0 to ps_5_1 as GLSL.

Registers have no type there: each is four uints, and an instruction reads and writes the bits. What an instruction does is described in
"Shader Model 4 Assembly" and "Shader Model 5 Assembly" of Microsoft's documentation.
"""

import re

from listings.operations import (
    BITS,
    COMPARISONS,
    CONVERSIONS,
    FLOW,
    HELPERS,
    INTO_TWO,
    KINDS,
    PLAIN,
)
from listings.sampling import Texture
from listings.text import COMPONENTS, NotRun, split, swizzled
from listings.written import size_of

# The condition of these ends in `_z` or `_nz`.
CONDITIONAL = {
    "if": " {",
    "breakc": " break;",
    "continuec": " continue;",
    "retc": " return;",
    "discard": " discard;",
}
# The values of system values, by the name that a signature has for them.
SYSTEM_VALUES = {
    "POS": "vec4(gl_FragCoord.xyz, 1.0 / gl_FragCoord.w)",
    "FFACE": "uvec4(gl_FrontFacing ? 0xFFFFFFFFu : 0u)",
    "PRIMID": "uvec4(gl_PrimitiveID)",
    "SAMPLE": "uvec4(gl_SampleID)",
    "RTINDEX": "uvec4(gl_Layer)",
    "VPINDEX": "uvec4(gl_ViewportIndex)",
    "COVERAGE": "uvec4(gl_SampleMaskIn[0])",
}


def literal(number):
    """The bits of a number of a listing: with a point it is a float."""
    if re.search(r"[.]|nan|inf", number, re.I) and not number.startswith("0x"):
        return f"floatBitsToUint({number})"
    return f"{int(number, 0) & 0xFFFFFFFF}u"


def indexed(index):
    """An index in brackets, with registers in it as ints."""
    return re.sub(r"\b([rv]\d+|x\d+\[[^\]]*\])\.([xyzw])", r"int(\1.\2)", index)


def source(text, kind):
    """An operand as a vector of four of the kind."""
    sign = text.startswith("-")
    text = text[sign:]
    absolute = text.startswith("|")
    text = text.strip("|")
    if text.startswith("l("):
        numbers = [literal(part) for part in split(text[2:-1])]
        value = f"uvec4({', '.join(numbers * (4 if len(numbers) == 1 else 1))})"
    else:
        match = re.fullmatch(r"(.*?)(?:\.([xyzw]+))?", text)
        value = match[1]
        if not re.match(r"([rvo]\d+$|icb\[|[cC][bB]\d+\[|x\d+\[|vCoverage$)", value):
            raise NotRun(f"operand {text}")
        if place := re.fullmatch(r"(\w+)\[(.*)\]", value):
            value = f"{place[1].lower()}[{indexed(place[2])}]"
            if value.startswith("cb"):
                value = f"floatBitsToUint(words_{value})"
        value += "." + swizzled(match[2])
    value = KINDS[kind].format(value)
    if absolute:
        value = f"abs({value})"
    return f"(-{value})" if sign else f"({value})"


def target(text, value):
    """The statement that writes the bits `value`, a vector of four, to the operand."""
    if text == "null":
        return ""
    if scalar := re.match(r"oDepth|oMask", text):
        return f"{scalar[0]}_out = ({value}).x;"
    match = re.fullmatch(r"(r\d+|o\d+|x\d+\[.*\])(?:\.([xyzw]+))?", text)
    if not match:
        raise NotRun(f"target {text}")
    mask = match[2] or COMPONENTS
    return f"{indexed(match[1])}.{mask} = ({value}).{mask};"


def saturated(value, is_clamped):
    return f"clamp({value}, 0.0, 1.0)" if is_clamped else value


def swizzle_of(operand):
    return swizzled((re.search(r"\.([xyzw]+)$", operand) or [None, COMPONENTS])[1])


class Translator:
    def __init__(self, listing, written):
        self.textures = {}  # by (t, s); s is none for a texture without a sampler
        bindings = listing.bindings()
        for resource, t, kind, name in written.textures():
            texture, sampler = resource["texture"], resource.get("sampler")
            # A combined sampler of Direct3D 9 is a texture and a sampler of one number.
            sampler = texture if texture["register"][0] == "s" else sampler
            given = bindings.get(("texture", name), bindings.get(("texture", texture["name"])))
            element = t - int(texture["register"][1:])
            if given is not None:
                t = given + (0 if ("texture", name) in bindings else element)
            s = None
            if sampler:
                s = bindings.get(("sampler", sampler["name"]), int(sampler["register"][1:]))
            self.textures[t, s] = (kind, name)
        self.temporaries = 0

    def texture(self, texture, sampler=None):
        t = int(re.match(r"t(\d+)", texture)[1])
        s = int(re.match(r"s(\d+)", sampler)[1]) if sampler else None
        for (number, other), (kind, name) in self.textures.items():
            if number == t and (s is None or other == s):
                return Texture(kind, name)
        raise NotRun(f"clipc has no texture {texture}" + (f" with {sampler}" if sampler else ""))

    def temporary(self):
        self.temporaries += 1
        return f"temporary_{self.temporaries}"

    def sampled(self, op, parts, offset):
        """The bits of an instruction that reads a texture."""
        place = source(parts[1], "f")
        if op in ("ld", "ldms"):
            texture = self.texture(parts[2])
            sample = source(parts[3], "i") + ".x" if op == "ldms" else None
            value = texture.fetch(source(parts[1], "i"), sample, offset)
            return f"{texture.bits(value)}.{swizzle_of(parts[2])}"
        if op.startswith("gather4_po"):
            moved = source(parts.pop(2), "i")
            offset = [f"{moved}.x", f"{moved}.y"]
            op = op.replace("_po", "")
        texture = self.texture(parts[2], parts[3])
        more = [source(part, "f") for part in parts[4:]]
        if op == "sample":
            value = texture.sample(place, offset)
        elif op == "sample_l":
            value = texture.sample_level(place, f"{more[0]}.x", offset)
        elif op == "sample_b":
            value = texture.sample(place, offset, f"{more[0]}.x")
        elif op == "sample_d":
            value = texture.sample_gradients(place, more[0], more[1], offset)
        elif op in ("sample_c", "sample_c_lz"):
            value = texture.compare(place, f"{more[0]}.x", op == "sample_c_lz", offset)
        elif op == "gather4":
            value = texture.gather(place, str(COMPONENTS.index(swizzle_of(parts[3])[0])), offset)
        elif op == "gather4_c":
            value = texture.gather_compared(place, f"{more[0]}.x", offset)
        elif op == "lod":
            value = f"vec4(textureQueryLod({texture.name}, {texture.steps(place)}), 0, 0)"
        else:
            raise NotRun(f"instruction {op}")
        return f"{texture.bits(value)}.{swizzle_of(parts[2])}"

    def information(self, op, parts):
        """The bits of an instruction that asks for sizes."""
        name, _, form = op.partition("_")
        operand = parts[1 if name in ("sampleinfo", "bufinfo") else 2]
        texture = self.texture(operand)
        if name == "sampleinfo":
            value = f"uvec4(textureSamples({texture.name}), 0, 0, 0)"
        else:
            level = "0" if name == "bufinfo" else source(parts[1], "i") + ".x"
            value = texture.size(level)
        if form == "rcpFloat":
            value = f"reciprocal_sizes({value})"
        elif form != "uint" and name != "bufinfo":
            value = f"floatBitsToUint(vec4({value}))"
        return f"{value}.{swizzle_of(operand)}"

    def into_two(self, op, parts):
        """An instruction with two results, of which each may be null."""
        kind, results = INTO_TWO[op]
        operands = {}
        text = ""
        for letter, part in zip("abc", parts[2:]):
            name = self.temporary()
            text += f"{'i' if kind == 'i' else 'u' if kind == 'u' else ''}vec4 {name} = {source(part, kind)}; "
            operands[letter] = name
        for part, result in zip(parts, results):
            value = re.sub(r"\b[abc]\b", lambda letter: operands[letter[0]], result)
            text += target(part, BITS[kind].format(value)) + " "
        return text

    def line(self, text):
        text = re.sub(r"\s*\{[^}]*\}|\[precise[^\]]*\]\s*", "", text)
        match = re.match(r"(\w+?)(_sat)?((?:\([^)]*\))*)\s+(.*)|(\w+)$", text)
        if not match:
            raise NotRun(text)
        op = match[1] or match[5]
        # Older compilers do not write `_aoffimmi`.
        offset = re.match(r"\(\s*(-?\d+\s*,\s*-?\d+\s*,\s*-?\d+)\s*\)", match[3] or "")
        offset = offset and [part.strip() for part in offset[1].split(",")]
        op = op.replace("_indexable", "").replace("_aoffimmi", "")
        parts = split(match[4] or "")
        if op in FLOW:
            return FLOW[op]
        if op.endswith(("_z", "_nz")) and op != "round_z":
            word, test = op.rsplit("_", 1)
            if word in CONDITIONAL:
                condition = f"{source(parts[0], 'u')}.x {'==' if test == 'z' else '!='} 0u"
                return f"if ({condition}){CONDITIONAL[word]}"
        if op == "discard" and parts == ["l(-1)"]:
            return "discard;"
        if op == "switch":
            return f"switch ({source(parts[0], 'i')}.x) {{"
        if op == "case":
            return f"case int({literal(split(parts[0][2:-1])[0])}):"
        if op == "movc":
            condition = f"notEqual({source(parts[1], 'u')}, uvec4(0u))"
            chosen = [source(part, "f") for part in parts[2:]]
            value = f"mix({chosen[1]}, {chosen[0]}, {condition})"
            return target(parts[0], BITS["f"].format(saturated(value, match[2])))
        if op in INTO_TWO:
            return self.into_two(op, parts)
        if op in COMPARISONS:
            kind, function = COMPARISONS[op]
            operands = ", ".join(source(part, kind) for part in parts[1:])
            return target(parts[0], f"all_bits({function}({operands}))")
        if op in CONVERSIONS:
            kind, value = CONVERSIONS[op]
            return target(parts[0], re.sub(r"\ba\b", lambda _: source(parts[1], kind), value))
        if re.match(r"(resinfo|sampleinfo|bufinfo)", op):
            return target(parts[0], self.information(op, parts))
        if op.startswith(("sample", "gather4")) or op in ("ld", "ldms", "lod"):
            return target(parts[0], self.sampled(op, parts, offset))
        if op in PLAIN:
            kind, value = PLAIN[op]
            operands = {letter: source(part, kind) for letter, part in zip("abc", parts[1:])}
            value = re.sub(r"\b[abc]\b", lambda letter: operands[letter[0]], value)
            return target(parts[0], BITS[kind].format(saturated(value, match[2])))
        if op == "fcall":
            raise NotRun("an interface that the program binds when it runs")
        raise NotRun(f"instruction {op}")


def outputs_of(listing):
    """By the output's name: the register, and GLSL's expression of its bits."""
    found = {}
    for row in listing.rows("Output"):
        if row.register.startswith("oDepth"):
            found["depth"] = "uvec4(oDepth_out)"
        elif row.register.startswith("oMask"):
            found["coverage"] = "uvec4(oMask_out)"
        elif row.system == "TARGET":
            found[f"target {row.index}"] = f"o{row.register}"
        else:
            raise NotRun(f"the output {row.name}")
    return found


def read_inputs(listing, written):
    """The declarations of input registers, and the statements that fill them."""
    declarations, begin = [], []
    for row in listing.rows("Input"):
        register = row.register if row.register.startswith("v") else f"v{row.register}"
        declaration = f"uvec4 {register};"
        if declaration not in declarations:
            declarations.append(declaration)
        given = written.inputs.get((row.name.lower(), row.index))
        mask = COMPONENTS if row.mask == "N/A" else row.mask
        if row.system not in ("NONE", "POS") and not row.used:
            continue
        if row.system in SYSTEM_VALUES:
            value = SYSTEM_VALUES[row.system]
        elif row.system != "NONE":
            raise NotRun(f"the input {row.system}")
        elif given:
            family = {"i": "ivec4", "u": "uvec4"}.get(given[2][0], "vec4")
            value = f"{family}({given[3]}{', 0' * (4 - size_of(given[2]))})"
        else:
            continue  # not read
        bits = "floatBitsToUint(%s)" if value.startswith("vec") else "uvec4(%s)"
        begin.append(f"{register}.{mask} = ({bits % value}).{COMPONENTS[: len(mask)]};")
    return declarations, begin


def absolute_registers(line):
    """The line with registers as ps_5_0 has them: ps_5_1 numbers ranges, `T0[3]` is t3."""
    line = re.sub(r"\b([tTsS])\d+\[(\d+)\]", lambda m: f"{m[1].lower()}{m[2]}", line)
    return re.sub(r"\b[cC][bB]\d+\[(\d+)\]\[", r"cb\1[", line)


def translate(listing, written):
    """Declarations, statements before the others, statements, and the outputs as bits."""
    declarations, begin = read_inputs(listing, written)
    bindings = listing.bindings()
    blocks = {
        bindings.get(("cbuffer", block["name"]), int(block["register"][1:])): block["glsl"]["block"]
        for block in written.reflection["cbuffers"]
        if block.get("used", True)
    }
    declarations += [f"uvec4 o{i};" for i in range(8)]
    declarations += ["uint oDepth_out; uint oMask_out;", HELPERS]
    body = []
    translator = Translator(listing, written)
    for line in listing.lines:
        if listing.profile == "ps_5_1":
            buffer = re.sub(r"(CB)\d+\[(\d+):\d+\]\[(\d+)\]", r"\1\2[\3]", line)
            line = buffer if line.startswith("dcl_") else absolute_registers(line)
        if line.startswith("dcl_immediateConstantBuffer"):
            rows = [split(row) for row in re.findall(r"\{([^{}]*)\}", line)]
            values = ", ".join(f"uvec4({', '.join(map(literal, row))})" for row in rows)
            declarations.append(f"const uvec4 icb[] = uvec4[]({values});")
        elif match := re.match(r"dcl_constantbuffer (?i:cb)(\d+)\[(\d+)\]", line):
            name = blocks.get(int(match[1]))
            if name is None:
                raise NotRun(f"clipc has no buffer b{match[1]}")
            declarations.append(
                f"layout(std140) uniform {name} {{ vec4 words_cb{match[1]}[{match[2]}]; }};"
            )
        elif match := re.match(r"dcl_temps (\d+)", line):
            declarations += [f"uvec4 r{i};" for i in range(int(match[1]))]
        elif match := re.match(r"dcl_indexableTemp (x\d+)\[(\d+)\]", line):
            declarations.append(f"uvec4 {match[1]}[{match[2]}];")
        elif not line.startswith("dcl_"):
            body.append(translator.line(line))
    return declarations, begin, body, outputs_of(listing)


def shown(value, kind):
    """The bits as GLSL's type of clipc's output."""
    word = kind[0] if kind[0] in "iu" else "f"
    return f"{KINDS[word].format(value)}.{COMPONENTS[: size_of(kind)]}"
