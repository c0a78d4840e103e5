// Arrays of textures and samplers whose index a target, or GLSL, needs constant; a sampler that is read as two kinds by what is left
// when functions are inlined; gathers that older targets lack.
// RUN: not %clipc -T ps_5_1 -E chosen %s --target=glsl450 -o - 2>&1 | FileCheck %s --check-prefix=CHOSEN
// RUN: not %clipc -T ps_5_0 -E varies %s -o - 2>&1 | FileCheck %s --check-prefix=VARIES
// RUN: not %clipc -T ps_5_0 -E counted %s --target=glsl330 -o - 2>&1 | FileCheck %s --check-prefix=COUNTED
// RUN: not %clipc -T ps_3_0 -E both %s -o - 2>&1 | FileCheck %s --check-prefix=BOTH
// RUN: not %clipc -T ps_5_0 -E gathers %s --target=glsl140 -o - 2>&1 | FileCheck %s --check-prefixes=OLD,OLDER
// RUN: not %clipc -T ps_5_0 -E gathers %s --target=glsl120 -o - 2>&1 | FileCheck %s --check-prefixes=OLD,OLDEST
Texture2D map, other, maps[2][3];
SamplerState s, samplers[3];
SamplerComparisonState c;
uint kind;
int2 o;
// CHOSEN: [[#@LINE+1]]:63: error: the sampler `samplers` is an element of an array, and its index is not constant; target `glsl450` combines each texture with one named sampler [target-sampler-array]
float4 chosen(float2 uv : UV) : SV_Target { return map.Sample(samplers[kind], uv); }

// VARIES: error: {{.*}} [object-not-global, X3031]
float4 varies(float2 u : U) : SV_Target {
  Texture2D t[2] = { map, other };
  return t[kind].SampleLevel(s, u, 0);
}

// COUNTED: error: the index of `maps` is not constant; target `glsl330` accepts only constant indices
float4 counted(float2 uv : UV) : SV_Target {
  float4 r = 0;
  for (int i = 0; i < 3; ++i) r += maps[0][i].Sample(s, uv);
  return r;
}

sampler cubes;
float4 read(float3 u, const bool cube) {
  if (cube) return texCUBE(cubes, u);
  else return tex2D(cubes, u.xy);
}
// BOTH: error: sampler `cubes` is used as a `{{.*}}` and as a `{{.*}}`; a sampler has textures of one kind [sampler-kinds]
float4 both(float3 u : TEXCOORD0) : COLOR { return read(u, true) + read(u, false); }

float4 gathers(float4 p : P) : SV_Target {
  // OLDEST: [[#@LINE+1]]:14: error: a texture is read by `Gather`; target `glsl120` has no function for that [target-gather]
  float4 r = map.Gather(s, p.xy);
  // OLD: [[#@LINE+1]]:8: error: a texture is read by `GatherGreen`; target `{{.*}}` has no function for that [target-gather]
  r += map.GatherGreen(s, p.xy);
  // OLD: [[#@LINE+1]]:8: error: a texture is read by `GatherCmp`
  r += map.GatherCmp(c, p.xy, p.z);
  // OLDER: [[#@LINE+1]]:14: error: a texture is read by `Gather` at an offset that varies
  return r + map.Gather(s, p.xy, o & 3);
}
