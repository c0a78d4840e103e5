// float %: the sign of the dividend. int %: GLSL's is undefined for negative numbers. Shifts take their count modulo 32.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl130 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// AUTOUPDATE
float3 f;
int3 i;
uint3 u;
int n;

float4 main(float4 p : POSITION) : SV_Position {
  float3 r = f % 2 + fmod(f, p.xyz);
  r %= f;
  int3 a = i / 3 + i / n + i % 3 + (3 << i) + (i >> 5) + (i >> 37) + (i << n) + (i & 3 | ~i ^ 5);
  a %= 4;
  a /= n;
  a <<= 2;
  a >>= i;
  a |= 1;
  int k = n;
  a[k++ & 1] %= 3;
  uint3 b = u / 3 + u % 3 + u % 4u + (u << u) + (u >> 1);
  b %= u;
  a = -a - -a + +a;
  a++;
  --b.x;
  return float4(r + a, b.x - (b.y - b.z) - b.x * (b.y + b.z) / (b.y / b.z));
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     vec3 f;
// CHECK-NEXT:     ivec3 i;
// CHECK-NEXT:     uvec3 u;
// CHECK-NEXT:     int n;
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: vec3 fmod(vec3 x, vec3 y) {
// CHECK-NEXT:     return x - y * trunc(x / y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3 divide(ivec3 x, ivec3 y) {
// CHECK-NEXT:     return mix(mix(x / mix(mix(y, ivec3(1), equal(y, ivec3(0))), ivec3(1), equal(y, ivec3(-1))), -x, equal(y, ivec3(-1))), mix(ivec3(-1), ivec3(1), lessThan(x, ivec3(0))), equal(y, ivec3(0)));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3 imod(ivec3 x, ivec3 y) {
// CHECK-NEXT:     return x - y * (x / y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int imod(int x, int y) {
// CHECK-NEXT:     return x - y * (x / y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int modulo(int x, int y) {
// CHECK-NEXT:     return y == 0 ? x < 0 ? 1 : -1 : imod(x, y == -1 ? 1 : y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int assign_modulo(inout int target, int value) {
// CHECK-NEXT:     target = modulo(target, value);
// CHECK-NEXT:     return target;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: uvec3 modulo(uvec3 x, uvec3 y) {
// CHECK-NEXT:     return mix(x % mix(y, uvec3(1u), equal(y, uvec3(0u))), ~uvec3(0u), equal(y, uvec3(0u)));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: uint divide(uint x, uint y) {
// CHECK-NEXT:     return y == 0u ? ~0u : x / y;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec3 r = fmod(globals.f, vec3(2.0)) + fmod(globals.f, in_POSITION0.xyz);
// CHECK-NEXT:     r = fmod(r, globals.f);
// CHECK-NEXT:     ivec3 a = globals.i / 3 + divide(globals.i, ivec3(globals.n)) + imod(globals.i, ivec3(3)) + (ivec3(3) << (globals.i & 31)) + (globals.i >> 5) + (globals.i >> 5) + (globals.i << (globals.n & 31)) + ((globals.i & 3) | (~globals.i ^ 5));
// CHECK-NEXT:     a = imod(a, ivec3(4));
// CHECK-NEXT:     a = divide(a, ivec3(globals.n));
// CHECK-NEXT:     a <<= 2;
// CHECK-NEXT:     a >>= globals.i & 31;
// CHECK-NEXT:     a |= 1;
// CHECK-NEXT:     int k = globals.n;
// CHECK-NEXT:     assign_modulo(a[k++ & 1], 3);
// CHECK-NEXT:     uvec3 b = globals.u / 3u + globals.u % 3u + globals.u % 4u + (globals.u << (globals.u & 31u)) + (globals.u >> 1);
// CHECK-NEXT:     b = modulo(b, globals.u);
// CHECK-NEXT:     a = -a - -a + a;
// CHECK-NEXT:     a++;
// CHECK-NEXT:     --b.x;
// CHECK-NEXT:     gl_Position = vec4(r + vec3(a), float(b.x - (b.y - b.z) - divide(b.x * (b.y + b.z), divide(b.y, b.z))));
// CHECK-NEXT: }
