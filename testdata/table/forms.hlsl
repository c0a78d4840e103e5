// The three forms of one table, beside the GLSL. The binary one is Direct3D's record: opcode 0x35 with class 5, seven
// DWORDs, two planes, then cb1[0] and cb1[3], one register each.
// RUN: %clipc -T vs_4_0_level_9_1 -E main %s -o %t.vert --table %t.json && FileCheck %s --check-prefix=JSON < %t.json
// RUN: %clipc -T vs_4_0_level_9_1 -E main %s -o %t.vert --table %t.bin && od -An -v -tx4 %t.bin | FileCheck %s --check-prefix=BINARY
// RUN: %clipc -T vs_4_0_level_9_1 -E main %s -o %t.vert --table %t.h && FileCheck %s --check-prefix=HEADER < %t.h

cbuffer Transform : register(b0) {
  float4x4 view_projection;
};
cbuffer ClipPlanes : register(b1) {
  float4 water_plane;
  float4 planes[3];
};

[clipplanes(water_plane, planes[2])]
float4 main(float4 position : POSITION) : SV_Position { return mul(position, view_projection); }

// JSON: "schema": "clipc.clip-table",
// JSON-NEXT: "version": 1,
// JSON-NEXT: "entry": "main",
// JSON-NEXT: "profile": "vs_4_0_level_9_1",
// JSON-NEXT: "lowering": "level9",
// JSON-NEXT: "position_space": "direct3d-clip",
// JSON-NEXT: "plane_scale": "any",
// JSON-NEXT: "enable_mask": 3,
// JSON: "text": "water_plane",
// JSON: "cbuffer": "ClipPlanes",
// JSON: "register": 1,
// JSON: "text": "planes[2]",
// JSON: "float4_register": 3,
// JSON-NEXT: "byte_offset": 48,

// BINARY: 00002835 00000007 00000002 00000001
// BINARY-NEXT: 00000001 00030001 00000001

// HEADER: inline constexpr clipc::StaticClipTable {{[a-z_]+}}_clip_table = {
// HEADER-NEXT: "main", "vs_4_0_level_9_1",
// HEADER-NEXT: "level9", "direct3d-clip",
// HEADER-NEXT: 3u, 2u,
// HEADER: {0u, "water_plane", true, "ClipPlanes", 0u, 1u, 0u, 0u, 0u,
// HEADER-NEXT: {1u, "planes[2]", true, "ClipPlanes", 0u, 1u, 0u, 3u, 48u,
