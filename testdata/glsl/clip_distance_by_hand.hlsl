// SV_ClipDistance of any shape ends up in one array, packed by register as fxc packs; the comment says which are written.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate -DNO_CULL %s -o %t
// AUTOUPDATE
struct Output {
  float4 position : SV_Position;
  float3 first : SV_ClipDistance0;
  float2 second : SV_ClipDistance1;
#ifndef NO_CULL
  float culled[2] : SV_CullDistance;
#endif
};
Output main(float4 p : POSITION) {
  Output output;
  output.position = p;
  output.first = p.xyz;
  output.second = p.zw;
#ifndef NO_CULL
  output.culled[0] = p.x;
  output.culled[1] = p.y;
#endif
  return output;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: struct Output {
// CHECK-NEXT:     vec4 position;
// CHECK-NEXT:     vec3 first;
// CHECK-NEXT:     vec2 second;
// CHECK-NEXT:     float culled[2];
// CHECK-NEXT: };
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: // clip distances written: 0x3f
// CHECK-NEXT: // cull distances written: 0x3
// CHECK-NEXT: out float gl_ClipDistance[6];
// CHECK-NEXT: out float gl_CullDistance[2];
// CHECK-EMPTY:
// CHECK-NEXT: Output shader_main(vec4 p) {
// CHECK-NEXT:     Output output_;
// CHECK-NEXT:     output_.position = p;
// CHECK-NEXT:     output_.first = p.xyz;
// CHECK-NEXT:     output_.second = p.zw;
// CHECK-NEXT:     output_.culled[0] = p.x;
// CHECK-NEXT:     output_.culled[1] = p.y;
// CHECK-NEXT:     return output_;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     Output result = shader_main(in_POSITION0);
// CHECK-NEXT:     gl_Position = result.position;
// CHECK-NEXT:     gl_ClipDistance[0] = result.first.x;
// CHECK-NEXT:     gl_ClipDistance[1] = result.first.y;
// CHECK-NEXT:     gl_ClipDistance[2] = result.first.z;
// CHECK-NEXT:     gl_ClipDistance[3] = 0.0;
// CHECK-NEXT:     gl_ClipDistance[4] = result.second.x;
// CHECK-NEXT:     gl_ClipDistance[5] = result.second.y;
// CHECK-NEXT:     gl_CullDistance[0] = result.culled[0];
// CHECK-NEXT:     gl_CullDistance[1] = result.culled[1];
// CHECK-NEXT: }
