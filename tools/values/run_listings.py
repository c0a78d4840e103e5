#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws fxc's listings beside clipc's GLSL of the same HLSL.

A listing of ps_4_0 to ps_5_0 becomes a fragment shader, instruction by instruction; `clipc-draw pair` draws it and clipc's with the same
vertices, uniforms and textures. The list has lines of a listing, an HLSL file, an entry and further options of clipc, with tabs between.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile


class NotRun(Exception):
    """What this tool does not translate."""


COMPONENTS = "xyzw"
TEXTURE = re.compile(r"uniform (\w+) (\w+);\s*// (?:\w+ : )?t(\d+)(?: with (?:\w+ : )?s(\d+))?")
BLOCK = re.compile(r"layout\(std140[^)]*\) uniform (\w+) \{\s*// b(\d+)")
INPUT = re.compile(
    r"^(?:layout\(location = (\d+)\) )((?:\w+ )*?)in (\w+) (\w+);\s*// \S+ : (\w+?)(\d+)$", re.M
)
OUTPUT = re.compile(r"^layout\(location = 0\) out (\w+) (\w+);.*$", re.M)
OUTPUTS = re.compile(r"^layout\(location = (\d+)\) out (\w+) (\w+);.*$", re.M)
SIGNATURE = re.compile(r"^// (\w+)\s+(\d+)\s+([xyzw]+|N/A)\s+(\d+|oDepth)\s+(\w+)\s+(\w+)", re.M)

# An instruction: the kind of its operands, floats, ints or uints, and the GLSL with a, b and c.
PLAIN = {
    "mov": ("f", "a"),
    "add": ("f", "a + b"),
    "mul": ("f", "a * b"),
    "mad": ("f", "a * b + c"),
    "div": ("f", "a / b"),
    "max": ("f", "max(a, b)"),
    "min": ("f", "min(a, b)"),
    "rsq": ("f", "inversesqrt(a)"),
    "sqrt": ("f", "sqrt(a)"),
    "rcp": ("f", "1.0 / a"),
    "exp": ("f", "exp2(a)"),
    "log": ("f", "log2(a)"),
    "frc": ("f", "fract(a)"),
    "round_ne": ("f", "roundEven(a)"),
    "round_ni": ("f", "floor(a)"),
    "round_pi": ("f", "ceil(a)"),
    "round_z": ("f", "trunc(a)"),
    "dp2": ("f", "vec4(dot(a.xy, b.xy))"),
    "dp3": ("f", "vec4(dot(a.xyz, b.xyz))"),
    "dp4": ("f", "vec4(dot(a, b))"),
    # y grows downwards in Direct3D and upwards in OpenGL.
    "deriv_rtx": ("f", "dFdx(a)"),
    "deriv_rty": ("f", "-dFdy(a)"),
    "deriv_rtx_coarse": ("f", "dFdxCoarse(a)"),
    "deriv_rty_coarse": ("f", "-dFdyCoarse(a)"),
    "deriv_rtx_fine": ("f", "dFdxFine(a)"),
    "deriv_rty_fine": ("f", "-dFdyFine(a)"),
    "iadd": ("i", "a + b"),
    "imad": ("i", "a * b + c"),
    "imax": ("i", "max(a, b)"),
    "imin": ("i", "min(a, b)"),
    "ineg": ("i", "-a"),
    "ishl": ("i", "a << (b & 31)"),
    "ishr": ("i", "a >> (b & 31)"),
    "ushr": ("u", "a >> (b & 31u)"),
    "umax": ("u", "max(a, b)"),
    "umin": ("u", "min(a, b)"),
    "and": ("u", "a & b"),
    "or": ("u", "a | b"),
    "xor": ("u", "a ^ b"),
    "not": ("u", "~a"),
}
COMPARISONS = {
    "lt": ("f", "lessThan"),
    "ge": ("f", "greaterThanEqual"),
    "eq": ("f", "equal"),
    "ne": ("f", "notEqual"),
    "ilt": ("i", "lessThan"),
    "ige": ("i", "greaterThanEqual"),
    "ieq": ("i", "equal"),
    "ine": ("i", "notEqual"),
    "ult": ("u", "lessThan"),
    "uge": ("u", "greaterThanEqual"),
}
CONVERSIONS = {  # the operand's kind, and the bits of the result; clamped as Direct3D's
    "itof": ("i", "floatBitsToUint(vec4(a))"),
    "utof": ("u", "floatBitsToUint(vec4(a))"),
    "ftoi": ("f", "uvec4(to_int(a))"),
    "ftou": ("f", "to_uint(a)"),
}
KINDS = {"f": "uintBitsToFloat({})", "i": "ivec4({})", "u": "{}"}
BITS = {"f": "floatBitsToUint({})", "i": "uvec4({})", "u": "{}"}
FLOW = {
    "else": "} else {",
    "endif": "}",
    "loop": "while (true) {",
    "endloop": "}",
    "break": "break;",
    "continue": "continue;",
    "default": "default:",
    "endswitch": "}",
    "ret": "return;",
}
HELPERS = """
ivec4 to_int(vec4 v) { return ivec4(clamp(v, -2147483648.0, 2147483520.0)); }
uvec4 to_uint(vec4 v) { return uvec4(clamp(v, 0.0, 4294967040.0)); }
uvec4 all_bits(bvec4 v) { return uvec4(-ivec4(v)); }
"""


def split(text):
    """The operands of an instruction: commas in parentheses and brackets do not count."""
    parts, depth = [""], 0
    for c in text:
        depth += (c in "([") - (c in ")]")
        if c == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += c
    return [part.strip() for part in parts if part.strip()]


def literal(number):
    """The bits of a number of a listing: with a point it is a float."""
    if re.search(r"[.]|nan|inf", number, re.I) and not number.startswith("0x"):
        return f"floatBitsToUint({number})"
    return f"{int(number, 0) & 0xFFFFFFFF}u"


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
        value, swizzle = match[1], match[2] or COMPONENTS
        if not re.match(r"(r\d+|v\d+|icb\[|cb\d+\[|x\d+\[|o\d+)", value):
            raise NotRun(f"operand {text}")
        place = re.fullmatch(r"(\w+)\[(.*)\]", value)
        if place:
            index = re.sub(r"\b([rv]\d+)\.([xyzw])", r"int(\1.\2)", place[2])
            value = f"{place[1]}[{index}]"
            if place[1].startswith("cb"):
                value = f"floatBitsToUint({value})"
        value += "." + (swizzle * 4 if len(swizzle) == 1 else swizzle.ljust(4, swizzle[-1]))
    value = KINDS[kind].format(value)
    if absolute:
        value = f"abs({value})"
    return f"(-{value})" if sign else f"({value})"


def target(text, value):
    """The statement that writes the bits `value`, a vector of four, to the operand."""
    if text in ("null", "oDepth"):
        return ""  # the depth is not compared
    match = re.fullmatch(r"(r\d+|o\d+|x\d+\[.*\])(?:\.([xyzw]+))?", text)
    if not match:
        raise NotRun(f"target {text}")
    place = re.sub(r"\b(r\d+)\.([xyzw])(?=[^\[]*\])", r"int(\1.\2)", match[1])
    mask = match[2] or COMPONENTS
    return f"{place}.{mask} = ({value}).{mask};"


class Translator:
    def __init__(self, textures):
        self.textures = textures  # by (t, s): the GLSL type and name
        self.temporaries = 0

    def texture(self, texture, sampler=None):
        t = int(re.match(r"t(\d+)", texture)[1])
        s = int(re.match(r"s(\d+)", sampler)[1]) if sampler else None
        for (number, other), (kind, name) in self.textures.items():
            if number == t and (s is None or other == s):
                if kind != "sampler2D":
                    raise NotRun(f"a texture of type {kind}")
                return name
        raise NotRun(f"clipc has no texture {texture} with {sampler}")

    def sampled(self, op, parts, offset):
        """The value of an instruction that reads a texture."""
        suffix, last = ("Offset", f", ivec2({offset[1]}, {offset[2]})") if offset else ("", "")
        place = source(parts[1], "f") + ".xy"
        swizzle = (re.search(r"\.([xyzw]+)$", parts[2]) or [None, COMPONENTS])[1]
        if op == "ld":
            place = source(parts[1], "i")
            call = f"texelFetch{suffix}({self.texture(parts[2])}, {place}.xy, {place}.w{last})"
        else:
            name = self.texture(parts[2], parts[3])
            more = "".join(", " + source(part, "f") for part in parts[4:])
            if op == "sample":
                call = f"texture{suffix}({name}, {place}{last})"
            elif op == "sample_l":
                call = f"textureLod{suffix}({name}, {place}{more}.x{last})"
            elif op == "sample_b" and not offset:
                call = f"texture({name}, {place}{more}.x)"
            elif op == "sample_d" and not offset:
                x, y = source(parts[4], "f"), source(parts[5], "f")
                call = f"textureGrad({name}, {place}, {x}.xy, {y}.xy)"
            else:
                raise NotRun(op)
        return f"floatBitsToUint({call}.{swizzle})"

    def line(self, text):
        match = re.match(r"(\w+?)(_sat)?((?:\([^)]*\))*)\s+(.*)|(\w+)$", text)
        if not match:
            raise NotRun(text)
        op = match[1] or match[5]
        offset = re.match(r"\(\s*(-?\d+),\s*(-?\d+)", match[3] or "") if "aoffimmi" in op else None
        op = op.replace("_indexable", "").replace("_aoffimmi", "")
        parts = split(match[4] or "")
        if op in FLOW:
            return FLOW[op]
        if op.endswith(("_z", "_nz")) and op != "round_z":
            word, test = op.rsplit("_", 1)
            condition = f"{source(parts[0], 'u')}.x {'==' if test == 'z' else '!='} 0u"
            effects = {
                "if": " {",
                "breakc": " break;",
                "continuec": " continue;",
                "retc": " return;",
                "discard": " discard;",
            }
            if word in effects:
                return f"if ({condition}){effects[word]}"
        if op == "switch":
            return f"switch ({source(parts[0], 'i')}.x) {{"
        if op == "case":
            return f"case int({literal(split(parts[0][2:-1])[0])}):"
        if op == "movc":
            condition = f"notEqual({source(parts[1], 'u')}, uvec4(0u))"
            chosen = [source(part, "f") for part in parts[2:]]
            value = f"mix({chosen[1]}, {chosen[0]}, {condition})"
            return target(parts[0], BITS["f"].format(self.saturate(value, match[2])))
        if op == "sincos":
            angle = source(parts[2], "f")
            self.temporaries += 1
            name = f"angle_{self.temporaries}"
            writes = [
                target(part, f"floatBitsToUint({function}({name}))")
                for part, function in zip(parts, ("sin", "cos"))
            ]
            return f"vec4 {name} = {angle}; " + " ".join(writes)
        if op in ("imul", "umul") and parts[0] == "null":
            return target(parts[1], f"{source(parts[2], 'u')} * {source(parts[3], 'u')}")
        if op == "udiv":
            self.temporaries += 1
            names = [f"{letter}_{self.temporaries}" for letter in "ab"]
            text = "".join(
                f"uvec4 {name} = {source(part, 'u')}; " for name, part in zip(names, parts[2:])
            )
            return text + " ".join(
                target(part, f"uvec4({names[0]}) {sign} max({names[1]}, 1u)")
                for part, sign in zip(parts, "/%")
            )
        if op in COMPARISONS:
            kind, function = COMPARISONS[op]
            operands = ", ".join(source(part, kind) for part in parts[1:])
            return target(parts[0], f"all_bits({function}({operands}))")
        if op in CONVERSIONS:
            kind, value = CONVERSIONS[op]
            return target(parts[0], re.sub(r"\ba\b", lambda _: source(parts[1], kind), value))
        if op.startswith("resinfo"):
            name = self.texture(parts[2])
            level = source(parts[1], "i")
            size = f"vec4(textureSize({name}, {level}.x), 0, textureQueryLevels({name}))"
            number = f"uvec4({size})" if op.endswith("uint") else f"floatBitsToUint({size})"
            swizzle = (re.search(r"\.([xyzw]+)$", parts[2]) or [None, COMPONENTS])[1]
            return target(parts[0], f"{number}.{swizzle}")
        if op.startswith("sample") or op == "ld":
            return target(parts[0], self.sampled(op, parts, offset))
        if op in PLAIN:
            kind, value = PLAIN[op]
            operands = {letter: source(part, kind) for letter, part in zip("abc", parts[1:])}
            value = re.sub(r"\b[abc]\b", lambda letter: operands[letter[0]], value)
            return target(parts[0], BITS[kind].format(self.saturate(value, match[2])))
        raise NotRun(f"instruction {op}")

    @staticmethod
    def saturate(value, is_clamped):
        return f"clamp({value}, 0.0, 1.0)" if is_clamped else value


def signature(listing, title):
    start = listing.find(title)
    end = listing.find("//\n//\n", start)
    rows = SIGNATURE.findall(listing[start : end if end > 0 else None])
    return [row for row in rows if row[0] != "Name"]


def targets_of(listing):
    """The numbers of the render targets."""
    outputs = [row for row in signature(listing, "Output signature") if "DEPTH" not in row[4]]
    if not outputs or any(row[0].lower() != "sv_target" for row in outputs):
        raise NotRun("outputs that are not render targets")
    return [int(row[3]) for row in outputs]


def with_one_target(glsl, number):
    """The shader with this render target alone, at location 0; the others are variables."""

    def written(out):
        place = "layout(location = 0) out " if int(out[1]) == number else ""
        return f"{place}{out[2]} {out[3]};"

    return OUTPUTS.sub(written, glsl)


def translate(listing, glsl, number):
    """A fragment shader of the listing that writes one target, with the names of clipc's GLSL."""
    out = OUTPUT.search(glsl)
    if not out:
        raise NotRun("clipc writes no render target at location 0")
    code = re.search(r"^(ps_[45]_\d)\n(.*?)^// Approx", listing, re.M | re.S)
    if not code:
        raise NotRun("not a listing of ps_4_0 to ps_5_0")
    textures = {
        (int(t), int(s) if s else None): (kind, name) for kind, name, t, s in TEXTURE.findall(glsl)
    }
    blocks = {int(number): name for name, number in BLOCK.findall(glsl)}
    inputs = {(row[4].lower(), int(row[5])): row for row in INPUT.findall(glsl)}
    text = ["#version 450", "layout(origin_upper_left) in vec4 gl_FragCoord;"]
    begin = []
    for location, words, kind, name, _, _ in INPUT.findall(glsl):
        text.append(f"layout(location = {location}) {words}in {kind} {name};")
    registers = {}
    for name, index, mask, register, system, _ in signature(listing, "Input signature"):
        registers.setdefault(register, [])
        row = inputs.get((name.lower(), int(index)))
        if system == "POS":
            value = "vec4(gl_FragCoord.xyz, 1.0 / gl_FragCoord.w)"
        elif system != "NONE":
            raise NotRun(f"the input {system}")
        elif row:
            size = re.search(r"\d$", row[2])
            zeros = ", 0" * (4 - (int(size[0]) if size else 1))
            family = {"i": "ivec4", "u": "uvec4"}.get(row[2][0], "vec4")
            value = f"{family}({row[3]}{zeros})"
        else:
            continue  # not read
        bits = "floatBitsToUint(%s)" if value.startswith("vec") else "uvec4(%s)"
        begin.append(f"v{register}.{mask} = ({bits % value}).{COMPONENTS[: len(mask)]};")
    text += [f"uvec4 v{register};" for register in registers]
    text += [f"uvec4 o{each};" for each in targets_of(listing)]
    text.append(f"layout(location = 0) out {out[1]} {out[2]};")
    text += [f"uniform {kind} {name};" for kind, name in textures.values()]
    body = []
    translator = Translator(textures)
    lines = re.sub(
        r"dcl_immediateConstantBuffer.*?\}\s*\}",
        lambda buffer: buffer[0].replace("\n", " "),
        code[2],
        flags=re.S,
    )
    for line in lines.splitlines():
        line = line.split("//")[0].strip()
        if not line:
            continue
        if line.startswith("dcl_immediateConstantBuffer"):
            rows = re.findall(r"\{([^{}]*)\}", line)
            values = ", ".join(
                f"uvec4({', '.join(literal(part) for part in split(row))})" for row in rows
            )
            text.append(f"const uvec4 icb[] = uvec4[]({values});")
        elif match := re.match(r"dcl_constantbuffer (?i:cb)(\d+)\[(\d+)\]", line):
            name = blocks.get(int(match[1]))
            if name is None:
                raise NotRun(f"clipc has no buffer b{match[1]}")
            text.append(f"layout(std140) uniform {name} {{ vec4 cb{match[1]}[{match[2]}]; }};")
        elif match := re.match(r"dcl_temps (\d+)", line):
            text += [f"uvec4 r{i};" for i in range(int(match[1]))]
        elif match := re.match(r"dcl_indexableTemp (x\d+)\[(\d+)\]", line):
            text.append(f"uvec4 {match[1]}[{match[2]}];")
        elif not line.startswith("dcl_"):
            body.append(translator.line(line))
    text.append(HELPERS)
    text += ["void run() {", *body, "}", "void main() {", *begin, "run();"]
    size = re.search(r"\d$", out[1])
    part = "x" if not size else COMPONENTS[: int(size[0])]
    text += [f"{out[2]} = {KINDS[kind_of(out[1])].format(f'o{number}')}.{part};", "}"]
    return "\n".join(text) + "\n"


def kind_of(type_name):
    """`f`, `i` or `u` of a GLSL type."""
    return type_name[0] if type_name[0] in "iu" else "f"


def drawn_as_floats(glsl):
    """The shader with floats in the place of an integer render target, as the picture has them."""
    out = OUTPUT.search(glsl)
    if not out or kind_of(out[1]) == "f":
        return glsl
    size = re.search(r"\d$", out[1])
    zeros = ", 0" * (4 - (int(size[0]) if size else 1))
    glsl = glsl.replace(out[0], f"{out[1]} {out[2]};\nlayout(location = 0) out vec4 drawn;")
    glsl = glsl.replace("void main() {", "void main_of_shader() {")
    # Numbers beyond 2^24 would be near each other as floats.
    number = f"{out[1]}({out[2]}) & 0xffff" + ("u" if out[1][0] == "u" else "")
    return glsl + f"void main() {{ main_of_shader(); drawn = vec4({number}{zeros}); }}\n"


def vertex_shader(glsl):
    """Passes the inputs on that the fragment shader declares; location 0 is the position."""
    text = ["#version 450", "layout(location = 0) in vec4 position;"]
    body = ["gl_Position = position;"]
    for location, words, kind, name, _, _ in INPUT.findall(glsl):
        text.append(f"layout(location = {int(location) + 1}) in {kind} given_{name};")
        text.append(f"layout(location = {location}) {words}out {kind} {name};")
        body.append(f"{name} = given_{name};")
    return "\n".join([*text, "void main() {", *body, "}"]) + "\n"


def run(arguments, row, folder):
    listing, hlsl, entry, *options = row
    text = pathlib.Path(listing).read_text(errors="replace").replace("\r", "")
    profile = re.search(r"^(ps_\d_\d)", text, re.M)
    if not profile:
        raise NotRun("no pixel shader")
    command = [arguments.clipc, hlsl, "-T", profile[1], "-E", entry, "-w", "-o", "-", *options]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    if done.returncode:
        raise NotRun("clipc: " + done.stderr.split("\n")[0])
    differences = [compare(arguments, text, done.stdout, k, folder) for k in targets_of(text)]
    return next((f"target {k}: {what}" for k, what in enumerate(differences) if what), "")


def compare(arguments, listing, glsl, number, folder):
    """What differs in the render target, or nothing."""
    glsl = with_one_target(glsl, number)
    shaders = {
        "a.vert": vertex_shader(glsl),
        "a.frag": drawn_as_floats(glsl),
        "b.frag": drawn_as_floats(translate(listing, glsl, number)),
    }
    for name, shader in shaders.items():
        (folder / name).write_text(shader)
    paths = [folder / name for name in ("a.vert", "a.frag", "a.vert", "b.frag")]
    done = subprocess.run(
        [arguments.draw, "pair", *paths], capture_output=True, text=True, timeout=60
    )
    if done.returncode not in (0, 1):
        raise NotRun("draw: " + " ".join(done.stderr.split("\n")[:3]))
    # The exit code asks for more colors than a small shader has.
    counts = re.search(r"in (\d+) colors, (\d+) different", done.stdout + done.stderr)
    if not counts:
        raise NotRun("draw: " + (done.stdout + done.stderr).strip().split("\n")[0])
    if int(counts[2]) == 0 and int(counts[1]) < 2:
        raise NotRun("one color, which shows nothing")
    return counts[0] if int(counts[2]) else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("clipc")
    parser.add_argument("draw", help="clipc-draw")
    parser.add_argument("list")
    arguments = parser.parse_args()
    counts = {"equal": 0, "different": 0, "not run": 0}
    with tempfile.TemporaryDirectory() as folder:
        for line in pathlib.Path(arguments.list).read_text().splitlines():
            row = line.split("\t")
            if len(row) < 3:
                continue
            try:
                difference = run(arguments, row, pathlib.Path(folder))
                word = "different" if difference else "equal"
            except (NotRun, subprocess.TimeoutExpired) as error:
                word, difference = "not run", str(error)
            counts[word] += 1
            if word != "equal":
                print(f"{row[0]} {row[2]}: {word}: {difference}")
    print(", ".join(f"{count} {word}" for word, count in counts.items()))
    return 1 if counts["different"] else 0


if __name__ == "__main__":
    sys.exit(main())
