cbuffer Scene : register(b1)
{
    float4x4 world_view_projection;
    float4 left;
    float4 right;
};

struct Output
{
    float4 position : SV_Position;
    float2 uv : TEXCOORD0;
};

[clipplanes(left, right)]
Output main(float4 position : POSITION, float2 uv : TEXCOORD)
{
    Output output;
    output.position = mul(position, world_view_projection);
    output.uv = uv;
    return output;
}
