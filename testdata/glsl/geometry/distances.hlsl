// Clip and cull distances pass through as GLSL has them, packed as fxc packs them.
// RUN: %clipc %s -T gs_5_0 --validate -o - | FileCheck %s --implicit-check-not=gl_in[]
// RUN: %clipc %s -T gs_5_0 --separable --validate -o - | FileCheck %s --check-prefixes=BLOCK,CHECK
// RUN: %clipc %s -T gs_5_0 --target=vulkan --validate -o - | FileCheck %s --check-prefixes=BLOCK,CHECK
// RUN: %clipc %s -T gs_5_0 -spirv -o %t.spv
struct V {
  float4 p : SV_Position;
  float2 clip : SV_ClipDistance0;
  float cull : SV_CullDistance0;
};
// BLOCK: in gl_PerVertex {
// BLOCK: float gl_ClipDistance[2];
// BLOCK: float gl_CullDistance[1];
// BLOCK: } gl_in[];
// CHECK: gl_ClipDistance[0] = vertex.clip.x;
// CHECK: gl_ClipDistance[1] = vertex.clip.y;
// CHECK: gl_CullDistance[0] = vertex.cull;
// CHECK: vec2(gl_in[0].gl_ClipDistance[0], gl_in[0].gl_ClipDistance[1])
// CHECK: gl_in[1].gl_CullDistance[0]
[maxvertexcount(2)]
void main(line V v[2], inout LineStream<V> stream) {
  stream.Append(v[0]);
  stream.Append(v[1]);
}
