// [unroll], [loop], [branch] and [flatten] are GL_EXT_control_flow_attributes on Vulkan; OpenGL has none.
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s --check-prefix=GL
// RUN: %draw compare %s -T vs_5_0 --target=vulkan
// GL-NOT: control_flow
// GL-NOT: {{\[\[}}
float4 u[8];
int n;

// CHECK: #extension GL_EXT_control_flow_attributes : require
// CHECK: void main() {
float4 main(float4 p : POSITION) : SV_Position {
  float4 r = p;
  // CHECK: {{\[\[unroll\]\]}} for (int i = 0; i < 3; i++) {
  [unroll(3)] for (int i = 0; i < 3; i++) r += u[i];
  // CHECK: {{\[\[dont_unroll\]\]}} for (int j = 0; j < {{.*}}; j++) {
  [loop] for (int j = 0; j < n; j++) r += u[j & 7];
  // CHECK: {{\[\[dont_flatten\]\]}} if (in_POSITION0.x > 0.0) {
  [branch] if (p.x > 0) r += 1;
  // CHECK: } else {{\[\[flatten\]\]}} if (in_POSITION0.y > 0.0) {
  else [flatten] if (p.y > 0) r *= 2;
  // CHECK: {{\[\[dont_unroll\]\]}} while (
  [LOOP] [allow_uav_condition] while (r.x > n + 4) r.x -= 1 + abs(r.x) / 2;
  // CHECK: {{\[\[unroll\]\]}} do {
  [unroll] do r.y += 1; while (r.y < 0 && r.y > -3);
  // CHECK: {{\[\[dont_flatten\]\]}} switch (
  [branch] switch (n) { case 0: r += 1; break; case 1: r *= 2; break; }
  return r;
}
