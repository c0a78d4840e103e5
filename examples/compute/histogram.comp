#version 450

layout(local_size_x = 8, local_size_y = 8, local_size_z = 1) in;

layout(std430, binding = 0) buffer histogram_block {  // u0
    uint histogram[];
};
layout(binding = 0) uniform sampler2D image;  // t0

float saturate(float x) {
    return min(max(0.0, x), 1.0);  // 0 for NaN
}

const uint kSide = 8u;
const uint kBins = kSide * kSide;
shared uint bins[64];

uint BinOf(vec3 color) {
    float brightness = dot(color, vec3(0.2126, 0.7152, 0.0722));
    return min(uint(saturate(brightness) * float(kBins)), kBins - 1u);
}

void main() {
    uvec2 id = gl_GlobalInvocationID.xy;
    uint index = gl_LocalInvocationIndex;
    bins[index] = 0u;
    memoryBarrierShared();
    barrier();
    uvec2 size;
    size = uvec2(textureSize(image, 0));
    if (all(lessThan(id, size))) {
        atomicAdd(bins[BinOf(texelFetch(image, ivec2(id), 0).xyz)], 1u);
    }
    memoryBarrierShared();
    barrier();
    if (bins[index] != 0u) {
        atomicAdd(histogram[index], bins[index]);
    }
}
