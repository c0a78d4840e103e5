// What glslang's HLSL front end gets wrong (docs/reference-compilers.md), one entry point for each. The values are compared all the same: with
// what the bug makes of the shader, and for the last ones, which move constants, with the constants where the reference compiler reads them.
// reference_compiler_test.cpp says which bug explains which.

float4 main(float4 p : P, out float4 lit_ : O) : SV_Position { return lit_ = p; }

float4 lights(float4 p : P) : SV_Position { return lit(p.x, p.y, p.z); }

float4 remainders(float4 p : P) : SV_Position { return p % p.yzwx + fmod(p, 0.75); }

float3x3 left, right;
float4 products(float4 p : P) : SV_Position { return float4(mul(p.xyz, left * right), 1); }

const int which = 2;
float4 initial(float4 p : P) : SV_Position { return which == 2 ? p : -p; }

cbuffer Planes {
  float4 plane;
};

struct Element {
  float3 a;
  float2 b;
};
StructuredBuffer<Element> buffer;
float4 elements(float4 p : P, uint i : I) : SV_Position { return p * buffer[i].a.z + buffer[i].b.y; }

float4 views(float4 p : P, uint view : SV_ViewID) : SV_Position { return p + view; }

float4 parameters(float4 p : P, uniform float4 q) : SV_Position { return p * q; }

float4 unsized(float4 p : P, uint i : I) : SV_Position {
  float2 pairs[] = {float2(1, 2), 3, 4};
  return p * pairs[i & 1].xyxy;
}

cbuffer Packed {
  float3x2 before;
  float after;
};
float4 packed(float4 p : P) : SV_Position { return p * after; }

float number;
float3 beside;
float4 globals(float4 p : P) : SV_Position { return p * number + beside.xyzz; }

float4 columns(float4 p : P, float4x4 world : WORLD) : SV_Position { return mul(p, world); }

[clipplanes(plane)]
float4 clipped(float4 p : P) : SV_Position { return p; }

#ifdef PLACES
float loose;
float4 first : register(c0);
#else
float4 first;
float loose;
#endif
float4 placed(float4 p : P) : SV_Position { return p * first + loose; }

#ifdef SCALES  // the reference compiler makes invalid SPIR-V of it
float4 scales(float4 p : P) : SV_Position { return ldexp(p, p.yzwx); }
#endif
