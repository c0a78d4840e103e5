// What GLSL has only for vectors is done row by row; matrices of integers and booleans are arrays of rows.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// AUTOUPDATE
float4x4 a, b;
row_major int3x3 i;

float4 main(float4 p : POSITION) : SV_Position {
  float4 r = abs(a)[0] + max(a, b)[1] + saturate(a)[2] + lerp(a, b, 0.5)[3] + (a % b)[0] + sign(a)[1];
  if (all(a == b) || any(a < b)) r += 1;
  r += (a > b ? a : b)[2];
  bool4x4 both = a > 0 && !(b < 1);
  r.x += both[1][2];
  int3x3 j = i * 2 + i / 3;
  j[1].x = 5;
  j = -j;
  j++;
  r.xyz += j[2] + mul(j, i)[0] + mul(j, int3(1, 2, 3)) + mul(int3(1, 2, 3), j) + transpose(j)[1];
  r.xyz += ((int3x3)a)[0] + ((float3x3)j)[1];
  r += ((float4x4)p.x)[0] + ((float4x4)(p.x * p.y))[1] + ((float4x4)0)[2];
  return r;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     layout(row_major) mat4 a;
// CHECK-NEXT:     layout(row_major) mat4 b;
// CHECK-NEXT:     ivec3 i[3];
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: mat4 abs_(mat4 a) {
// CHECK-NEXT:     return mat4(abs(a[0]), abs(a[1]), abs(a[2]), abs(a[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat4 max_(mat4 a, mat4 b) {
// CHECK-NEXT:     return mat4(max(a[0], b[0]), max(a[1], b[1]), max(a[2], b[2]), max(a[3], b[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 saturate(vec4 x) {
// CHECK-NEXT:     return min(max(vec4(0.0), x), 1.0);  // 0 for NaN
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat4 saturate(mat4 a) {
// CHECK-NEXT:     return mat4(saturate(a[0]), saturate(a[1]), saturate(a[2]), saturate(a[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat4 lerp(mat4 a, mat4 b, mat4 c) {
// CHECK-NEXT:     return mat4(mix(a[0], b[0], c[0]), mix(a[1], b[1], c[1]), mix(a[2], b[2], c[2]), mix(a[3], b[3], c[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 fmod(vec4 x, vec4 y) {
// CHECK-NEXT:     return x - y * trunc(x / y);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat4 modulo(mat4 a, mat4 b) {
// CHECK-NEXT:     return mat4(fmod(a[0], b[0]), fmod(a[1], b[1]), fmod(a[2], b[2]), fmod(a[3], b[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec4[4] sign_(mat4 a) {
// CHECK-NEXT:     return ivec4[4](ivec4(sign(a[0])), ivec4(sign(a[1])), ivec4(sign(a[2])), ivec4(sign(a[3])));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bvec4[4] equal_rows(mat4 a, mat4 b) {
// CHECK-NEXT:     return bvec4[4](equal(a[0], b[0]), equal(a[1], b[1]), equal(a[2], b[2]), equal(a[3], b[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool all_(bvec4 m[4]) {
// CHECK-NEXT:     return all(m[0]) && all(m[1]) && all(m[2]) && all(m[3]);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bvec4[4] less(mat4 a, mat4 b) {
// CHECK-NEXT:     return bvec4[4](lessThan(a[0], b[0]), lessThan(a[1], b[1]), lessThan(a[2], b[2]), lessThan(a[3], b[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool any_(bvec4 m[4]) {
// CHECK-NEXT:     return any(m[0]) || any(m[1]) || any(m[2]) || any(m[3]);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bvec4[4] greater(mat4 a, mat4 b) {
// CHECK-NEXT:     return bvec4[4](greaterThan(a[0], b[0]), greaterThan(a[1], b[1]), greaterThan(a[2], b[2]), greaterThan(a[3], b[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat4 select(bvec4 a[4], mat4 b, mat4 c) {
// CHECK-NEXT:     return mat4(mix(c[0], b[0], a[0]), mix(c[1], b[1], a[1]), mix(c[2], b[2], a[2]), mix(c[3], b[3], a[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bvec4[4] logical_not(bvec4 a[4]) {
// CHECK-NEXT:     return bvec4[4](not(a[0]), not(a[1]), not(a[2]), not(a[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bvec4 logical_and(bvec4 a, bvec4 b) {
// CHECK-NEXT:     return bvec4(a.x && b.x, a.y && b.y, a.z && b.z, a.w && b.w);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bvec4[4] logical_and(bvec4 a[4], bvec4 b[4]) {
// CHECK-NEXT:     return bvec4[4](logical_and(a[0], b[0]), logical_and(a[1], b[1]), logical_and(a[2], b[2]), logical_and(a[3], b[3]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3[3] multiply(ivec3 a[3], ivec3 b[3]) {
// CHECK-NEXT:     return ivec3[3](a[0] * b[0], a[1] * b[1], a[2] * b[2]);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3 divide(ivec3 x, ivec3 y) {
// CHECK-NEXT:     return mix(mix(x / mix(mix(y, ivec3(1), equal(y, ivec3(0))), ivec3(1), equal(y, ivec3(-1))), -x, equal(y, ivec3(-1))), mix(ivec3(-1), ivec3(1), lessThan(x, ivec3(0))), equal(y, ivec3(0)));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3[3] divide(ivec3 a[3], ivec3 b[3]) {
// CHECK-NEXT:     return ivec3[3](divide(a[0], b[0]), divide(a[1], b[1]), divide(a[2], b[2]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3[3] add(ivec3 a[3], ivec3 b[3]) {
// CHECK-NEXT:     return ivec3[3](a[0] + b[0], a[1] + b[1], a[2] + b[2]);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3[3] negate(ivec3 a[3]) {
// CHECK-NEXT:     return ivec3[3](-a[0], -a[1], -a[2]);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3[3] post_increment(inout ivec3 m[3]) {
// CHECK-NEXT:     ivec3 before[3] = m;
// CHECK-NEXT:     m[0]++;
// CHECK-NEXT:     m[1]++;
// CHECK-NEXT:     m[2]++;
// CHECK-NEXT:     return before;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3[3] mul(ivec3 a[3], ivec3 b[3]) {
// CHECK-NEXT:     return ivec3[3](a[0].x * b[0] + a[0].y * b[1] + a[0].z * b[2], a[1].x * b[0] + a[1].y * b[1] + a[1].z * b[2], a[2].x * b[0] + a[2].y * b[1] + a[2].z * b[2]);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int dot_(ivec3 a, ivec3 b) {
// CHECK-NEXT:     return a.x * b.x + a.y * b.y + a.z * b.z;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3 mul(ivec3 a[3], ivec3 b) {
// CHECK-NEXT:     return ivec3(dot_(a[0], b), dot_(a[1], b), dot_(a[2], b));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3 mul(ivec3 a, ivec3 b[3]) {
// CHECK-NEXT:     return a.x * b[0] + a.y * b[1] + a.z * b[2];
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3[3] transpose_(ivec3 m[3]) {
// CHECK-NEXT:     return ivec3[3](ivec3(m[0].x, m[1].x, m[2].x), ivec3(m[0].y, m[1].y, m[2].y), ivec3(m[0].z, m[1].z, m[2].z));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int to_int(float x) {
// CHECK-NEXT:     return x < 2147483648.0 ? int(max(-2147483648.0, x)) : x > 0.0 ? 2147483647 : 0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3 to_int(vec3 a) {
// CHECK-NEXT:     return ivec3(to_int(a.x), to_int(a.y), to_int(a.z));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec3[3] to_int(mat3 a) {
// CHECK-NEXT:     return ivec3[3](to_int(a[0]), to_int(a[1]), to_int(a[2]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat3 to_float(ivec3 a[3]) {
// CHECK-NEXT:     return mat3(vec3(a[0]), vec3(a[1]), vec3(a[2]));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: mat4 splat_mat4(float x) {
// CHECK-NEXT:     return mat4(vec4(x), vec4(x), vec4(x), vec4(x));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = abs_(globals.a)[0] + max_(globals.a, globals.b)[1] + saturate(globals.a)[2] + lerp(globals.a, globals.b, mat4(vec4(0.5), vec4(0.5), vec4(0.5), vec4(0.5)))[3] + modulo(globals.a, globals.b)[0] + vec4(sign_(globals.a)[1]);
// CHECK-NEXT:     if (all_(equal_rows(globals.a, globals.b)) || any_(less(globals.a, globals.b))) {
// CHECK-NEXT:         gl_Position += 1.0;
// CHECK-NEXT:     }
// CHECK-NEXT:     gl_Position += select(greater(globals.a, globals.b), globals.a, globals.b)[2];
// CHECK-NEXT:     bvec4 both[4] = logical_and(greater(globals.a, mat4(0.0)), logical_not(less(globals.b, mat4(vec4(1.0), vec4(1.0), vec4(1.0), vec4(1.0)))));
// CHECK-NEXT:     gl_Position.x += float(both[1][2]);
// CHECK-NEXT:     ivec3 j[3] = add(multiply(globals.i, ivec3[3](ivec3(2), ivec3(2), ivec3(2))), divide(globals.i, ivec3[3](ivec3(3), ivec3(3), ivec3(3))));
// CHECK-NEXT:     j[1].x = 5;
// CHECK-NEXT:     j = negate(j);
// CHECK-NEXT:     post_increment(j);
// CHECK-NEXT:     gl_Position.xyz += vec3(j[2] + mul(j, globals.i)[0] + mul(j, ivec3(1, 2, 3)) + mul(ivec3(1, 2, 3), j) + transpose_(j)[1]);
// CHECK-NEXT:     gl_Position.xyz += vec3(to_int(mat3(globals.a))[0]) + to_float(j)[1];
// CHECK-NEXT:     gl_Position += mat4(vec4(in_POSITION0.x), vec4(in_POSITION0.x), vec4(in_POSITION0.x), vec4(in_POSITION0.x))[0] + splat_mat4(in_POSITION0.x * in_POSITION0.y)[1] + mat4(0.0)[2];
// CHECK-NEXT: }
