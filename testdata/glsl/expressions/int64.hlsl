// RUN: %clipc -T vs_6_0 --target=glsl450 --validate %s -o - | FileCheck %s
// AUTOUPDATE
// A count of a shift has 32 bits: Mesa refuses others.
int64_t i;
uint64_t2 u;
float4 main(float4 p : POSITION) : SV_Position {
  int64_t a = i * 3 + 5L;
  uint64_t2 b = (u << 3) + (u >> a) + 7UL;
  return p + (float)a + (float)b.x + (float)b.y;
}

// CHECK: #version 450
// CHECK-NEXT: #extension GL_ARB_gpu_shader_int64 : require
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     int64_t i;
// CHECK-NEXT:     u64vec2 u;
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     int64_t a = globals.i * 3l + 5l;
// CHECK-NEXT:     u64vec2 b = (globals.u << 3) + (globals.u >> uvec2(a & 63l)) + 7ul;
// CHECK-NEXT:     gl_Position = in_POSITION0 + float(a) + float(b.x) + float(b.y);
// CHECK-NEXT: }
