// What the rasterizer gives a pixel shader: the position with Direct3D's origin and w, faces, flat inputs, integers, and the modifiers
// of interpolation.
// RUN: %draw compare %s -T ps_5_0 -E position --target glsl450,glsl330,glsl150,vulkan
// RUN: %draw compare %s -T ps_5_0 -E position_without_y --target glsl120,essl300,essl100
// RUN: %draw compare %s -T ps_3_0 -E position9 --target glsl450,vulkan
// RUN: %draw compare %s -T ps_5_0 -E faces
// RUN: %draw compare %s -T ps_5_0 -E samples --target glsl450,glsl410,essl320,vulkan
// RUN: %draw compare %s -T ps_5_0 -E flat
// RUN: %draw compare %s -T ps_5_0 -E structs --target glsl450,glsl130,vulkan
// RUN: %draw compare %s -T ps_5_0 -E modifiers --perspective --target glsl450,glsl130,vulkan
float4 position(float4 p : SV_Position) : SV_Target { return float4(p.y, p.x * p.w, p.z / p.w, p.w) + p.zzzz; }
float4 position_without_y(float4 p : SV_Position) : SV_Target { return p.xzwx / p.w; }
float4 position9(float2 pixel : VPOS, float face : VFACE, float2 uv : TEXCOORD0) : COLOR {
  return float4(pixel, face, face > 0 ? uv.x : uv.y);
}
float4 faces(bool front : SV_IsFrontFace, float4 a : A, float4 b : B) : SV_Target { return front ? a : -b; }
uint4 samples(uint number : SV_SampleIndex, uint covered : SV_Coverage, uint primitive : SV_PrimitiveID) : SV_Target {
  return uint4(number, covered, primitive, primitive % 3);
}

struct Flat {
  nointerpolation float4 a : A;
  int2 b : B;
  nointerpolation uint3 c : C;
  linear float d : D;
};
struct Numbers {
  int4 numbers : SV_Target1;
  float4 color : SV_Target0;
  uint2 bits : SV_Target2;
};
Numbers flat(Flat f) {
  Numbers n;
  n.color = f.a + f.d;
  n.numbers = int4(f.b, f.b.x * f.b.y, -1);
  n.bits = f.c.xy ^ f.c.z;
  return n;
}

struct Inner {
  float3x2 basis : BASIS;
  centroid float2 uv[2] : UV;
};
struct Outer {
  float4 position : SV_Position;
  Inner inner;
  noperspective float e : E;
};
float4 structs(Outer o) : SV_Target {
  return float4(mul(float3(o.inner.uv[0], o.e), o.inner.basis), mul(o.inner.basis, o.inner.uv[1]).yz);
}

float4 modifiers(linear float2 a : A, noperspective float2 b : B, nointerpolation float c : C, float4 p : SV_Position) : SV_Target {
  return float4(a, b) + c + p.w;
}
