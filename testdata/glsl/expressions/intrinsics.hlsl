// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl150 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// AUTOUPDATE
float4 a, b, c;
float s, t;
int4 i;

float4 main(float4 p : POSITION) : SV_Position {
  float4 r = abs(a) + acos(a) + asin(a) + atan(a) + atan2(a, b) + ceil(a) + clamp(a, 0, 1) + clamp(a, b, c);
  r += cos(a) + cosh(a) + degrees(a) + exp(a) + exp2(a) + floor(a) + frac(a) + ldexp(a, b) + lerp(a, b, c) + lerp(a, b, s);
  r += log(a) + log10(a) + log2(a) + mad(a, b, c) * 2 + max(a, 0) + min(a, b) + pow(a, 2.2) + radians(a) + rcp(a) + round(a);
  r += rsqrt(a) + saturate(a) + sin(a) + sinh(a) + sqrt(a) + step(0.5, a) + tan(a) + tanh(a) + trunc(a) + saturate(s);
  r += smoothstep(0, 1, a) + smoothstep(1, 0, a) + smoothstep(a, b, c);
  r.xyz += cross(a.xyz, b.xyz) + faceforward(a.xyz, b.xyz, c.xyz) + normalize(p.xyz) + reflect(a.xyz, b.xyz) + refract(a.xyz, b.xyz, 1.5);
  r.x += distance(a, b) + dot(a, b) + length(a) + dot(s, t) + dot(i, i);
  r += lit(s, t, 8) + dst(a, b) + D3DCOLORtoUBYTE4(a);
  r += sign(a) * 2 + sign(i) + abs(i) + max(i, 3) + clamp(i, 0, 9) + (int)sign(s);
  float4 sine, cosine;
  sincos(a, sine, cosine);
  r += sine + cosine;
  float4 whole;
  r += modf(a, whole) + whole;
  int4 whole_int;
  r += modf(i, whole_int) + whole_int;
  float exponent;
  r.x += frexp(s, exponent) + exponent;
  float2 exponents;
  r.xy += frexp(a.xy, exponents) + exponents;
  if (isnan(s) || isinf(s) || !isfinite(s) || any(isnan(a)) || all(isfinite(a))) r = 0;
  return r;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     vec4 a;
// CHECK-NEXT:     vec4 b;
// CHECK-NEXT:     vec4 c;
// CHECK-NEXT:     float s;
// CHECK-NEXT:     float t;
// CHECK-NEXT:     ivec4 i;
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: vec4 saturate(vec4 x) {
// CHECK-NEXT:     return min(max(vec4(0.0), x), 1.0);  // 0 for NaN
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float saturate(float x) {
// CHECK-NEXT:     return min(max(0.0, x), 1.0);  // 0 for NaN
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 smoothstep_(vec4 a, vec4 b, vec4 x) {
// CHECK-NEXT:     vec4 t = saturate((x - a) / (b - a));
// CHECK-NEXT:     return t * t * (t * -2.0 + 3.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int dot_(ivec4 a, ivec4 b) {
// CHECK-NEXT:     return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 lit(float n_dot_l, float n_dot_h, float m) {
// CHECK-NEXT:     float specular = n_dot_l < 0.0 || n_dot_h < 0.0 ? 0.0 : pow(n_dot_h, m);
// CHECK-NEXT:     return vec4(1.0, max(n_dot_l, 0.0), specular, 1.0);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec4 dst(vec4 a, vec4 b) {
// CHECK-NEXT:     return vec4(1.0, a.y * b.y, a.z, b.w);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void sincos(vec4 x, out vec4 s, out vec4 c) {
// CHECK-NEXT:     s = sin(x);
// CHECK-NEXT:     c = cos(x);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec4 modf_(ivec4 x, out ivec4 whole) {
// CHECK-NEXT:     whole = x;
// CHECK-NEXT:     return x - x;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: float frexp_(float x, out float exponent) {
// CHECK-NEXT:     uint bits = floatBitsToUint(x);
// CHECK-NEXT:     exponent = x == 0.0 ? 0.0 : float(int((bits >> 23) & 255u) - 126);
// CHECK-NEXT:     return x == 0.0 ? 0.0 : uintBitsToFloat((bits & 0x007FFFFFu) | 0x3F000000u);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: vec2 frexp_(vec2 a, out vec2 b) {
// CHECK-NEXT:     return vec2(frexp_(a.x, b.x), frexp_(a.y, b.y));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool isfinite(float x) {
// CHECK-NEXT:     return !(isnan(x) || isinf(x));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bvec4 isfinite(vec4 a) {
// CHECK-NEXT:     return bvec4(isfinite(a.x), isfinite(a.y), isfinite(a.z), isfinite(a.w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = abs(globals.a) + acos(globals.a) + asin(globals.a) + atan(globals.a) + atan(globals.a, globals.b) + ceil(globals.a) + clamp(globals.a, 0.0, 1.0) + clamp(globals.a, globals.b, globals.c);
// CHECK-NEXT:     gl_Position += cos(globals.a) + cosh(globals.a) + degrees(globals.a) + exp(globals.a) + exp2(globals.a) + floor(globals.a) + fract(globals.a) + globals.a * exp2(globals.b) + mix(globals.a, globals.b, globals.c) + mix(globals.a, globals.b, globals.s);
// CHECK-NEXT:     gl_Position += log(globals.a) + log2(globals.a) * 0.30103 + log2(globals.a) + (globals.a * globals.b + globals.c) * 2.0 + max(globals.a, 0.0) + min(globals.a, globals.b) + pow(globals.a, vec4(2.2)) + radians(globals.a) + 1.0 / globals.a + roundEven(globals.a);
// CHECK-NEXT:     gl_Position += inversesqrt(globals.a) + saturate(globals.a) + sin(globals.a) + sinh(globals.a) + sqrt(globals.a) + step(0.5, globals.a) + tan(globals.a) + tanh(globals.a) + trunc(globals.a) + saturate(globals.s);
// CHECK-NEXT:     gl_Position += smoothstep(0.0, 1.0, globals.a) + smoothstep_(vec4(1.0), vec4(0.0), globals.a) + smoothstep_(globals.a, globals.b, globals.c);
// CHECK-NEXT:     gl_Position.xyz += cross(globals.a.xyz, globals.b.xyz) + faceforward(globals.a.xyz, globals.b.xyz, globals.c.xyz) + normalize(in_POSITION0.xyz) + reflect(globals.a.xyz, globals.b.xyz) + refract(globals.a.xyz, globals.b.xyz, 1.5);
// CHECK-NEXT:     gl_Position.x += distance(globals.a, globals.b) + dot(globals.a, globals.b) + length(globals.a) + globals.s * globals.t + float(dot_(globals.i, globals.i));
// CHECK-NEXT:     gl_Position += lit(globals.s, globals.t, 8.0) + dst(globals.a, globals.b) + vec4(ivec4(globals.a.zyxw * 255.00195));
// CHECK-NEXT:     gl_Position += vec4(ivec4(sign(globals.a)) * 2 + sign(globals.i) + abs(globals.i) + max(globals.i, 3) + clamp(globals.i, 0, 9) + int(sign(globals.s)));
// CHECK-NEXT:     vec4 sine;
// CHECK-NEXT:     vec4 cosine;
// CHECK-NEXT:     sincos(globals.a, sine, cosine);
// CHECK-NEXT:     gl_Position += sine + cosine;
// CHECK-NEXT:     vec4 whole;
// CHECK-NEXT:     gl_Position += modf(globals.a, whole) + whole;
// CHECK-NEXT:     ivec4 whole_int;
// CHECK-NEXT:     gl_Position += vec4(modf_(globals.i, whole_int) + whole_int);
// CHECK-NEXT:     float exponent;
// CHECK-NEXT:     gl_Position.x += frexp_(globals.s, exponent) + exponent;
// CHECK-NEXT:     vec2 exponents;
// CHECK-NEXT:     gl_Position.xy += frexp_(globals.a.xy, exponents) + exponents;
// CHECK-NEXT:     if (isnan(globals.s) || isinf(globals.s) || !isfinite(globals.s) || any(isnan(globals.a)) || all(isfinite(globals.a))) {
// CHECK-NEXT:         gl_Position = vec4(0.0);
// CHECK-NEXT:     }
// CHECK-NEXT: }
