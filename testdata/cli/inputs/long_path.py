# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compiles a shader that lies in a deep folder, named from here and from the root.

usage: long_path.py CLIPC NAME DEPTH      the folder is NAME/NAME/..., DEPTH times
"""

import pathlib
import subprocess
import sys

clipc, name, depth = sys.argv[1:]
folder = pathlib.Path(*[name] * int(depth))
assert len(str(folder)) > 260, folder
(folder / "part.hlsli").write_text("cbuffer C { float4 plane; };\n")
(folder / "long.hlsl").write_text(
    '#include "part.hlsli"\n[clipplanes(plane)] float4 main(float4 p : POSITION) : SV_Position { return p; }\n'
)
for at in (folder, folder.absolute()):
    written = at / "long.vert"
    subprocess.run([clipc, at / "long.hlsl", "-o", written, "--table=.json"], check=True)
    assert "gl_ClipDistance" in written.read_text()
    written.unlink()
