// The shader of own_listing_9.asm, which tests run_listings.py.
float2 shift;
float4 tint;
int count;
float3x3 turn;
bool bright;
sampler2D picture;
samplerCUBE sky;

void main(float2 uv : TEXCOORD0, float3 n : TEXCOORD1, float4 color : COLOR0, float2 at : VPOS,
          float face : VFACE, out float4 first : COLOR0, out float4 second : COLOR1,
          out float depth : DEPTH) {
  float3 unit = normalize(n);
  float4 sum = 0;
  for (int i = 0; i < 6; ++i) {
    if (i >= count) break;
    sum += tex2Dlod(picture, float4((i + 1) * uv, 0, 1));
  }
  if (unit.x < shift.y) {
    sum = lerp(sum, tint, unit.z);
  } else {
    sum.xy = float2(pow(abs(unit.y), 2.5), rsqrt(unit.y));
    sum.w = frac(dot(uv, shift) + log2(unit.z));
  }
  if (bright) sum.xyz = mul(mul(turn, sum.xyz), turn);
  clip(color.w - 0.25);
  float s, c;
  sincos(uv.x, s, c);
  first = sum + float4(c, s, ddx(uv.x), ddy(uv.y));
  second = tex2Dproj(picture, float4(uv, 1, 2)) + tex2Dgrad(picture, uv, shift, tint.xy) +
           tex2Dbias(picture, float4(uv, 0, 2)) + texCUBE(sky, unit) * 0.5;
  second.xyz = unit.xyz > color.xyz ? cross(second.xyz, unit) : saturate(second.xyz - 0.25);
  second.w = face > 0 ? at.x : at.y;
  depth = 1 / (1 + uv.y);
}
