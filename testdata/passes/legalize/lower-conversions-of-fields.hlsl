// A field that only the declaration of its variable gives a value has the bounds of that value: the place of a pixel fits into an
// integer also where the struct is passed on as a whole. A field that is written later, and a component of another kind, may be
// anything.
// RUN: %clipc -T ps_5_0 --verify --dump-after=lower-conversions --stop-after=lower-conversions %s | FileCheck %s
// RUN: %draw compare %s -T ps_5_0
// AUTOUPDATE
struct Input {
  float4 place : SV_Position;
  float2 uv : TEXCOORD;
};

float Whole(Input input) { return input.place.y + input.uv.x; }

float4 main(Input input) : SV_Target {
  input.uv *= 2;
  Input moved = input;
  moved.place.x += 0.5;
  int2 kept = floor(input.place.yx);
  int depth = input.place.z * 64;
  int2 written = input.uv * 64;
  int2 partly = moved.place.xy;
  return float4(kept % 4 + written, partly + depth) / 256 + (Whole(input) + Whole(moved)) / 4096;
}

// CHECK: program ps_5_0 form inlined
// CHECK-NEXT: struct Input {
// CHECK-NEXT:   float4 place : SV_Position
// CHECK-NEXT:   float2 uv : TEXCOORD
// CHECK-NEXT: }
// CHECK-NEXT: input float4 in_SV_POSITION0 : SV_Position0 builtin pixel_position
// CHECK-NEXT: input float2 in_TEXCOORD0 : TEXCOORD0 location 0
// CHECK-NEXT: output float4 ps_SV_TARGET0 : SV_Target0 location 0
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: float Whole(Input input.1) {
// CHECK-NEXT:   return input.1.place.y + input.1.uv.x
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   Input input.2 = Input{in_SV_POSITION0, in_TEXCOORD0}
// CHECK-NEXT:   input.2.uv *= splat<float2>(2.0)
// CHECK-NEXT:   Input moved = input.2
// CHECK-NEXT:   moved.place.x += 0.5
// CHECK-NEXT:   int2 kept = convert<int2>(floor(input.2.place.yx))
// CHECK-NEXT:   int depth = to_int(input.2.place.z * 64.0)
// CHECK-NEXT:   int2 written = to_int.1(input.2.uv * splat<float2>(64.0))
// CHECK-NEXT:   int2 partly = to_int.1(moved.place.xy)
// CHECK-NEXT:   ps_SV_TARGET0 = (float4(convert<float2>((kept % splat<int2>(4)) + written), convert<float2>(partly + splat<int2>(depth))) / splat<float4>(256.0)) + splat<float4>((Whole(input.2) + Whole(moved)) / 4096.0)
// CHECK-NEXT: }
// CHECK-NEXT: helper int to_int(float x) {
// CHECK-NEXT:   return (x < 2147483648.0) ? convert<int>(max(-2147483648.0, x)) : ((x > 0.0) ? 2147483647 : zero<int>)
// CHECK-NEXT: }
// CHECK-NEXT: helper int2 to_int.1(float2 a) {
// CHECK-NEXT:   return int2(to_int(a.x), to_int(a.y))
// CHECK-NEXT: }
