// An object that a condition chooses is one particular object where the condition is a constant: of a local variable, a field, a
// parameter or a function that only returns it. Source: dxc's tests sel_sampler.hlsl, convergent_const_folding.hlsl, selects.hlsl.
// RUN: %clipc %s -T ps_6_0 -E ps --target=vulkan --validate -o - | FileCheck %s
// RUN: %draw compare %s -T ps_6_0 -E ps --target=glsl450
Texture2D first : register(t0);
SamplerState near : register(s0);
SamplerState far : register(s1);

struct Choice {
  bool is_near;
};
struct Pair {
  Texture2D a, b;
};

bool Always() { return true; }

float4 Take(float2 uv, bool is_near) {
  Choice choice;
  choice.is_near = is_near;
  // CHECK: return texture(sampler2D(first, far), uv);
  SamplerState chosen = choice.is_near ? near : far;
  return first.Sample(chosen, uv);
}

// CHECK: return texelFetch(first, place.xy, place.z);
float4 Either(uint which, int3 place, Pair pair) { return which ? pair.a.Load(place) : pair.b.Load(place); }

float4 ps(float2 uv : UV, int3 place : PLACE) : SV_Target {
  const bool is_far = !Always();
  Pair pair;
  pair.a = first;
  // CHECK: SV_Target0 = texture(sampler2D(first, near), vs_UV0) + Take(
  return first.Sample(is_far ? far : near, uv) + Take(uv, false) + Either(1, place & 1, pair);
}
