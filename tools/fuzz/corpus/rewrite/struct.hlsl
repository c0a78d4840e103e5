//0041
cbuffer Clip { float4 plane, planes[3]; };
struct Varyings { float2 uv : TEXCOORD0; float4 position : SV_Position; };
[clipplanes(plane, planes[2], float4(planes[0].xyz, plane.w))]
Varyings main(float4 p : POSITION, uniform float scale = 1 + 1, nointerpolation float2 uv : TEXCOORD0) {
  Varyings o = {uv, p * scale};
  return o;
}
[clipplanes(planes[(1 + 0) * 1])] void second(float4 p : POSITION, out Varyings o) { o.uv = 0; o.position = p; }
