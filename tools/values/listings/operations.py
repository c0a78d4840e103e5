# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What each instruction of ps_4_0 to ps_5_1 computes: the kind of its operands, floats, ints or uints, and GLSL with a, b and c."""

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
    "umad": ("u", "a * b + c"),
    "umax": ("u", "max(a, b)"),
    "umin": ("u", "min(a, b)"),
    "and": ("u", "a & b"),
    "or": ("u", "a | b"),
    "xor": ("u", "a ^ b"),
    "not": ("u", "~a"),
    "bfrev": ("u", "bitfieldReverse(a)"),
    "countbits": ("u", "uvec4(bitCount(a))"),
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
INTO_TWO = {  # an instruction with two results
    "sincos": ("f", ("sin(a)", "cos(a)")),
    # The high half of a product is not read where its target is null.
    "imul": ("i", ("high_half(a, b)", "a * b")),
    "umul": ("u", ("high_half(a, b)", "a * b")),
    # A division by 0 gives all bits.
    "udiv": (
        "u",
        (
            "a / max(b, 1u) | uvec4(equal(b, uvec4(0u))) * ~0u",
            "a % max(b, 1u) | uvec4(equal(b, uvec4(0u))) * ~0u",
        ),
    ),
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
    "nop": "",
}
HELPERS = """
ivec4 to_int(vec4 v) { return ivec4(clamp(v, -2147483648.0, 2147483520.0)); }
uvec4 to_uint(vec4 v) { return uvec4(clamp(v, 0.0, 4294967040.0)); }
uvec4 all_bits(bvec4 v) { return uvec4(-ivec4(v)); }
ivec4 high_half(ivec4 a, ivec4 b) { ivec4 high, low; imulExtended(a, b, high, low); return high; }
uvec4 high_half(uvec4 a, uvec4 b) { uvec4 high, low; umulExtended(a, b, high, low); return high; }
uvec4 reciprocal_sizes(uvec4 size) {
  return floatBitsToUint(vec4(1.0 / vec3(size.xyz), float(size.w)));
}
"""
