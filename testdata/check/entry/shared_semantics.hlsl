// A semantic may be used twice where it is plain data: fxc refuses (X4571), glslang and DXC's SPIR-V give each use a place of
// its own. A system value is one input.
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate %s -o - 2>%t.err | FileCheck %s --check-prefix=CHECK
// RUN: FileCheck %s --check-prefix=WARN < %t.err
// AUTOUPDATE
struct Output {
  float3 lights[2] : TEXCOORD2;
  // WARN-DAG: [[#@LINE+1]]:17: warning: semantic `TEXCOORD3` is used twice among the outputs; each use gets its own location, fxc reports an error [-Wsemantic-shared]
  float3 view : TEXCOORD3;
  float4 position : SV_Position;
};
// WARN-DAG: [[#@LINE+1]]:45: warning: semantic `POSITION0` is used twice among the inputs
Output main(float4 a : POSITION, float4 b : POSITION0, uint id : SV_VertexID, uint again : SV_VertexID) {
  Output result;
  result.lights[0] = a.xyz;
  result.lights[1] = b.xyz;
  result.view = id + again;
  result.position = a + b;
  return result;
}

// CHECK: #version 450
// CHECK-NEXT: #extension GL_ARB_shader_draw_parameters : require
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // a : POSITION0
// CHECK-NEXT: layout(location = 1) in vec4 in_POSITION0_2;  // b : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out vec3 vs_TEXCOORD2;  // lights : TEXCOORD2
// CHECK-NEXT: layout(location = 1) out vec3 vs_TEXCOORD3;  // lights : TEXCOORD3
// CHECK-NEXT: layout(location = 2) out vec3 vs_TEXCOORD3_2;  // view : TEXCOORD3
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint id = uint(gl_VertexID - gl_BaseVertexARB);
// CHECK-NEXT:     uint again = uint(gl_VertexID - gl_BaseVertexARB);
// CHECK-NEXT:     vec3 lights[2];
// CHECK-NEXT:     lights[0] = in_POSITION0.xyz;
// CHECK-NEXT:     lights[1] = in_POSITION0_2.xyz;
// CHECK-NEXT:     vs_TEXCOORD3_2 = vec3(float(id + again));
// CHECK-NEXT:     gl_Position = in_POSITION0 + in_POSITION0_2;
// CHECK-NEXT:     vs_TEXCOORD2 = lights[0];
// CHECK-NEXT:     vs_TEXCOORD3 = lights[1];
// CHECK-NEXT: }
