// A static local whose value is that of the first time: a flag where control may come there twice, an ordinary variable where it
// cannot, and a global where it is the same everywhere.
// RUN: %clipc -T vs_6_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_6_0 --target=essl300 --validate %s -o %t
// RUN: %clipc -T vs_6_0 --target=glsl120 --validate %s -o %t
// RUN: %clipc -T vs_6_0 -spirv --validate %s -o %t
// CHECK-NOT: w_is_set
// CHECK: bool n_is_set = false;
// CHECK: float c = 2.0 * {{.*}}size;
// CHECK: float twice(float x) {
// CHECK-NEXT: if (!n_is_set) {
// CHECK-NEXT: n = x * 2.0;
// CHECK-NEXT: n_is_set = true;
// CHECK: return n;
float size;
float twice(float x) { static float n = x * 2; return n; }
// CHECK: float single(float x) {
// CHECK-NEXT: float m = x + 1.0;
float single(float x) { static float m = x + 1; m += 1; return m; }
float plain() { static const float w = 1.0 / size; return w; }
float counted() { const float k = 2; static float c = k * size; c += 1; return c; }
float4 main(float4 p : POSITION) : SV_Position { return p * twice(p.x) * twice(p.y) * single(p.z) * plain() * plain() * counted() * counted(); }
