// Derivatives: their sign along y, of expressions, in uniform branches, loops and functions, and next to discarded pixels.
// RUN: %draw compare %s -T ps_5_0 -E signs
// RUN: %draw compare %s -T ps_5_0 -E signs --target glsl120,glsl410,essl310
// RUN: %draw compare %s -T ps_5_0 -E expressions --target glsl450,essl300,vulkan --quarters
// RUN: %draw compare %s -T ps_5_0 -E flow --target glsl450,glsl330,vulkan --quarters
// RUN: %draw compare %s -T ps_5_0 -E beside_discarded
// RUN: %draw compare %s -T ps_5_0 -E position --target glsl450,glsl330,vulkan
cbuffer C { float4 scale; int count; };

float4 signs(float4 v : V) : SV_Target { return float4(ddx(v.x), ddy(v.y), fwidth(v.z), ddy_coarse(v.w) - ddx_fine(v.x)); }

float4 expressions(float4 v : V, float3 normal : NORMAL) : SV_Target {
  float3 across = cross(ddx(v.xyz), ddy(v.xyz));
  float2 second = ddx(ddy(v.xy * v.zw));
  return float4(dot(across, normal), second, ddy(abs(v.x)) + fwidth(max(v.y, v.z)));
}

float Change(float x) { return ddx(x) - ddy(x); }
float4 flow(float4 v : V) : SV_Target {
  float4 sum = Change(v.x) + 2 * Change(v.y);
  for (int i = 0; i < count; ++i) sum.xy += ddy(v.zw * v.x * i);
  if (scale.x > 0)
    sum.z += Change(v.x * v.y);
  else
    sum.z -= ddx(v.w);
  float high = v.x > 0 ? v.y * 2 : v.z;
  return sum + ddy(high);
}

float4 beside_discarded(float4 v : V) : SV_Target {
  float x = v.x * v.y;
  if (v.z > 0.25) discard;
  clip(v.w + 0.5);
  return float4(ddx(x), ddy(x), x, 1);
}

float4 position(float4 p : SV_Position, float2 v : V) : SV_Target { return float4(ddx(p.xy), ddy(p.xy)) * v.x; }
