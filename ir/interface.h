// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/span.h"
#include "ir/ids.h"
#include "ir/type.h"

// What a shader shares with the application and the next stage: constant buffers, objects, inputs,
// outputs and clip planes.
namespace clipc::ir {

// register(b3, space1): letter b, number 3, space 1.
struct Register {
  char letter = 'b';
  std::uint32_t number = 0;
  std::uint32_t space = 0;
  bool is_explicit = false;  // written in the source; clipc chose the number otherwise
};

struct CbufferMember {
  VarId var;
  std::uint32_t offset = 0;  // bytes from the start of the buffer, HLSL packing
  std::uint32_t size = 0;    // bytes
  // The offset is written in the source: packoffset(c1.y), or register(c1) in $Globals.
  bool has_packoffset = false;
};
enum class CbufferKind : std::uint8_t {
  kCbuffer,
  kTbuffer,
  kGlobals,  // "$Globals": the uniforms outside any cbuffer
  kParams,   // "$Params": the `uniform` parameters of the entry point
  // ConstantBuffer<T>: one member at offset 0, whose type is T, or T[count] with one buffer for
  // each element
  kConstantBuffer,
};
struct Cbuffer {
  std::string name;
  CbufferKind kind = CbufferKind::kCbuffer;
  Register reg;
  std::vector<CbufferMember> members;
  std::uint32_t size = 0;   // bytes, a multiple of 16 as HLSL binds it
  std::uint32_t count = 1;  // the number of buffers: 4 of ConstantBuffer<T> cb[4]
  Span span;
};

struct Resource {
  VarId var;
  Register reg;  // its letter is t, s or u
};

// What an input or output means to the pipeline.
enum class Builtin : std::uint8_t {
  kNone,

  // Outputs.
  kPosition,      // float4, in Direct3D's clip space until AdjustClipSpace
  kClipVertex,    // float4: gl_ClipVertex
  kClipDistance,  // float[n], n <= 8
  kCullDistance,  // float[n]
  kPointSize,     // float

  // Inputs.
  kVertexId,       // uint, without the base vertex
  kInstanceId,     // uint, without the base instance
  kBaseVertex,     // int: SV_StartVertexLocation
  kBaseInstance,   // uint: SV_StartInstanceLocation
  kDrawIndex,      // uint
  kViewId,         // uint
  kVertexIndex,    // uint, with the base vertex, as Vulkan counts
  kInstanceIndex,  // uint, with the base instance, as Vulkan counts

  // Outputs.
  kShadingRate,    // uint: Direct3D's log2 of the width << 2 | log2 of the height
  kLayer,          // uint
  kViewportIndex,  // uint
};

// One input or output of the shader: a scalar or vector of float, int, uint or double (a bool
// arrives as uint), or the array of kClipDistance or kCullDistance. Structs, arrays and matrices in
// the signature were taken apart, matrices by columns (`row_major` ones by rows).
struct IoVar {
  VarId var;
  std::string semantic;  // as written, without its index: "TEXCOORD"
  std::uint32_t index = 0;
  Builtin builtin = Builtin::kNone;
  // The place among the inputs (outputs) that are not built in, in order of declaration.
  std::uint32_t location = 0;
  Interpolation interpolation = Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
  bool has_index = false;  // the index is written: TEXCOORD0, not TEXCOORD
  std::string name = {};   // of the field, parameter or function that has the semantic: "uv"
};

// The semantic of the outputs that carry distances to clip planes to a fragment shader that
// discards. A shader cannot name it: the names that begin with SV_ are Direct3D's.
inline constexpr std::string_view kClipPlaneDistance = "SV_ClipPlaneDistance";

// An operand of [clipplanes(...)].
struct ClipPlane {
  ExprId value;  // a float4 made of cbuffer members; none after LowerClipPlanes
  Span span;
  std::string text;           // as written: "planes[2]"
  CbufferId cbuffer;          // when whole_register
  std::uint32_t offset = 0;   // bytes in that buffer, a multiple of 16, when whole_register
  std::uint32_t element = 0;  // which buffer of an array of ConstantBuffers
  // The operand is one whole float4 register, its components in order: Direct3D 9 takes nothing
  // else.
  bool whole_register = false;
};

}  // namespace clipc::ir
