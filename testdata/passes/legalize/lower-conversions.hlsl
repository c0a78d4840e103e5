// A float becomes an integer by a helper function, which saturates, unless the value is known to fit, or nothing but an index
// comes of it: an int may be one that is out of every array, a uint is 0 at the least.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-conversions --stop-after=lower-conversions %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float4 bones[8];
static const float kScale = 255;
static const int kFits = kScale * 2, kTooLarge = kScale * 1e9;

float4 main(float4 p : POSITION, float2 i : INDEX) : SV_Position {
  int any = p.x;
  uint2 positive = p.xy;
  uint byte = kScale + 0.5;
  int4 places = int4(saturate(i.xyxy) * 4);
  uint place = saturate(i.x) - 0.5;
  uint4 packed = uint4(round(saturate(i.xyxy) * 255)) << uint4(0, 8, 16, 24);
  int2 between = i.x > 0 ? -saturate(p.xy) * 3 + 1.5 : 2;
  int far = saturate(i.y) * 2147483520.0 + 100, near = saturate(i.y) * 2147483392.0;
  uint below = saturate(i.y) - 0.5, unknown = frac(i.y) * 4;
  uint2 clamped = clamp(i, 0, kScale), bounded = min(9, max(p.xy, 0)), open = max(p.xy, 0);
  int stepped = step(i.x, p.x) * 3, over = max(min(p.x, 2147483520.0), -2147483648.0), beyond = min(max(p.x, 0), 3e9);
  float scale = 255, turned = frac(p.x) * scale, varied = 3;
  if (p.x > 3) varied = 1e30;
  int hue = turned, wide = varied, angle = fmod(clamp(p.x, 0, 7000), 64.0), middle = positive.x * 0.25, low = (places.x & 15) * 2e8;
  [loop] for (int n = 7; n >= 0; n -= 2) hue += (int)(n * 2.5e8);
  [loop] for (uint m = 0; m < 9; ++m) hue += (int)(m / 1e-37), middle += (int)(m / 1e-8);
  float4 sum = bones[places.x + 1] + bones[place] + (clamped + bounded + open).xyxy + stepped + over + beyond + hue + wide + angle + middle + low;
  return sum + any + positive.x + packed + between.xyxy + far + near + below + unknown + byte + kFits + kTooLarge;
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: globals $Globals : b0, 128 bytes {
// CHECK-NEXT:   float4 bones[8] at 0, 128 bytes
// CHECK-NEXT: }
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: input float2 in_INDEX0 : INDEX0 location 1
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: const float kScale = 255.0
// CHECK-NEXT: const int kFits = convert<int>(kScale * 2.0)
// CHECK-NEXT: const int kTooLarge = 2147483647
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   int any = to_int(in_POSITION0.x)
// CHECK-NEXT:   uint2 positive = to_uint(in_POSITION0.xy)
// CHECK-NEXT:   uint byte = convert<uint>(kScale + 0.5)
// CHECK-NEXT:   int4 places = convert<int4>(saturate(in_INDEX0.xyxy) * splat<float4>(4.0))
// CHECK-NEXT:   uint place = convert<uint>(max(0.0, saturate(in_INDEX0.x) - 0.5))
// CHECK-NEXT:   uint4 packed = convert<uint4>(round(saturate(in_INDEX0.xyxy) * splat<float4>(255.0))) << uint4(0u, 8u, 16u, 24u)
// CHECK-NEXT:   int2 between = convert<int2>((in_INDEX0.x > 0.0) ? (((-saturate(in_POSITION0.xy)) * splat<float2>(3.0)) + splat<float2>(1.5)) : splat<float2>(2.0))
// CHECK-NEXT:   int far = to_int((saturate(in_INDEX0.y) * 2147483520.0) + 100.0)
// CHECK-NEXT:   int near = convert<int>(saturate(in_INDEX0.y) * 2147483392.0)
// CHECK-NEXT:   uint below = to_uint.1(saturate(in_INDEX0.y) - 0.5)
// CHECK-NEXT:   uint unknown = convert<uint>(max(0.0, frac(in_INDEX0.y) * 4.0))
// CHECK-NEXT:   uint2 clamped = convert<uint2>(clamp(in_INDEX0, splat<float2>(0.0), splat<float2>(kScale)))
// CHECK-NEXT:   uint2 bounded = convert<uint2>(min(splat<float2>(9.0), max(in_POSITION0.xy, splat<float2>(0.0))))
// CHECK-NEXT:   uint2 open = to_uint(max(in_POSITION0.xy, splat<float2>(0.0)))
// CHECK-NEXT:   int stepped = convert<int>(step(in_INDEX0.x, in_POSITION0.x) * 3.0)
// CHECK-NEXT:   int over = convert<int>(max(min(in_POSITION0.x, 2147483520.0), -2147483648.0))
// CHECK-NEXT:   int beyond = to_int(min(max(in_POSITION0.x, 0.0), 3e+09))
// CHECK-NEXT:   float scale = 255.0
// CHECK-NEXT:   float turned = frac(in_POSITION0.x) * scale
// CHECK-NEXT:   float varied = 3.0
// CHECK-NEXT:   if (in_POSITION0.x > 3.0) {
// CHECK-NEXT:     varied = 1e+30
// CHECK-NEXT:   }
// CHECK-NEXT:   int hue = convert<int>(max(0.0, turned))
// CHECK-NEXT:   int wide = to_int(varied)
// CHECK-NEXT:   int angle = convert<int>(fmod(clamp(in_POSITION0.x, 0.0, 7000.0), 64.0))
// CHECK-NEXT:   int middle = convert<int>(convert<float>(positive.x) * 0.25)
// CHECK-NEXT:   int low = convert<int>(convert<float>(places.x & 15) * 2e+08)
// CHECK-NEXT:   for (int n = 7; n >= 0; n -= 2) {
// CHECK-NEXT:     hue += convert<int>(convert<float>(n) * 2.5e+08)
// CHECK-NEXT:   }
// CHECK-NEXT:   for (uint m = 0u; m < 9u; ++m) {
// CHECK-NEXT:     hue += to_int(convert<float>(m) / 1e-37)
// CHECK-NEXT:     middle += convert<int>(convert<float>(m) / 1e-08)
// CHECK-NEXT:   }
// CHECK-NEXT:   float4 sum = (((((((((bones[places.x + 1] + bones[place]) + convert<float4>(((clamped + bounded) + open).xyxy)) + splat<float4>(convert<float>(stepped))) + splat<float4>(convert<float>(over))) + splat<float4>(convert<float>(beyond))) + splat<float4>(convert<float>(hue))) + splat<float4>(convert<float>(wide))) + splat<float4>(convert<float>(angle))) + splat<float4>(convert<float>(middle))) + splat<float4>(convert<float>(low))
// CHECK-NEXT:   vs_SV_POSITION0 = ((((((((((sum + splat<float4>(convert<float>(any))) + splat<float4>(convert<float>(positive.x))) + convert<float4>(packed)) + convert<float4>(between.xyxy)) + splat<float4>(convert<float>(far))) + splat<float4>(convert<float>(near))) + splat<float4>(convert<float>(below))) + splat<float4>(convert<float>(unknown))) + splat<float4>(convert<float>(byte))) + splat<float4>(convert<float>(kFits))) + splat<float4>(convert<float>(kTooLarge))
// CHECK-NEXT: }
// CHECK-NEXT: helper int to_int(float x) {
// CHECK-NEXT:   return (x < 2147483648.0) ? convert<int>(max(-2147483648.0, x)) : ((x > 0.0) ? 2147483647 : zero<int>)
// CHECK-NEXT: }
// CHECK-NEXT: helper uint2 to_uint(float2 a) {
// CHECK-NEXT:   return uint2(to_uint.1(a.x), to_uint.1(a.y))
// CHECK-NEXT: }
// CHECK-NEXT: helper uint to_uint.1(float x.1) {
// CHECK-NEXT:   return (x.1 >= 4294967296.0) ? 4294967295u : convert<uint>(max(0.0, x.1))
// CHECK-NEXT: }
