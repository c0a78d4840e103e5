// The size and the kind of a vertex shader that people write: its instructions are counted.
#define LIGHT_COUNT 4

cbuffer PerFrame : register(b0)
{
    float4x4 view_projection;
    float3 eye_position;
    float time;
    float4 fog_range;
};

cbuffer PerObject : register(b1)
{
    float4x4 world;
    float4 light_position[LIGHT_COUNT];
    float4 light_color[LIGHT_COUNT];
    float4 ambient;
};

cbuffer Planes : register(b2)
{
    float4 water_plane;
    float4 portal_plane;
};

struct Vertex
{
    float3 position : POSITION;
    float3 normal : NORMAL;
    float2 uv : TEXCOORD0;
    float4 color : COLOR;
};

struct Varyings
{
    float4 position : SV_Position;
    float4 color : COLOR0;
    float2 uv : TEXCOORD0;
    float fog : TEXCOORD1;
};

float4 Lighting(float3 position, float3 normal)
{
    float4 sum = ambient;
    for (int i = 0; i < LIGHT_COUNT; ++i)
    {
        float3 to_light = light_position[i].xyz - position;
        float attenuation = saturate(1.0 - dot(to_light, to_light) * light_position[i].w);
        sum += light_color[i] * attenuation * max(dot(normal, normalize(to_light)), 0);
    }
    return sum;
}

[clipplanes(water_plane, portal_plane)]
Varyings main(Vertex input)
{
    Varyings output = (Varyings)0;
    float4 world_position = mul(float4(input.position, 1), world);
    world_position.y += sin(time + world_position.x) * 0.1;
    output.position = mul(world_position, view_projection);
    output.color = input.color * Lighting(world_position.xyz, normalize(mul(input.normal, (float3x3)world)));
    output.uv = input.uv + float2(0.5, time);
    output.fog = smoothstep(fog_range.x, fog_range.y, distance(eye_position, world_position.xyz));
    return output;
}
