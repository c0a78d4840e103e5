// Functions that write their arguments: sincos becomes a helper function, frexp of a vector one call for each component; modf of floats stays.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-written-arguments --stop-after=lower-written-arguments %s | FileCheck %s
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float4 main(float4 p : POSITION) : SV_Position {
  float2 sine, cosine, exponent;
  sincos(p.xy, sine, cosine);
  float2 mantissa = frexp(p.zw, exponent);
  float whole;
  float rest = modf(p.x, whole);
  return float4(sine + cosine, mantissa + exponent) + rest + whole;
}
