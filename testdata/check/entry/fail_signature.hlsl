// What the entry point's signature must be like, each rule with its message.
// RUN: not %clipc -T vs_5_0 -E twice %s 2>&1 | FileCheck %s --check-prefix=TWICE
// RUN: not %clipc -T vs_5_0 -E two_indices %s 2>&1 | FileCheck %s --check-prefix=INDICES
// RUN: %clipc -T vs_5_0 -E counted %s -o %t 2>&1 | FileCheck %s --check-prefix=COUNTED
// RUN: not %clipc -T vs_5_0 -E of_pixel_shader %s 2>&1 | FileCheck %s --check-prefix=TARGET
// RUN: not %clipc -T vs_5_0 -E into_pixel_shader %s 2>&1 | FileCheck %s --check-prefix=FRONT
// RUN: not %clipc -T vs_5_0 -E of_group %s 2>&1 | FileCheck %s --check-prefix=GROUP
// RUN: not %clipc -T vs_5_0 -E misspelt %s 2>&1 | FileCheck %s --check-prefix=MISSPELT
// RUN: not %clipc -T vs_5_0 -E wrong_id %s 2>&1 | FileCheck %s --check-prefix=ID
// RUN: not %clipc -T vs_5_0 -E wrong_layer %s 2>&1 | FileCheck %s --check-prefix=LAYER
// RUN: not %clipc -T vs_5_0 -E nine %s 2>&1 | FileCheck %s --check-prefix=NINE

// TWICE: error: semantic `SV_POSITION0` is used twice among the outputs; each index of a semantic may be used once [semantic-twice, X4571]
// TWICE: note: first used here
float4 twice(float4 a : POSITION, out float4 b : SV_Position) : sv_position0 { return b = a; }
// INDICES: error: semantic `SV_POSITION0` is used twice among the outputs
void two_indices(float4 a : POSITION, out float4 b : SV_Position, out float4 c : SV_Position1) { b = c = a; }
// A matrix takes an index a row, and this is plain data. COUNTED: warning: semantic `TEXCOORD2` is used twice among the inputs
float4 counted(float4x4 m : TEXCOORD0, float4 b : TEXCOORD2) : SV_Position { return mul(b, m); }

// TARGET: error: `SV_Target` is not an output of a vertex shader; `-T ps_5_0` compiles a pixel shader [semantic-not-for-stage, X4502]
float4 of_pixel_shader(float4 v : POSITION) : SV_Target { return v; }
// GROUP: error: `SV_DispatchThreadID` is not an input of a vertex shader; `-T cs_5_0` compiles a compute shader [semantic-not-for-stage, X4502]
float4 of_group(uint3 thread : SV_DispatchThreadID) : SV_Position { return thread.xyzx; }
// FRONT: error: `SV_IsFrontFace` is not an input of a vertex shader; `-T ps_5_0` compiles a pixel shader [semantic-not-for-stage, X4502]
float4 into_pixel_shader(float4 v : POSITION, bool front : SV_IsFrontFace) : SV_Position { return v; }
// MISSPELT: error: `SV_VertexIndex` is not an input of a vertex shader; did you mean `SV_VertexID`? [semantic-not-for-stage, X4502]
// MISSPELT: error: `SV_Postion` is not an output of a vertex shader; did you mean `SV_Position`? [semantic-not-for-stage, X4502]
// MISSPELT: SV_Position
float4 misspelt(float4 v : POSITION, uint id : SV_VertexIndex) : SV_Postion { return v * id; }
// ID: error: `SV_VertexID` has type `float`; it must be a `uint` [semantic-type, X4503]
float4 wrong_id(float id : SV_VertexID) : SV_Position { return id; }
// LAYER: error: `SV_RenderTargetArrayIndex` has type `float`; it must be a `uint` [semantic-type, X4503]
float4 wrong_layer(float4 v : POSITION, out float layer : SV_RenderTargetArrayIndex) : SV_Position { layer = 0; return v; }
// NINE: error: 12 clip and cull distances are written; the limit is 8 [too-many-clip-distances, X4567]
float4 nine(float4 v : POSITION, out float4 d[3] : SV_ClipDistance) : SV_Position { d[0] = d[1] = d[2] = v; return v; }
