// Inputs and outputs are taken apart: structs by field, arrays by element, matrices by column; names come from semantics.
// RUN: %clipc -T vs_5_0 -E main --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_3_0 -E old --validate %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_5_0 -E old --validate %s -o - | FileCheck %s --check-prefix=NEW
struct Inner { float2 uv[2] : TexCoord3; bool flag : FLAG; };
struct Input { float4 position : SV_Position; Inner inner; float3x2 m : MATRIX; };
struct Output { float4 position : SV_Position; nointerpolation int number : NUMBER; noperspective float2 uv : TEXCOORD7; };

void main(Input i, uint id : SV_VertexID, out Output o, inout float4 color : COLOR) {
  o.position = i.position;
  o.number = i.inner.flag ? (int)id : 0;
  o.uv = i.inner.uv[1] + mul(float3(1, 2, 3), i.m);
  color *= 2;
}
// CHECK-DAG: layout(location = 0) in vec4 in_SV_POSITION0;
// CHECK-DAG: layout(location = 2) in vec2 in_TEXCOORD4;
// CHECK-DAG: layout(location = 3) in uint in_FLAG0;
// CHECK-DAG: layout(location = 4) in vec3 in_MATRIX0;
// CHECK-DAG: layout(location = 5) in vec3 in_MATRIX1;
// CHECK-DAG: layout(location = 6) in vec4 in_COLOR0;
// CHECK-DAG: layout(location = 0) flat out int vs_NUMBER0;
// CHECK-DAG: layout(location = 1) noperspective out vec2 vs_TEXCOORD7;
// CHECK-DAG: layout(location = 2) out vec4 vs_COLOR0;

// Direct3D 9's vertex shaders call their position POSITION; from 4.0 on it is an ordinary output.
struct Old { float4 position : POSITION; float size : PSIZE; float fog : FOG; };
Old old(float4 v : POSITION) { Old o; o.position = v; o.size = 2; o.fog = 1; return o; }
// OLD-DAG: gl_Position =
// OLD-DAG: gl_PointSize =
// OLD-DAG: vs_FOG0 =
// NEW-NOT: gl_Position
// NEW: vs_POSITION0 =
