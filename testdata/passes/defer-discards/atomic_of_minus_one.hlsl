// The atomic operation of a pixel whose discard waits does not happen, and its value is zero; that of a counter that goes down is
// one, since the index is one below it. An addition of -1 to an element of a buffer is not one of a counter.
// RUN: %clipc -T ps_5_0 %s --dump-after=defer-discards | FileCheck %s
RWStructuredBuffer<uint> sums : register(u1);
RWStructuredBuffer<float> stack : register(u2);
Texture2D map : register(t0);
SamplerState linear_sampler : register(s0);

float4 main(float4 p : SV_Position, float2 uv : TEXCOORD0) : SV_Target
{
    if (uv.x < 0.5)
        discard;
    uint before;
    InterlockedAdd(sums[0], ~0u, before);
    uint index = stack.DecrementCounter();
    return map.Sample(linear_sampler, uv) + before + index;
}

// CHECK:     before = is_discarded ? zero<uint> : atomic_add(sums
// CHECK:     (is_discarded ? 1u : atomic_add(counter_var_stack
