// Functions of matrices that GLSL has for float matrices only, and dot() of integers, become sums and constructors.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-matrix-functions --stop-after=lower-matrix-functions %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
int2x3 i;
int3 k;
bool2x2 flags;
float4x4 m;

float4 main(float4 p : POSITION) : SV_Position {
  int2 product = mul(i, k);
  int3x2 turned = transpose(i);
  return mul(p, m) + product.xyxy + turned[2].xyxy + dot(k, k) + (any(flags) ? 1 : 0) + ((int2x2)i)[1].xyxy;
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: globals $Globals : b0, 160 bytes {
// CHECK-NEXT:   int2x3 i at 0, 40 bytes
// CHECK-NEXT:   int3 k at 48, 12 bytes
// CHECK-NEXT:   bool2x2 flags at 64, 24 bytes
// CHECK-NEXT:   float4x4 m at 96, 64 bytes
// CHECK-NEXT: }
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   int2 product = mul(i, k)
// CHECK-NEXT:   int3x2 turned = transpose(i)
// CHECK-NEXT:   vs_SV_POSITION0 = ((((mul(in_POSITION0, m) + convert<float4>(product.xyxy)) + convert<float4>(turned[2].xyxy)) + splat<float4>(convert<float>(dot(k, k)))) + splat<float4>(convert<float>(any(flags) ? 1 : 0))) + convert<float4>(truncate_ivec2[2](i)[1].xyxy)
// CHECK-NEXT: }
// CHECK-NEXT: helper int dot(int3 a.1, int3 b.1) {
// CHECK-NEXT:   return ((a.1.x * b.1.x) + (a.1.y * b.1.y)) + (a.1.z * b.1.z)
// CHECK-NEXT: }
// CHECK-NEXT: helper int2 mul(int2x3 a, int3 b) {
// CHECK-NEXT:   return int2(dot(a[0u], b), dot(a[1u], b))
// CHECK-NEXT: }
// CHECK-NEXT: helper int3x2 transpose(int2x3 m.1) {
// CHECK-NEXT:   return int3x2(int2(m.1[0u].x, m.1[1u].x), int2(m.1[0u].y, m.1[1u].y), int2(m.1[0u].z, m.1[1u].z))
// CHECK-NEXT: }
// CHECK-NEXT: helper bool any(bool2x2 m.2) {
// CHECK-NEXT:   return any(m.2[0u]) or_else any(m.2[1u])
// CHECK-NEXT: }
// CHECK-NEXT: helper int2x2 truncate_ivec2[2](int2x3 m.3) {
// CHECK-NEXT:   return int2x2(m.3[0u].xy, m.3[1u].xy)
// CHECK-NEXT: }
