// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

// The types of the tables that `clipc --table x.h` writes. Each such header brings this same text
// (a test compares), so it compiles alone; whoever comes first defines the types.
// clang-format off
#ifndef CLIPC_STATIC_CLIP_TABLE
#define CLIPC_STATIC_CLIP_TABLE 1
namespace clipc {
struct StaticClipPlane {
  unsigned index;            // of the operand
  const char* text;          // the operand as written
  bool in_register;          // false: the plane is composed of several constants; the rest is empty
  const char* cbuffer;       // as written
  unsigned cbuffer_element;  // which buffer of an array of ConstantBuffers
  unsigned register_number;  // n of b<n>
  unsigned register_space;
  unsigned float4_register;  // m of cb<n>[m]
  unsigned byte_offset;      // in the buffer
  const char* glsl_block;    // empty: a plain uniform
  const char* glsl_member;   // empty: the shader does not read it
};
struct StaticClipTable {
  const char* entry;
  const char* profile;
  const char* lowering;        // "clip-distance", "level9", "none", "near-plane" or "discard"
  const char* position_space;  // "direct3d-clip", "xyw1" or "object"
  unsigned enable_mask;
  unsigned plane_count;
  StaticClipPlane planes[6];
};
}  // namespace clipc
#elif CLIPC_STATIC_CLIP_TABLE != 1
#error "clip tables of two versions of clipc in one program: write them again with one clipc"
#endif
// clang-format on
