#define fixed half
#define fixed3 half3
#define fixed4 half4
#if defined(KESTREL_D3D11)
#define KESTREL_DECLARE_TEX2D(tex) Texture2D tex; SamplerState sampler##tex
#define KESTREL_SAMPLE_TEX2D(tex, coord) tex.Sample(sampler##tex, coord)
#define COLOR_OUT SV_Target
#define POSITION_OUT SV_POSITION
#else
#define KESTREL_DECLARE_TEX2D(tex) sampler2D tex
#define KESTREL_SAMPLE_TEX2D(tex, coord) tex2D(tex, coord)
#define COLOR_OUT COLOR
#define POSITION_OUT POSITION
#endif
#define KESTREL_FOG_COORDS_PACKED(idx, vectype) vectype fogCoord : TEXCOORD##idx;
#define KESTREL_FOG_COORDS(idx) KESTREL_FOG_COORDS_PACKED(idx, float1)
#define INSTANCE_PROP(arr, var) arr[0].var
uniform float4x4 glstate_matrix_mvp;
uniform float4x4 kestrel_WorldToObject;
uniform float4 kestrel_LightPosition[4];
uniform half4 kestrel_LightColor[4];
uniform fixed4 glstate_lightmodel_ambient;
KESTREL_DECLARE_TEX2D(_MainTex);
uniform float4 _MainTex_ST;
struct appdata_base { float4 vertex : POSITION; float3 normal : NORMAL; float4 texcoord : TEXCOORD0; };
struct v2f { float4 pos : POSITION_OUT; half2 uv : TEXCOORD0; KESTREL_FOG_COORDS(1) fixed3 vlight : COLOR0; };
inline float3 ShadeLights(float3 p, float3 n) {
  float3 lightColor = glstate_lightmodel_ambient.xyz;
  for (int i = 0; i < LIGHTS; i++) {
    float3 toLight = kestrel_LightPosition[i].xyz - p * kestrel_LightPosition[i].w;
    float lengthSq = max(dot(toLight, toLight), 0.000001);
    toLight *= rsqrt(lengthSq);
    lightColor += kestrel_LightColor[i].rgb * max(0, dot(n, toLight)) / (1.0 + lengthSq);
  }
  return lightColor;
}
v2f vert(appdata_base v) {
  v2f o;
  o.pos = mul(glstate_matrix_mvp, v.vertex);
  o.uv = v.texcoord.xy * _MainTex_ST.xy + _MainTex_ST.zw;
  o.fogCoord = o.pos.z;
  o.vlight = ShadeLights(v.vertex.xyz, normalize(mul(v.normal, (float3x3)kestrel_WorldToObject)));
  return o;
}
fixed4 frag(v2f i) : COLOR_OUT {
  fixed4 c = KESTREL_SAMPLE_TEX2D(_MainTex, i.uv);
  c.rgb *= i.vlight;
  c.rgb = lerp(c.rgb, glstate_lightmodel_ambient.rgb, saturate(i.fogCoord));
  return c;
}
