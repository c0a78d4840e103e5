#version 450

layout(local_size_x = 64, local_size_y = 1, local_size_z = 1) in;

layout(std430, binding = 0) readonly buffer counts_block {  // t0
    uint counts[];
};
layout(std430, binding = 1) buffer offsets_block {  // u0
    uint offsets[];
};
layout(std430, binding = 2) buffer totals_block {  // u1
    uint totals[];
};

const uint kThreads = 64u;
shared uint sums[64];

void main() {
    uint id = gl_GlobalInvocationID.x;
    uint group = gl_WorkGroupID.x;
    uint index = gl_LocalInvocationIndex;
    uint own = counts[id];
    sums[index] = own;
    memoryBarrierShared();
    barrier();
    for (uint reach = 1u; reach < kThreads; reach *= 2u) {
        uint before = 0u;
        if (index >= reach) {
            before = sums[index - reach];
        }
        memoryBarrierShared();
        barrier();
        sums[index] += before;
        memoryBarrierShared();
        barrier();
    }
    offsets[id] = sums[index] - own;
    if (index == kThreads - 1u) {
        totals[group] = sums[index];
    }
}
