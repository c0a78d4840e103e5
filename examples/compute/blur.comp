#version 450

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;

layout(binding = 0, rgba32f) uniform image2D blurred;  // u0
layout(binding = 0) uniform sampler2D source;  // t0

const uint kRadius = 2u;
const uint kTile = 8u;
const uint kSide = kTile + 2u * kRadius;
const float kWeights[5] = float[5](0.0625, 0.25, 0.375, 0.25, 0.0625);
shared vec4 texels[12][12];
shared vec4 rows[12][8];

void main() {
    uvec2 id = gl_GlobalInvocationID.xy;
    uvec2 group = gl_WorkGroupID.xy;
    uvec2 thread = gl_LocalInvocationID.xy;
    uint index = gl_LocalInvocationIndex;
    uvec2 size;
    size = uvec2(textureSize(source, 0));
    ivec2 corner = ivec2(group * kTile) - int(kRadius);
    for (uint i = index; i < kSide * kSide; i += kTile * kTile) {
        uvec2 at = uvec2(i % kSide, i / kSide);
        texels[at.y][at.x] = texelFetch(source, clamp(corner + ivec2(at), ivec2(0), ivec2(size) - 1), 0);
    }
    memoryBarrierShared();
    barrier();
    for (uint j = index; j < kSide * kTile; j += kTile * kTile) {
        uvec2 at = uvec2(j % kTile, j / kTile);
        vec4 sum = vec4(0.0);
        for (uint k = 0u; k <= 2u * kRadius; ++k) {
            sum += kWeights[k] * texels[at.y][at.x + k];
        }
        rows[at.y][at.x] = sum;
    }
    memoryBarrierShared();
    barrier();
    vec4 sum = vec4(0.0);
    for (uint k = 0u; k <= 2u * kRadius; ++k) {
        sum += kWeights[k] * rows[thread.y + k][thread.x];
    }
    if (all(lessThan(id, size))) {
        imageStore(blurred, ivec2(id), sum);
    }
}
