// Functions that write their arguments: sincos becomes a helper function, frexp of a vector one call for each component; modf of floats stays.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-written-arguments --stop-after=lower-written-arguments %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target glsl450,glsl330,essl300,vulkan
// AUTOUPDATE
float4 main(float4 p : POSITION) : SV_Position {
  float2 sine, cosine, exponent;
  sincos(p.xy, sine, cosine);
  float2 mantissa = frexp(p.zw, exponent);
  float whole;
  float rest = modf(p.x, whole);
  return float4(sine + cosine, mantissa + exponent) + rest + whole;
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float2 sine
// CHECK-NEXT:   float2 cosine
// CHECK-NEXT:   float2 exponent
// CHECK-NEXT:   sincos(in_POSITION0.xy, sine, cosine)
// CHECK-NEXT:   float2 mantissa = frexp(in_POSITION0.zw, exponent)
// CHECK-NEXT:   float whole
// CHECK-NEXT:   float rest = modf(in_POSITION0.x, whole)
// CHECK-NEXT:   vs_SV_POSITION0 = (float4(sine + cosine, mantissa + exponent) + splat<float4>(rest)) + splat<float4>(whole)
// CHECK-NEXT: }
// CHECK-NEXT: helper void sincos(float2 x, out float2 s, out float2 c) {
// CHECK-NEXT:   s = sin(x)
// CHECK-NEXT:   c = cos(x)
// CHECK-NEXT: }
// CHECK-NEXT: helper float2 frexp(float2 a, out float2 b) {
// CHECK-NEXT:   return float2(frexp(a[0u], b[0u]), frexp(a[1u], b[1u]))
// CHECK-NEXT: }
