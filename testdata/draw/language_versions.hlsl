// The rules of the language's versions, from shader model 6 on: before HLSL 2021 both sides of `&&`
// and `?:` are evaluated, and before HLSL 2018 a Store of a byte address buffer converts to uint.
// RUN: %draw compare %s -T vs_6_0 -HV 2016 --target vulkan,glsl450 --lower none
// RUN: %draw compare %s -T vs_6_0 -HV 2018 --target vulkan,glsl450 --lower none
// RUN: %draw compare %s -T vs_6_0 --target vulkan,glsl450 --lower none
// RUN: %clipc -T vs_6_0 -HV 2016 %s -o - | FileCheck %s --check-prefixes=BOTH,UINT
// RUN: %clipc -T vs_6_0 -HV 2018 %s -o - | FileCheck %s --check-prefixes=BOTH,BITS
// RUN: %clipc -T vs_6_0 %s -o - | FileCheck %s --check-prefixes=ONE,BITS
RWByteAddressBuffer written;
static float calls = 0;
float count(float x) {
  calls += 1;
  return x;
}

float4 main(float4 v : POSITION) : SV_Position {
  // BOTH: bool temporary = in_POSITION0.x > 0.0;
  // BOTH-NEXT: float temporary_2 = count(in_POSITION0.y);
  // BOTH-NEXT: float chosen = temporary ? temporary_2 : in_POSITION0.z;
  // BOTH-NEXT: bool both = all(bvec2(in_POSITION0.y > 0.0, count(in_POSITION0.z) > 0.0));
  // ONE: float chosen = in_POSITION0.x > 0.0 ? count(in_POSITION0.y) : in_POSITION0.z;
  // ONE-NEXT: bool both = in_POSITION0.y > 0.0 && count(in_POSITION0.z) > 0.0;
  // UINT: written_store(0u, uint(chosen * chosen));
  // BITS: written_store(0u, floatBitsToUint(chosen * chosen));
  const float chosen = v.x > 0 ? count(v.y) : v.z;
  const bool both = v.y > 0 && count(v.z) > 0;
  written.Store(0, chosen * chosen);
  return float4(chosen, both, calls, written.Load(0) & 0xffff);
}
