// && and || evaluate both sides, as HLSL before 2021 does: where that can be seen it is kept. Vectors by component.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o - | FileCheck %s --check-prefix=GL120
// AUTOUPDATE
float4 a, b;
bool4 flags;
static int calls = 0;
bool Pure(float x) { float y = x * 2; return y > 1; }
bool Impure(float x) { calls++; return x > 1; }

float4 main(float4 p : POSITION) : SV_Position {
  bool r = a.x > 0 && b.x > 0 || !flags.x;
  r = r && Pure(a.x);
  r = r && Impure(a.x);
  r = Impure(a.x) || r;
  r = r || Impure(a.x);
  r = (r || flags.x) && (flags.y || flags.z);
  bool4 v = a < b && flags || !flags;
  bool4 w = (a == b) != flags;
  float4 s = v ? a : b;
  s = a > 0 ? 1 : b;
  s += r ? a : b;
  int4 i = w ? 1 : (int4)a;
  bool4 c = flags ? v : w;
  return s + i + c + (r ? 1 : 2) + any(v) + all(a) + any(a.x) + calls + (r = !r) ;
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// CHECK-NEXT:     vec4 a;
// CHECK-NEXT:     vec4 b;
// CHECK-NEXT:     uvec4 flags;
// CHECK-NEXT: } globals;
// CHECK-EMPTY:
// CHECK-NEXT: bvec4 logical_and(bvec4 a, bvec4 b) {
// CHECK-NEXT:     return bvec4(a.x && b.x, a.y && b.y, a.z && b.z, a.w && b.w);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bvec4 logical_or(bvec4 a, bvec4 b) {
// CHECK-NEXT:     return bvec4(a.x || b.x, a.y || b.y, a.z || b.z, a.w || b.w);
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int to_int(float x) {
// CHECK-NEXT:     return x < 2147483648.0 ? int(max(-2147483648.0, x)) : x > 0.0 ? 2147483647 : 0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: ivec4 to_int(vec4 a) {
// CHECK-NEXT:     return ivec4(to_int(a.x), to_int(a.y), to_int(a.z), to_int(a.w));
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: int calls = 0;
// CHECK-EMPTY:
// CHECK-NEXT: bool Pure(float x) {
// CHECK-NEXT:     float y = x * 2.0;
// CHECK-NEXT:     return y > 1.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: bool Impure(float x) {
// CHECK-NEXT:     calls++;
// CHECK-NEXT:     return x > 1.0;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     bool r = globals.a.x > 0.0 && globals.b.x > 0.0 || !bvec4(globals.flags).x;
// CHECK-NEXT:     r = r && Pure(globals.a.x);
// CHECK-NEXT:     r = all(bvec2(r, Impure(globals.a.x)));
// CHECK-NEXT:     r = Impure(globals.a.x) || r;
// CHECK-NEXT:     r = any(bvec2(r, Impure(globals.a.x)));
// CHECK-NEXT:     r = (r || bvec4(globals.flags).x) && (bvec4(globals.flags).y || bvec4(globals.flags).z);
// CHECK-NEXT:     bvec4 v = logical_or(logical_and(lessThan(globals.a, globals.b), bvec4(globals.flags)), not(bvec4(globals.flags)));
// CHECK-NEXT:     bvec4 w = notEqual(equal(globals.a, globals.b), bvec4(globals.flags));
// CHECK-NEXT:     vec4 s = mix(globals.b, globals.a, v);
// CHECK-NEXT:     s = mix(globals.b, vec4(1.0), greaterThan(globals.a, vec4(0.0)));
// CHECK-NEXT:     s += r ? globals.a : globals.b;
// CHECK-NEXT:     ivec4 i = mix(to_int(globals.a), ivec4(1), w);
// CHECK-NEXT:     bvec4 c = mix(w, v, bvec4(globals.flags));
// CHECK-NEXT:     bool old_r = r;
// CHECK-NEXT:     gl_Position = s + vec4(i) + vec4(c) + float(old_r ? 1 : 2) + float(any(v)) + float(all(notEqual(globals.a, vec4(0.0)))) + float(bool(globals.a.x)) + float(calls) + float(r = !r);
// CHECK-NEXT: }

// GL120: #version 120
// GL120-EMPTY:
// GL120-NEXT: // $Globals, b0
// GL120-NEXT: uniform vec4 a;
// GL120-NEXT: uniform vec4 b;
// GL120-NEXT: uniform bvec4 flags;
// GL120-EMPTY:
// GL120-NEXT: bvec4 logical_and(bvec4 a, bvec4 b) {
// GL120-NEXT:     return bvec4(a.x && b.x, a.y && b.y, a.z && b.z, a.w && b.w);
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: bvec4 logical_or(bvec4 a, bvec4 b) {
// GL120-NEXT:     return bvec4(a.x || b.x, a.y || b.y, a.z || b.z, a.w || b.w);
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: vec4 select(bvec4 a, vec4 b, vec4 c) {
// GL120-NEXT:     return vec4(a.x ? b.x : c.x, a.y ? b.y : c.y, a.z ? b.z : c.z, a.w ? b.w : c.w);
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: int to_int(float x) {
// GL120-NEXT:     return x < 2147483648.0 ? int(max(-2147483648.0, x)) : x > 0.0 ? 2147483647 : 0;
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: ivec4 to_int(vec4 a) {
// GL120-NEXT:     return ivec4(to_int(a.x), to_int(a.y), to_int(a.z), to_int(a.w));
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: ivec4 select(bvec4 a, ivec4 b, ivec4 c) {
// GL120-NEXT:     return ivec4(a.x ? b.x : c.x, a.y ? b.y : c.y, a.z ? b.z : c.z, a.w ? b.w : c.w);
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: bvec4 select(bvec4 a, bvec4 b, bvec4 c) {
// GL120-NEXT:     return bvec4(a.x ? b.x : c.x, a.y ? b.y : c.y, a.z ? b.z : c.z, a.w ? b.w : c.w);
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: int calls = 0;
// GL120-EMPTY:
// GL120-NEXT: bool Pure(float x) {
// GL120-NEXT:     float y = x * 2.0;
// GL120-NEXT:     return y > 1.0;
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: bool Impure(float x) {
// GL120-NEXT:     calls++;
// GL120-NEXT:     return x > 1.0;
// GL120-NEXT: }
// GL120-EMPTY:
// GL120-NEXT: void main() {
// GL120-NEXT:     bool r = a.x > 0.0 && b.x > 0.0 || !flags.x;
// GL120-NEXT:     r = r && Pure(a.x);
// GL120-NEXT:     r = all(bvec2(r, Impure(a.x)));
// GL120-NEXT:     r = Impure(a.x) || r;
// GL120-NEXT:     r = any(bvec2(r, Impure(a.x)));
// GL120-NEXT:     r = (r || flags.x) && (flags.y || flags.z);
// GL120-NEXT:     bvec4 v = logical_or(logical_and(lessThan(a, b), flags), not(flags));
// GL120-NEXT:     bvec4 w = notEqual(equal(a, b), flags);
// GL120-NEXT:     vec4 s = select(v, a, b);
// GL120-NEXT:     s = select(greaterThan(a, vec4(0.0)), vec4(1.0), b);
// GL120-NEXT:     s += r ? a : b;
// GL120-NEXT:     ivec4 i = select(w, ivec4(1), to_int(a));
// GL120-NEXT:     bvec4 c = select(flags, v, w);
// GL120-NEXT:     bool old_r = r;
// GL120-NEXT:     gl_Position = s + vec4(i) + vec4(c) + float(old_r ? 1 : 2) + float(any(v)) + float(all(notEqual(a, vec4(0.0)))) + float(bool(a.x)) + float(calls) + float(r = !r);
// GL120-NEXT: }
