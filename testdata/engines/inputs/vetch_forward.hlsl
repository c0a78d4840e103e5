// HLSL 2021 in the style of engines of Direct3D 12.
#define ROOT_SIG "RootFlags(ALLOW_INPUT_ASSEMBLER_INPUT_LAYOUT), CBV(b0), DescriptorTable(SRV(t0, numDescriptors = 4))"
#define CONSTANTBUFFER(name, type, slot) ConstantBuffer<type> name : register(b##slot)
#define SLOT_FRAME 0
#define SLOT_OBJECT 1
namespace vetch {
enum class Shading : uint { Unlit, Lambert, Wrapped };
template<typename T> T Sq(T v) { return v * v; }
template<typename T> struct Range { T lo, hi; T Clamp(T v) { return clamp(v, lo, hi); } };
struct Ray { float3 o, d; float3 At(float t) { return o + d * t; } };
struct Color { float3 rgb; Color operator*(float s) { Color c; c.rgb = rgb * s; return c; } Color operator+(Color o) { Color c; c.rgb = rgb + o.rgb; return c; } };
static const float kEpsilon = 1e-4;
}
struct Frame { float4x4 viewProj; float3 eye; float time; vetch::Range<float> exposure; };
struct Object { row_major float3x4 world; float4 tint; uint shading; uint flags; };
CONSTANTBUFFER(g_Frame, Frame, 0);
CONSTANTBUFFER(g_Object, Object, 1);
Texture2D<float4> g_Albedo : register(t0);
Texture2DArray g_Layers : register(t1);
SamplerState g_Sampler : register(s0);
struct VertexIn { float3 position : POSITION; float3 normal : NORMAL; float2 uv : TEXCOORD; };
struct Interp { float4 position : SV_Position; float3 world : WORLD; float3 normal : NORMAL; float2 uv : TEXCOORD; nointerpolation uint id : OBJECT_ID; };
[RootSignature(ROOT_SIG)]
Interp VSMain(VertexIn v, uint id : SV_InstanceID) {
  Interp o = (Interp)0;
  o.world = mul(g_Object.world, float4(v.position, 1));
#if WIND
  o.world.x += sin(g_Frame.time + vetch::Sq(o.world.y)) * 0.1;
#endif
  o.position = mul(g_Frame.viewProj, float4(o.world, 1));
  o.normal = mul((float3x3)g_Object.world, v.normal);
  o.uv = v.uv;
  o.id = id;
  return o;
}
float4 VSDepth(VertexIn v) : SV_Position { return mul(g_Frame.viewProj, float4(mul(g_Object.world, float4(v.position, 1)), 1)); }
[RootSignature(ROOT_SIG)]
float4 PSMain(Interp i) : SV_Target {
  vetch::Ray ray = { g_Frame.eye, normalize(i.world - g_Frame.eye) };
  vetch::Color c;
  c.rgb = g_Albedo.Sample(g_Sampler, i.uv).rgb;
#if LAYERED
  vetch::Color detail = { g_Layers.Sample(g_Sampler, float3(i.uv, i.id)).rgb };
  c = c + detail * 0.5;
#endif
  float n = dot(normalize(i.normal), -ray.d);
  switch ((vetch::Shading)g_Object.shading) {
    case vetch::Shading::Lambert: n = saturate(n); break;
    case vetch::Shading::Wrapped: n = vetch::Sq(n * .5 + .5); break;
    default: n = 1; break;
  }
  c = c * g_Frame.exposure.Clamp(n + vetch::kEpsilon);
  return select(g_Object.flags != 0, float4(ray.At(1), 1), float4(c.rgb, 1) * g_Object.tint);
}
