// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

namespace clipc::draw {

inline constexpr char kUsage[] =
    R"(clipc-draw capture SHADER.vert --attribute NAME=1,2,3,4/5,6,7,8 ... [options]
  Runs a GLSL vertex shader on Mesa's software OpenGL and prints its outputs for each vertex.
    --output NAME           an output to print; may be repeated. Default: gl_Position, and
                            gl_ClipDistance when the shader writes it

clipc-draw pixels SHADER.vert [options]
  Draws a mesh that covers the target: the attribute in_POSITION0 gets x, y in [-1, 1], depth rising
  from 1/4 on the left to 3/4 on the right, and w from 1 to 2. Fails unless exactly the expected
  pixels are drawn, with Direct3D's depth.
    --enable MASK           the enabled clip distances
    --clip-plane I=1,0,0,0  glClipPlane
    --zero-to-one           glClipControl
    --fragment FILE         a fragment shader that draws red, and depth as green
    --expect-plane 1,0,0,0  pixels are drawn where 1x + 0y + 0z + 0w >= 0. Repeated: where this
                            holds for all planes
    --expect-flipped        the image is upside down
    --expect-any-depth      the depth is not compared
    --png FILE              writes the image, to look at

For both commands: --block NAME@OFFSET=1,2,3,4
Numbers: 1.5 float, 3i int, 3u uint, 0x7fc00000 bits; `identity` is a 4x4 matrix.

clipc-draw pair A.vert A.frag B.vert B.frag
  Draws with both programs: the same vertices, by location; the same bytes in uniform blocks and the
  same texels in textures of one name. Fails unless the images are equal and show something.
  Files in SPIR-V are drawn on Vulkan, where blocks and textures are the same by set and binding. A
  message of Vulkan's validation layers about the first program fails too.

clipc-draw link A.vert A.frag ...
  Links each pair on Mesa's software OpenGL, or OpenGL ES where the shaders are of that. Files in
  SPIR-V become pipelines of Vulkan, and its validation layers say whether the two fit. Names those
  that are refused, with the message.

clipc-draw passes FIRST.vert SECOND.vert
  Draws with the first, and then with the second where its depth is equal. Fails where a pixel of
  the first pass is missing in the second.

clipc-draw image DRAW.json COLORS
  Draws what DRAW.json describes: vertex and fragment shader, width and height, vertices, indices,
  the bits of attributes, blocks, uniforms and textures by name, a mask of clipDistances, clear,
  reversed, float. Writes four floats for each pixel, the bottom row first.

clipc-draw compare SHADER.hlsl [options]
  Compiles the shader and compares the outputs of the GLSL, run by Mesa, with those of the reference
  evaluator, on random vertices and constants: for every target and lowering chosen below, both
  depth ranges, flipped and not. The target vulkan runs on Mesa's software Vulkan, the others on its
  OpenGL. A pixel shader is drawn on a small surface, over which its inputs change exactly, and its
  render targets and depth are compared at each pixel.
    -T PROFILE -E ENTRY -D NAME=VALUE -I FOLDER --row-major   as for clipc
    --target a,b            default glsl450,glsl330,glsl130,essl300,vulkan. `all` takes every target
                            that can express the shader, and lists the others
    --lower a,b             default clip-distance,level9,none
    --plane-space S         clip, xyw1 or object; default clip
    --position-input SEMANTIC   default POSITION0
    --direct3d              only Direct3D's depth range, and not flipped
    --random N              the number of random vertices, default 64. Vertices and instances do not
                            start at 0 where the shader allows that
    --seed S                default 1
    --ints LEAST..GREATEST  the range of random ints, default -4..7
    --quarters              floats are multiples of 1/4 in [-4, 4]
    --perspective           w changes from pixel to pixel, and drivers interpolate with errors
    --ulps U                the error allowed for floats, see tools/draw/compare.h
    --exact                 floats must be equal to the bit
    --verbose               prints a line for each comparison, and the GLSL of those that fail

clipc-draw machine-code SHADER.spv ...
  Prints for each vertex shader the instructions that Vulkan's driver makes of it, and the cycles
  that a multiprocessor needs for one wave. Exits with 77 where no driver tells that. With
  RADV_FORCE_FAMILY in the environment, Mesa plays an AMD processor.

clipc-draw devices
  Prints the names of the software OpenGL and Vulkan that the other commands use.
Exit: 0 as expected, 1 not as expected, 2 cannot draw.
)";

// The commands of clipc-draw: arguments[0] is the command's name. They return the exit code, and
// throw DrawError where they cannot draw.
using Arguments = std::vector<std::string>;
int RunCapture(const Arguments& arguments);
int RunPixels(const Arguments& arguments);
int RunPair(const Arguments& arguments);
int RunLink(const Arguments& arguments);
int RunPasses(const Arguments& arguments);
int RunImage(const Arguments& arguments);
int RunCompare(const Arguments& arguments);
int RunMachineCode(const Arguments& arguments);
int RunDevices();

}  // namespace clipc::draw
