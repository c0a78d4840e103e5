# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes shaders that are hard on a preprocessor into the folder named."""

import pathlib
import sys

folder = pathlib.Path(sys.argv[1])


def doubling(first):
    """M59 is 2^59 times what M0 is."""
    return f"#define M0 {first}\n" + "".join(
        f"#define M{i} M{i - 1} M{i - 1}\n" for i in range(1, 60)
    )


files = {
    "parens": "#if " + "(" * 1_000_000 + "1\n#endif\n",
    "nots": "#if " + "!" * 1_000_000 + "1\n#endif\n",
    "macro_parens": doubling("(((((") + "#if M59\n#endif\n",
    "arguments": "#define F(x) x\nint a = " + "F(" * 100_000 + "1" + ")" * 100_000 + ";\n",
    "doubling_arguments": "#define F(x) x x\nint a = " + "F(" * 60 + "1" + ")" * 60 + ";\n",
    "pasting": "#define F(x) F1(x)\n#define F1(x) x##x\nint " + "F(" * 40 + "a" + ")" * 40 + ";\n",
    "doubling": doubling("a a a") + "M59\n",
    "doubling_nothing": "#define Z\n" + doubling("Z") + "M59\n",
}
for name, text in files.items():
    (folder / f"{name}.hlsl").write_text(text)
