// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace clipc::draw {

inline constexpr char kUsage[] =
    R"(clipc-draw capture SHADER.vert --attribute NAME=1,2,3,4/5,6,7,8 ... [options]
  Runs a GLSL vertex shader on Mesa's software OpenGL and prints its outputs for each vertex.
    --output NAME           an output to print; may be repeated. Default: gl_Position, and
                            gl_ClipDistance when the shader writes it

clipc-draw pixels SHADER.vert [options]
  Draws a mesh that covers the target: the attribute --position gets x, y in [-1, 1], depth rising
  from 1/4 on the left to 3/4 on the right, and w from 1 to 2. Fails unless exactly the expected
  pixels are drawn, with Direct3D's depth.
    --position NAME         the attribute, default in_POSITION0; with three components w is 1
    --constant NAME=1,2     an attribute that is the same for all vertices
    --enable MASK           the enabled clip distances
    --clip-plane I=1,0,0,0  glClipPlane
    --zero-to-one           glClipControl
    --fragment FILE         a fragment shader that draws red, and depth as green
    --expect-plane 1,0,0,0  pixels are drawn where 1x + 0y + 0z + 0w >= 0. Repeated: where this
                            holds for all planes
    --expect-flipped        the picture is upside down
    --expect-any-depth      the depth is not compared
    --size N                pixels in each direction, default 64
    --png FILE              writes the picture, to look at

For both commands: --uniform NAME=1,2,3,4   --block NAME@OFFSET=1,2,3,4
Numbers: 1.5 float, 3i int, 3u uint, 0x7fc00000 bits; `identity` is a 4x4 matrix.

clipc-draw compare SHADER.hlsl [options]
  Compiles the shader and compares the outputs of the GLSL, run by Mesa, with those of the reference
  evaluator, on random vertices and constants: for every target, lowering, depth range and flip
  chosen below. The target vulkan runs on Mesa's software Vulkan, the others on its OpenGL.
    --peer glslang          compares the outputs of the same HLSL compiled by glslang instead. Known
                            bugs of glslang are listed by name (docs/peers.md)
    -T PROFILE -E ENTRY -D NAME=VALUE -I FOLDER --row-major   as for clipc
    --target a,b            default glsl450,glsl330,glsl130,essl300,vulkan. `all` takes every target
                            that can express the shader, and lists the others
    --lower a,b             default clip-distance,level9,none
    --plane-space S         clip, xyw1 or object; default clip
    --position-input SEMANTIC   default POSITION0
    --depth-range R         zero-to-one or negative-one-to-one; default both
    --flip-y yes|no         default both
    --random N              the number of random vertices, default 64. Vertices and instances do not
                            start at 0 where the shader allows that
    --seed S                default 1
    --ints LEAST..GREATEST  the range of random ints, default -4..7
    --ulps U                the error allowed for floats, see tools/draw/compare.h
    --exact                 floats must be equal to the bit
    --verbose               prints a line for each comparison, and the GLSL of those that fail

clipc-draw devices
  Prints the names of the software OpenGL and Vulkan that the other commands use.
Exit: 0 as expected, 1 not as expected, 2 cannot draw.
)";

// argv[0] is the command's name. Return the exit code. Throw DrawError where they cannot draw.
int RunCapture(int argc, char** argv);
int RunPixels(int argc, char** argv);
int RunCompare(int argc, char** argv);
int RunDevices();

}  // namespace clipc::draw
