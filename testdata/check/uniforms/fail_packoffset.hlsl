// RUN: not %clipc -T vs_5_0 %s -o - 2>&1 | FileCheck %s
// A packoffset inside a register leaves no room across its end.
cbuffer B {
  float4 whole : packoffset(c0);
  float3 fits : packoffset(c1.y);
  // CHECK: fail_packoffset.hlsl:[[#@LINE+1]]:19: error: `across` of type `float2` does not fit at `c4.w`; a scalar or vector lies within one register, everything else starts a register [pack-offset-misfit, X3530]
  float2 across : packoffset(c4.w);
  // CHECK: :[[#@LINE+1]]:20: error: `shifted` of type `float4` does not fit at `c5.y`
  float4 shifted : packoffset(c5.y);
  // CHECK: :[[#@LINE+1]]:22: error: `matrix_` of type `float2x2` does not fit at `c6.z`
  float2x2 matrix_ : packoffset(c6.z);
  // CHECK: :[[#@LINE+1]]:20: error: `array` of type `float[2]` does not fit at `c8.y`
  float array[2] : packoffset(c8.y);
  // CHECK: :[[#@LINE+1]]:17: error: `wide` of type `double` does not fit at `c10.y`
  double wide : packoffset(c10.y);
};
float4 main(float4 v : POSITION) : SV_Position {
  return v + whole + fits.xyzz + across.xyxy + shifted + matrix_[0].xyxy + array[1] + (float)wide;
}
