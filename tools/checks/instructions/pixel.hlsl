// The size and the kind of a pixel shader that people write: its instructions are counted.
#define CASCADE_COUNT 4

cbuffer PerFrame : register(b0)
{
    float3 eye_position;
    float exposure;
    float4 fog_color;
    float3 sun_direction;
    float sun_power;
};

cbuffer Shadows : register(b1)
{
    float4x4 cascade[CASCADE_COUNT];
    float4 cascade_end;
};

Texture2D albedo_map : register(t0);
Texture2D normal_map : register(t1);
Texture2DArray shadow_map : register(t2);
SamplerState trilinear : register(s0);
SamplerComparisonState shadow : register(s1);

struct Varyings
{
    float4 position : SV_Position;
    float3 world : TEXCOORD0;
    float3 normal : NORMAL;
    float4 tangent : TANGENT;
    float2 uv : TEXCOORD1;
    float fog : TEXCOORD2;
};

float Shadow(float3 world, float depth)
{
    int index = 0;
    for (int i = 0; i < CASCADE_COUNT - 1; ++i)
        index += depth > cascade_end[i] ? 1 : 0;
    float4 place = mul(float4(world, 1), cascade[index]);
    return shadow_map.SampleCmpLevelZero(shadow, float3(place.xy, index), place.z);
}

float3 Normal(Varyings input)
{
    float3 texel = normal_map.Sample(trilinear, input.uv).xyz * 2 - 1;
    float3 bitangent = cross(input.normal, input.tangent.xyz) * input.tangent.w;
    return normalize(texel.x * input.tangent.xyz + texel.y * bitangent + texel.z * input.normal);
}

float4 main(Varyings input) : SV_Target
{
    float4 albedo = albedo_map.Sample(trilinear, input.uv);
    clip(albedo.a - 0.5);
    float3 normal = Normal(input);
    float3 half_way = normalize(normalize(eye_position - input.world) - sun_direction);
    float diffuse = saturate(dot(normal, -sun_direction)) * Shadow(input.world, input.position.w);
    float specular = pow(saturate(dot(normal, half_way)), 32) * diffuse;
    float3 lit = (albedo.rgb * (0.2 + diffuse) + specular) * sun_power * exposure;
    return float4(lerp(lit, fog_color.rgb, input.fog), albedo.a);
}
