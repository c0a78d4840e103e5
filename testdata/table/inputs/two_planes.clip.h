// Written by clipc; changes are lost when it is written again.
#pragma once

#ifdef __cplusplus
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

inline constexpr clipc::StaticClipTable two_planes_clip_table = {
    "main", "vs_4_0_level_9_1",
    "level9", "direct3d-clip",
    3u, 2u,
    {
        {0u, "water_plane", true, "ClipPlanes", 0u, 1u, 0u, 0u, 0u, "ClipPlanes", "water_plane"},
        {1u, "planes[2]", true, "ClipPlanes", 0u, 1u, 0u, 3u, 48u, "ClipPlanes", "planes[2]"},
    }};
#else  // for clipc_table_read
static const char two_planes_clip_table[] =
    "{\"schema\":\"clipc.clip-table\",\"version\":1,\"entry\":\"main\",\"profile\":\"vs_4_0_level_9_1\",\"lowering\":\"level9\",\"position_space\":\"direct3d-clip\",\"plane_scale\":\"any\",\"enable_mask\":3,\"planes\":[{\"index\":0,\"text\":\"water_plane\",\"constant\":{\"cbuffer\":\"ClipPlanes\",\"cbuffer_element\":0,\"register\":1,\"space\":0,\"float4_register\":0,\"byte_offset\":0,\"glsl_block\":\"ClipPlanes\",\"glsl_member\":\"water_plane\"}},{\"index\":1,\"text\":\"planes[2]\",\"constant\":{\"cbuffer\":\"ClipPlanes\",\"cbuffer_element\":0,\"register\":1,\"space\":0,\"float4_register\":3,\"byte_offset\":48,\"glsl_block\":\"ClipPlanes\",\"glsl_member\":\"planes[2]\"}}]}";
#endif
