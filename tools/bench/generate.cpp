// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/bench/generate.h"

#include <fmt/format.h>

namespace clipc::bench {

std::string SixtyLineShader(unsigned seed) {
  return fmt::format(R"(// Shader {0}
#define LIGHT_COUNT 4

cbuffer PerFrame : register(b0)
{{
    float4x4 view_projection;
    float3 eye_position;
    float time;
    float4 fog_range;
}};

cbuffer PerObject : register(b1)
{{
    float4x4 world;
    float4 light_position[LIGHT_COUNT];
    float4 light_color[LIGHT_COUNT];
    float4 ambient;
}};

cbuffer Planes : register(b2)
{{
    float4 water_plane{0};
    float4 portal_plane{0};
}};

struct Vertex
{{
    float3 position : POSITION;
    float3 normal : NORMAL;
    float2 uv : TEXCOORD0;
    float4 color : COLOR;
}};

struct Varyings
{{
    float4 position : SV_Position;
    float4 color : COLOR0;
    float2 uv : TEXCOORD0;
    float fog : TEXCOORD1;
}};

float4 Lighting(float3 position, float3 normal)
{{
    float4 sum = ambient;
    for (int i = 0; i < LIGHT_COUNT; ++i)
    {{
        float3 to_light = light_position[i].xyz - position;
        float attenuation = saturate(1.0 - dot(to_light, to_light) * light_position[i].w);
        sum += light_color[i] * attenuation * max(dot(normal, normalize(to_light)), 0);
    }}
    return sum;
}}

[clipplanes(water_plane{0}, portal_plane{0})]
Varyings main(Vertex input)
{{
    Varyings output = (Varyings)0;
    float4 world_position = mul(float4(input.position, 1), world);
    world_position.y += sin(time + world_position.x * {1}.25) * 0.1;
    output.position = mul(world_position, view_projection);
    output.color = input.color * Lighting(world_position.xyz, normalize(mul(input.normal, (float3x3)world)));
    output.uv = input.uv * {1} + float2(0.5, time);
    output.fog = smoothstep(fog_range.x, fog_range.y, distance(eye_position, world_position.xyz));
    return output;
}}
)",
                     seed, seed % 7 + 1);
}

std::string Numbered(std::string_view text, int number) {
  std::string numbered;
  for (const char c : text) c == '@' ? numbered += std::to_string(number) : numbered += c;
  return numbered;
}

std::string SixtyLinePair(unsigned seed) {
  return SixtyLineShader(seed) + R"(
Texture2D picture : register(t0);
SamplerState filtered : register(s0);

float4 pixel(Varyings input) : SV_Target
{
    float4 color = picture.Sample(filtered, input.uv) * input.color;
    color.rgb = lerp(color.rgb, ambient.rgb, input.fog);
    return color;
}
)";
}

std::string SixtyLineGroup(unsigned seed) {
  return fmt::format(R"(// Shader {0}
#define TILE 64
#define RADIUS 4

cbuffer PerFrame : register(b0)
{{
    uint2 size;
    float exposure;
    float time;
    float4 weights[RADIUS + 1];
}};

cbuffer PerPass{0} : register(b1)
{{
    float4 tint{0};
    float threshold{0};
}};

Texture2D<float4> source : register(t0);
RWTexture2D<float4> target : register(u0);
RWStructuredBuffer<uint> histogram : register(u1);

groupshared float4 texels[TILE + 2 * RADIUS];
groupshared uint counts[16];

float Luminance(float3 color)
{{
    return dot(color, float3(0.2126, 0.7152, 0.0722));
}}

float4 Load(int2 place)
{{
    int2 inside = clamp(place, int2(0, 0), int2(size) - 1);
    return source[inside] * exposure + tint{0} * {0}.25;
}}

float4 Blur(uint index)
{{
    float4 sum = texels[index + RADIUS] * weights[0].x;
    for (uint i = 1; i <= RADIUS; ++i)
    {{
        sum += texels[index + RADIUS - i] * weights[i].y;
        sum += texels[index + RADIUS + i] * weights[i].z;
    }}
    return sum;
}}

[numthreads(TILE, 1, 1)]
void sum(uint3 id : SV_DispatchThreadID, uint index : SV_GroupIndex)
{{
    texels[index + RADIUS] = Load(int2(id.xy));
    if (index < RADIUS)
    {{
        texels[index] = Load(int2(id.xy) - int2(RADIUS, 0));
        texels[index + TILE + RADIUS] = Load(int2(id.xy) + int2(TILE, 0));
    }}
    if (index < 16)
        counts[index] = 0;
    GroupMemoryBarrierWithGroupSync();
    float4 color = Blur(index);
    float bright = Luminance(color.rgb);
    color.rgb = bright > threshold{0} ? color.rgb : color.rgb * sin(time + {0});
    InterlockedAdd(counts[min(uint(bright * 16), 15u)], 1);
    GroupMemoryBarrierWithGroupSync();
    if (index < 16)
        InterlockedAdd(histogram[index], counts[index]);
    target[id.xy] = color;
}}
)",
                     seed);
}

std::string FiftyPasses() {
  std::string text = R"(float4x4 World, View;
float4 Lights[8], Color;
float2 Scale;
texture Map;
sampler Texels = sampler_state { Texture = <Map>; MinFilter = LINEAR; };
struct V { float4 p : POSITION; float4 c : COLOR0; float2 uv : TEXCOORD0; float3 n : TEXCOORD1; };
)";
  for (int i = 0; i < kEffectVertexShaders; ++i) {
    text += Numbered(R"(V VS@(float4 p : POSITION, float3 n : NORMAL, float2 uv : TEXCOORD0) {
  V o;
  float4 world = mul(p, World);
  float3 normal = mul(n, (float3x3)World);
  float4 sum = @;
  for (int i = 0; i < 4; i++) {
    float3 d = Lights[i].xyz - world.xyz;
    sum += saturate(dot(normal, normalize(d))) / (dot(d, d) + 1) * Lights[i + 4];
  }
  o.p = mul(world, View);
  o.c = lerp(sum, Color, saturate((world.z - @) / 100));
  o.uv = uv * Scale;
  o.n = normal;
  return o;
}
)",
                     i);
  }
  for (int i = 0; i < kEffectPixelShaders; ++i) {
    text += Numbered(R"(float4 PS@(V v) : COLOR0 {
  float3 n = normalize(v.n);
  float4 near = tex2D(Texels, v.uv), far = tex2D(Texels, v.uv + n.xy);
  float4 color = near * v.c + far * pow(saturate(dot(n, Lights[@].xyz)), 8);
  if (color.a < 0.1) discard;
  return color * @;
}
)",
                     i);
  }
  text += "technique Draw {\n";
  for (int i = 0; i < kEffectVertexShaders * kEffectPixelShaders; ++i) {
    text += "  pass { ZEnable = true; VertexShader = compile vs_3_0 VS" +
            std::to_string(i / kEffectPixelShaders) + "(); PixelShader = compile ps_3_0 PS" +
            std::to_string(i % kEffectPixelShaders) + "(); }\n";
  }
  return text + "}\n";
}

std::string LargeShader(std::size_t bytes) {
  std::string text =
      "cbuffer C { float4 plane; float4 k[16]; float4x4 m; };\nstruct Pair { float4 a; float3 b; "
      "};\n";
  constexpr unsigned kPerGroup =
      50;  // functions called by one caller, so that calls do not nest deeply
  unsigned function = 0, group = 0;
  std::string all;
  while (text.size() < bytes) {
    std::string calls;
    for (unsigned i = 0; i < kPerGroup && text.size() < bytes; ++i, ++function) {
      text += fmt::format(
          "float4 f{0}(float4 v, int i)\n{{\n    Pair p;\n    p.a = mul(v, m) * {1}.5 + k[i & "
          "15];\n    p.b = normalize(v.xyz + p.a.yzw);\n"
          "    if (p.a.x > 0.25)\n    {{\n        p.a.xy = p.b.zx - v.wz;\n    }}\n    for (int j "
          "= 0; j < 3; ++j)\n    {{\n"
          "        p.a += float4(p.b, 1) * saturate(dot(p.b, v.xyz)) / (j + 1);\n    }}\n    "
          "return lerp(p.a, v, 0.125);\n}}\n",
          function, function % 9);
      calls += fmt::format("    v += f{}(v, {});\n", function, function % 16);
    }
    text += fmt::format("float4 g{}(float4 v)\n{{\n{}    return v;\n}}\n", group, calls);
    all += fmt::format("    v += g{}(v);\n", group++);
  }
  return text + "[clipplanes(plane)]\nfloat4 main(float4 v : POSITION) : SV_Position\n{\n" + all +
         "    return v;\n}\n";
}

}  // namespace clipc::bench
