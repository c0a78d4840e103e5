#define CONST(name, n) uniform float4 name : register(c##n)
CONST(rpScreenCorrectionFactor, 0);
CONST(rpMVPmatrixX, 11);
CONST(rpMVPmatrixY, 12);
CONST(rpMVPmatrixZ, 13);
CONST(rpMVPmatrixW, 14);
CONST(rpTexGen0Enabled, 28);
uniform float4 matrices_ubo[64] : register(c128);
uniform sampler2D samp0 : register(s0);
uniform sampler2D samp1 : register(s1);
static float dot4(float4 a, float4 b) { return dot(a, b); }
static float dot4(float2 a, float4 b) { return dot(float4(a, 0, 1), b); }
static half4 idtex2Dproj(sampler2D samp, float4 t) { return tex2Dproj(samp, t.xyww); }
static float4 swizzleColor(float4 c) { return c; }
struct VS_IN { float4 position : POSITION; float2 texcoord : TEXCOORD0; float4 normal : NORMAL; float4 tangent : TANGENT; float4 color : COLOR0; float4 color2 : COLOR1; };
struct VS_OUT { float4 position : POSITION; float4 texcoord0 : TEXCOORD0; float4 color : COLOR0; };
struct PS_OUT { float4 color : COLOR; };
void main(VS_IN vertex, out VS_OUT result) {
#if USE_GPU_SKINNING
  const float w0 = vertex.color2.x;
  const float w1 = vertex.color2.y;
  float4 matX = matrices_ubo[int(vertex.color.x * 255.1 * 3) + 0] * w0 + matrices_ubo[int(vertex.color.y * 255.1 * 3)] * w1;
  float4 modelPosition;
  modelPosition.x = dot4(matX, vertex.position);
  modelPosition.yzw = vertex.position.yzw;
#else
  float4 modelPosition = vertex.position;
#endif
  result.position.x = dot4(modelPosition, rpMVPmatrixX);
  result.position.y = dot4(modelPosition, rpMVPmatrixY);
  result.position.z = dot4(modelPosition, rpMVPmatrixZ);
  result.position.w = dot4(modelPosition, rpMVPmatrixW);
  if (rpTexGen0Enabled.x > 0.0) {
    result.texcoord0 = modelPosition;
  } else {
    result.texcoord0 = vertex.texcoord.xyxy;
  }
  result.color = swizzleColor(vertex.color);
}
void fragment(VS_OUT fragment, out PS_OUT result) {
  float4 c = idtex2Dproj(samp0, fragment.texcoord0) * fragment.color;
#ifdef ALPHA_TEST
  clip(c.a - rpScreenCorrectionFactor.w);
#endif
  result.color = c + tex2D(samp1, fragment.texcoord0.zw) * rpScreenCorrectionFactor;
}
