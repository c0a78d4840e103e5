# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What the values and states of an effect are for OpenGL, for effect_table.py: docs/effects.md has the table."""

import ast
import re
import struct

GL_FUNC = dict(
    NEVER=0x200,
    LESS=0x201,
    EQUAL=0x202,
    LESSEQUAL=0x203,
    GREATER=0x204,
    NOTEQUAL=0x205,
    GREATEREQUAL=0x206,
    ALWAYS=0x207,
)
GL_FACTOR = dict(
    ZERO=0, ONE=1, SRCCOLOR=0x300, INVSRCCOLOR=0x301, SRCALPHA=0x302, INVSRCALPHA=0x303, DESTALPHA=0x304, INVDESTALPHA=0x305,
    DESTCOLOR=0x306, INVDESTCOLOR=0x307, SRCALPHASAT=0x308, BLENDFACTOR=0x8001, INVBLENDFACTOR=0x8002,
    SRC1COLOR=0x88F9, INVSRC1COLOR=0x88FA, SRC1ALPHA=0x8589, INVSRC1ALPHA=0x88FB,
)  # fmt: skip
GL_EQUATION = dict(ADD=0x8006, MIN=0x8007, MAX=0x8008, SUBTRACT=0x800A, REVSUBTRACT=0x800B)
GL_STENCIL = dict(
    KEEP=0x1E00,
    ZERO=0,
    REPLACE=0x1E01,
    INCRSAT=0x1E02,
    DECRSAT=0x1E03,
    INVERT=0x150A,
    INCR=0x8507,
    DECR=0x8508,
)
GL_FILL = dict(POINT=0x1B00, WIREFRAME=0x1B01, SOLID=0x1B02)
GL_WRAP = dict(WRAP=0x2901, MIRROR=0x8370, CLAMP=0x812F, BORDER=0x812D, MIRRORONCE=0x8743)
GL_TARGET = {"1D": 0x0DE0, "2D": 0x0DE1, "3D": 0x806F, "CUBE": 0x8513, "1DARRAY": 0x8C18, "2DARRAY": 0x8C1A, "CUBEARRAY": 0x9009,
             "2DMS": 0x9100, "2DMSARRAY": 0x9102}  # fmt: skip
FRONT, BACK, CW, CCW = 0x404, 0x405, 0x900, 0x901
BOOL = dict(TRUE=1, FALSE=0)
CHANNELS = dict(RED=1, GREEN=2, BLUE=4, ALPHA=8)

# The enumerators of clipc_gl_state, in their order.
STATES = """DEPTH_TEST DEPTH_WRITE DEPTH_FUNC CULL_FACE FRONT_FACE POLYGON_MODE DEPTH_BIAS SLOPE_DEPTH_BIAS DEPTH_CLAMP SCISSOR_TEST
MULTISAMPLE ALPHA_TO_COVERAGE SAMPLE_MASK SRGB_WRITE CLIP_PLANES BLEND BLEND_SEPARATE_ALPHA BLEND_SOURCE BLEND_TARGET BLEND_EQUATION
BLEND_SOURCE_ALPHA BLEND_TARGET_ALPHA BLEND_EQUATION_ALPHA BLEND_RED BLEND_GREEN BLEND_BLUE BLEND_ALPHA COLOR_MASK_0 COLOR_MASK_1
COLOR_MASK_2 COLOR_MASK_3 STENCIL_TEST STENCIL_TWO_SIDED STENCIL_REFERENCE STENCIL_READ_MASK STENCIL_WRITE_MASK STENCIL_FUNC
STENCIL_FAIL STENCIL_DEPTH_FAIL STENCIL_PASS STENCIL_BACK_FUNC STENCIL_BACK_FAIL STENCIL_BACK_DEPTH_FAIL STENCIL_BACK_PASS""".split()


def float_bits(value):
    return struct.unpack("<I", struct.pack("<f", value))[0]


def signed_bits(value):
    return struct.unpack("<I", struct.pack("<i", value))[0]


class Unknown(Exception):
    """A value that is not a constant of the kind that is wanted."""


def number(text):
    """The value of an expression of literals, which has at most + - * / and brackets."""
    text = re.sub(
        r"\b0x[0-9a-fA-F]+", lambda hexadecimal: str(int(hexadecimal[0], 16)), text.strip()
    )
    text = re.sub(r"(?<=[0-9.])[uUlLhHfF]+\b", "", text)
    if text.upper() in BOOL:
        return BOOL[text.upper()]
    if not re.fullmatch(r"[0-9a-fA-FxXeE.+\-*/() ]+", text):
        raise Unknown(text)

    def value(node):
        if isinstance(node, ast.Constant):
            return node.value
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.USub, ast.UAdd)):
            return -value(node.operand) if isinstance(node.op, ast.USub) else value(node.operand)
        if isinstance(node, ast.BinOp):
            left, right = value(node.left), value(node.right)
            if isinstance(node.op, ast.Div) and right:
                return (
                    int(left / right)
                    if isinstance(left, int) and isinstance(right, int)
                    else left / right
                )
            for kind, result in (
                (ast.Add, left + right),
                (ast.Sub, left - right),
                (ast.Mult, left * right),
            ):
                if isinstance(node.op, kind):
                    return result
        raise Unknown(text)

    try:
        return value(ast.parse(text, mode="eval").body)
    except (SyntaxError, ValueError, RecursionError, OverflowError) as error:
        raise Unknown(text) from error


def word(text, words):
    """The value of a word: `D3DBLEND_SRC_ALPHA`, `Src_Alpha` and `SRCALPHA` are one; or a number that the effect gives."""
    plain = re.sub(
        r"[()_\s]|^D3D(BLENDOP|BLEND|CMP|STENCILOP|FILL|CULL|TADDRESS|TEXF)_|^D3D1[01]_\w+?_(?=[A-Z])",
        "",
        text.strip().upper(),
    )
    if plain in words:
        return words[plain]
    raise Unknown(text)


def flag(text):
    return int(number(text) != 0)


def mask(text):
    """`RED | GREEN`, `0x7`, `ALL`."""
    total = 0
    for part in text.strip().strip("()").split("|"):
        part = part.strip()
        name = re.sub(r"^D3DCOLORWRITEENABLE_", "", part.upper())
        total |= 15 if name == "ALL" else CHANNELS[name] if name in CHANNELS else int(number(part))
    return total


def plane_mask(text):
    total = 0
    for part in text.split("|"):
        plane = re.fullmatch(r"\s*(?:D3DCLIPPLANE|CLIPPLANE)(\d)\s*", part.upper())
        total |= 1 << int(plane[1]) if plane else int(number(part))
    return total


def split(text):
    """The parts between commas outside brackets."""
    parts, depth, begin = [], 0, 0
    for i, c in enumerate(text):
        depth += (c in "({[") - (c in ")}]")
        if c == "," and depth == 0:
            parts.append(text[begin:i])
            begin = i + 1
    return [part.strip() for part in parts + [text[begin:]] if part.strip()]


def numbers(text):
    """The numbers in `{float4(1, 0, 0, 1), 2}`, one after another."""
    text = text.strip()
    outer = re.fullmatch(r"(?:\w+\s*\(|\{|\()(.*)[)}]", text, re.DOTALL)
    if outer and re.match(
        r"(?:(?:float|half|int|uint|bool|double|vector|matrix)\w*\s*\(|\{)", text
    ):
        found = []
        for part in split(outer[1]):
            found += numbers(part)
        kind = re.match(r"\w*?(\d)(?:x(\d))?\s*\(", text)
        count = int(kind[1]) * int(kind[2] or 1) if kind else 1
        return found * count if len(found) == 1 and kind else found
    return [number(text)]


# ---- states

CULL9 = dict(NONE=0, CW=FRONT, CCW=BACK)
CULL10 = dict(NONE=0, FRONT=FRONT, BACK=BACK)


def depth_bias9(text):
    """Direct3D 9 gives a part of the depth range, OpenGL steps of a buffer of 24 bits."""
    return float_bits(float(number(text)) * 2**24)


def as_float(text):
    return float_bits(float(number(text)))


def unsigned(text):
    return int(number(text)) & 0xFFFFFFFF


def of(words):
    return lambda text: word(text, words)


# Name of the state -> (OpenGL's state, the value from the text).
DIRECT3D9 = {
    "ZENABLE": ("DEPTH_TEST", flag), "ZWRITEENABLE": ("DEPTH_WRITE", flag), "ZFUNC": ("DEPTH_FUNC", of(GL_FUNC)),
    "CULLMODE": ("CULL_FACE", of(CULL9)), "FILLMODE": ("POLYGON_MODE", of(GL_FILL)),
    "DEPTHBIAS": ("DEPTH_BIAS", depth_bias9), "SLOPESCALEDEPTHBIAS": ("SLOPE_DEPTH_BIAS", as_float),
    "SCISSORTESTENABLE": ("SCISSOR_TEST", flag), "MULTISAMPLEANTIALIAS": ("MULTISAMPLE", flag),
    "MULTISAMPLEMASK": ("SAMPLE_MASK", unsigned), "SRGBWRITEENABLE": ("SRGB_WRITE", flag),
    "CLIPPLANEENABLE": ("CLIP_PLANES", plane_mask),
    "ALPHABLENDENABLE": ("BLEND", flag), "SEPARATEALPHABLENDENABLE": ("BLEND_SEPARATE_ALPHA", flag),
    "SRCBLEND": ("BLEND_SOURCE", of(GL_FACTOR)), "DESTBLEND": ("BLEND_TARGET", of(GL_FACTOR)),
    "BLENDOP": ("BLEND_EQUATION", of(GL_EQUATION)), "SRCBLENDALPHA": ("BLEND_SOURCE_ALPHA", of(GL_FACTOR)),
    "DESTBLENDALPHA": ("BLEND_TARGET_ALPHA", of(GL_FACTOR)), "BLENDOPALPHA": ("BLEND_EQUATION_ALPHA", of(GL_EQUATION)),
    "COLORWRITEENABLE": ("COLOR_MASK_0", mask), "COLORWRITEENABLE1": ("COLOR_MASK_1", mask),
    "COLORWRITEENABLE2": ("COLOR_MASK_2", mask), "COLORWRITEENABLE3": ("COLOR_MASK_3", mask),
    "STENCILENABLE": ("STENCIL_TEST", flag), "TWOSIDEDSTENCILMODE": ("STENCIL_TWO_SIDED", flag),
    "STENCILREF": ("STENCIL_REFERENCE", unsigned), "STENCILMASK": ("STENCIL_READ_MASK", unsigned),
    "STENCILWRITEMASK": ("STENCIL_WRITE_MASK", unsigned), "STENCILFUNC": ("STENCIL_FUNC", of(GL_FUNC)),
    "STENCILFAIL": ("STENCIL_FAIL", of(GL_STENCIL)), "STENCILZFAIL": ("STENCIL_DEPTH_FAIL", of(GL_STENCIL)),
    "STENCILPASS": ("STENCIL_PASS", of(GL_STENCIL)), "CCWSTENCILFUNC": ("STENCIL_BACK_FUNC", of(GL_FUNC)),
    "CCWSTENCILFAIL": ("STENCIL_BACK_FAIL", of(GL_STENCIL)), "CCWSTENCILZFAIL": ("STENCIL_BACK_DEPTH_FAIL", of(GL_STENCIL)),
    "CCWSTENCILPASS": ("STENCIL_BACK_PASS", of(GL_STENCIL)),
}  # fmt: skip
# The states of Direct3D 10's and 11's objects; a state object gives all states of its kind.
BLEND = {
    "ALPHATOCOVERAGEENABLE": ("ALPHA_TO_COVERAGE", flag), "BLENDENABLE": ("BLEND", flag),
    "SRCBLEND": ("BLEND_SOURCE", of(GL_FACTOR)), "DESTBLEND": ("BLEND_TARGET", of(GL_FACTOR)),
    "BLENDOP": ("BLEND_EQUATION", of(GL_EQUATION)), "SRCBLENDALPHA": ("BLEND_SOURCE_ALPHA", of(GL_FACTOR)),
    "DESTBLENDALPHA": ("BLEND_TARGET_ALPHA", of(GL_FACTOR)), "BLENDOPALPHA": ("BLEND_EQUATION_ALPHA", of(GL_EQUATION)),
    "RENDERTARGETWRITEMASK": ("COLOR_MASK_0", mask), "RENDERTARGETWRITEMASK1": ("COLOR_MASK_1", mask),
    "RENDERTARGETWRITEMASK2": ("COLOR_MASK_2", mask), "RENDERTARGETWRITEMASK3": ("COLOR_MASK_3", mask),
}  # fmt: skip
DEPTH_STENCIL = {
    "DEPTHENABLE": ("DEPTH_TEST", flag), "DEPTHWRITEMASK": ("DEPTH_WRITE", lambda t: word(t, dict(ZERO=0, ALL=1)) if not t.strip("()").isdigit() else flag(t)),
    "DEPTHFUNC": ("DEPTH_FUNC", of(GL_FUNC)), "STENCILENABLE": ("STENCIL_TEST", flag),
    "STENCILREADMASK": ("STENCIL_READ_MASK", unsigned), "STENCILWRITEMASK": ("STENCIL_WRITE_MASK", unsigned),
    "FRONTFACESTENCILFUNC": ("STENCIL_FUNC", of(GL_FUNC)), "FRONTFACESTENCILFAIL": ("STENCIL_FAIL", of(GL_STENCIL)),
    "FRONTFACESTENCILDEPTHFAIL": ("STENCIL_DEPTH_FAIL", of(GL_STENCIL)), "FRONTFACESTENCILPASS": ("STENCIL_PASS", of(GL_STENCIL)),
    "BACKFACESTENCILFUNC": ("STENCIL_BACK_FUNC", of(GL_FUNC)), "BACKFACESTENCILFAIL": ("STENCIL_BACK_FAIL", of(GL_STENCIL)),
    "BACKFACESTENCILDEPTHFAIL": ("STENCIL_BACK_DEPTH_FAIL", of(GL_STENCIL)), "BACKFACESTENCILPASS": ("STENCIL_BACK_PASS", of(GL_STENCIL)),
}  # fmt: skip
RASTERIZER = {
    "FILLMODE": ("POLYGON_MODE", of(GL_FILL)), "CULLMODE": ("CULL_FACE", of(CULL10)),
    "FRONTCOUNTERCLOCKWISE": ("FRONT_FACE", lambda t: CCW if flag(t) else CW),
    "DEPTHBIAS": ("DEPTH_BIAS", as_float), "SLOPESCALEDDEPTHBIAS": ("SLOPE_DEPTH_BIAS", as_float),
    "DEPTHCLIPENABLE": ("DEPTH_CLAMP", lambda t: 1 - flag(t)), "SCISSORENABLE": ("SCISSOR_TEST", flag),
    "MULTISAMPLEENABLE": ("MULTISAMPLE", flag),
}  # fmt: skip
OBJECTS = {
    "SETBLENDSTATE": BLEND,
    "SETDEPTHSTENCILSTATE": DEPTH_STENCIL,
    "SETRASTERIZERSTATE": RASTERIZER,
}
# Where Direct3D 10's default is another one than that of Direct3D 9.
OBJECT_DEFAULTS = {
    "SETBLENDSTATE": {"BLEND_SEPARATE_ALPHA": 1}, "SETRASTERIZERSTATE": {"MULTISAMPLE": 0},
    "SETDEPTHSTENCILSTATE": {"DEPTH_FUNC": 0x201, "STENCIL_TWO_SIDED": 1, "STENCIL_READ_MASK": 255, "STENCIL_WRITE_MASK": 255},
}  # fmt: skip
