// Written by clipc; changes are refused when it is read back, and lost when it is written again.
// clip-table level9_clip_table {"schema":"clipc.clip-table","version":1,"entry":"main","profile":"vs_4_0_level_9_1","lowering":"level9","position_space":"direct3d-clip","enable_mask":3,"planes":[{"index":0,"text":"water_plane","constant":{"cbuffer":"ClipPlaneConstantBuffer","cbuffer_element":0,"register":1,"space":0,"float4_register":0,"byte_offset":0,"glsl_block":"","glsl_member":""}},{"index":1,"text":"portal_plane","constant":{"cbuffer":"ClipPlaneConstantBuffer","cbuffer_element":0,"register":1,"space":0,"float4_register":1,"byte_offset":16,"glsl_block":"","glsl_member":""}}]}
#pragma once

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
  const char* lowering;        // "clip-distance", "level9" or "none"
  const char* position_space;  // "direct3d-clip", "xyw1" or "object"
  unsigned enable_mask;
  unsigned plane_count;
  StaticClipPlane planes[6];
};
}  // namespace clipc
#elif CLIPC_STATIC_CLIP_TABLE != 1
#error "clip tables of two versions of clipc in one program: write them again with one clipc"
#endif

inline constexpr clipc::StaticClipTable level9_clip_table = {
    "main", "vs_4_0_level_9_1",
    "level9", "direct3d-clip",
    3u, 2u,
    {
        {0u, "water_plane", true, "ClipPlaneConstantBuffer", 0u, 1u, 0u, 0u, 0u, "", ""},
        {1u, "portal_plane", true, "ClipPlaneConstantBuffer", 0u, 1u, 0u, 1u, 16u, "", ""},
    }};
