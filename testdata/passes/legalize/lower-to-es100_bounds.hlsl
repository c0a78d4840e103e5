// An index that is out of bounds once it is known becomes that of the last element: GLSL refuses it (DXC's HLSLFileCheck, CbufferLegacy/vector_subscript_error.hlsl).
// RUN: %clipc -T ps_6_0 --target=essl100 --validate %s -o - | FileCheck %s

cbuffer C {
  float2 foo;
}

float4 main() : SV_Target {
  float4 r = 0;
  uint i = 2;
  // CHECK: SV_Target0 += foo().y;
  if (i < 10) r += foo[i];
  return r;
}
