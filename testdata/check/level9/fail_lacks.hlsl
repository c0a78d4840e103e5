// What feature level 9 lacks, each with its own message.
// RUN: not %clipc -T vs_4_0_level_9_1 -E vertex_id %s 2>&1 | FileCheck %s --check-prefix=ID
// RUN: not %clipc -T vs_4_0_level_9_3 -E bits %s 2>&1 | FileCheck %s --check-prefix=BITS
// RUN: not %clipc -T vs_4_0_level_9_1 -E as_int %s 2>&1 | FileCheck %s --check-prefix=ASINT
// RUN: not %clipc -T vs_4_0_level_9_1 -E texture_read %s 2>&1 | FileCheck %s --check-prefix=TEXTURE
// RUN: not %clipc -T vs_4_0_level_9_1 -E tbuffer_read %s 2>&1 | FileCheck %s --check-prefix=TBUFFER
// RUN: not %clipc -T vs_4_0_level_9_1 -E by_hand %s 2>&1 | FileCheck %s --check-prefix=HAND
// RUN: not %clipc -T vs_4_0_level_9_1 -E inputs %s 2>&1 | FileCheck %s --check-prefix=INPUTS
// RUN: not %clipc -T vs_4_0_level_9_1 -E outputs %s 2>&1 | FileCheck %s --check-prefix=OUTPUTS
// RUN: not %clipc -T vs_4_0_level_9_1 -E constants %s 2>&1 | FileCheck %s --check-prefix=CONSTANTS
// RUN: not %clipc -T vs_4_0_level_9_1 -E dynamic %s 2>&1 | FileCheck %s --check-prefix=DYNAMIC
// RUN: not %clipc -T vs_4_0_level_9_1 -E long_one %s 2>&1 | FileCheck %s --check-prefix=LONG

// ID: error: `SV_VertexID` does not exist under `vs_4_0_level_9_1` [level9-system-value, X4583]
float4 vertex_id(uint id : SV_VertexID) : SV_Position { return float4(id, 0, 0, 1); }
int mask;
// BITS: error: a bit operation is used; `vs_4_0_level_9_3` has no integer instructions [level9-bit-operation, X3535]
float4 bits(float4 v : POSITION) : SV_Position { return v * (mask & 3); }
// ASINT: error: `asint` works with the bits of integers; `vs_4_0_level_9_1` has no integer instructions [level9-intrinsic, X4583]
float4 as_int(float4 v : POSITION) : SV_Position { return v * asint(v.x); }
Texture2D<float4> t;
SamplerState s;
// TEXTURE: error: a texture or buffer is read; `vs_4_0_level_9_1` cannot do that in a vertex shader [level9-texture, X4583]
float4 texture_read(float4 v : POSITION) : SV_Position { return t.SampleLevel(s, v.xy, 0); }
tbuffer T { float4 from_texture; };
// TBUFFER: error: `T` is a tbuffer; `vs_4_0_level_9_1` cannot read textures or buffers in a vertex shader [level9-tbuffer, X4583]
float4 tbuffer_read(float4 v : POSITION) : SV_Position { return v + from_texture; }
// HAND: error: the shader writes `SV_ClipDistance`; `vs_4_0_level_9_1` has no clip distances; give the planes with `clipplanes` [level9-clip-distance, X4583]
float4 by_hand(float4 v : POSITION, out float d : SV_ClipDistance) : SV_Position { d = 1; return v; }
// INPUTS: error: the shader has 17 inputs; the limit is 16 under `vs_4_0_level_9_1` [level9-inputs, X4583]
float4 inputs(float4 v[17] : POSITION) : SV_Position { return v[16]; }
// OUTPUTS: error: the shader has 9 outputs besides the position; the limit is 8 under `vs_4_0_level_9_1` [level9-outputs, X4583]
float4 outputs(float4 v : POSITION, out float4 o[9] : TEXCOORD) : SV_Position { o[0] = o[1] = o[2] = o[3] = o[4] = o[5] = o[6] = o[7] = o[8] = v; return v; }
cbuffer Big { float4 big[256]; };
// CONSTANTS: error: 256 constant registers are used; the limit is 255 under `vs_4_0_level_9_1` [level9-constants, X4583]
float4 constants(float4 v : POSITION) : SV_Position { return v + big[3]; }
cbuffer Small { float4 small[4]; };
// DYNAMIC: error: the index is not constant; under `vs_4_0_level_9_1` only constants can be indexed at run time [level9-dynamic-index, X4583]
float4 dynamic(float4 v : POSITION) : SV_Position { float4 local[2] = {v, v}; return local[(int)v.x] + small[(int)v.y]; }
#define TIMES4(x) x x x x
// LONG: error: the shader needs at least 257 instructions; the limit is 256 under `vs_4_0_level_9_1` [level9-instructions, X4583]
float4 long_one(float4 v : POSITION) : SV_Position { TIMES4(TIMES4(TIMES4(TIMES4(v *= small[1];)))) v *= 2; return v; }
