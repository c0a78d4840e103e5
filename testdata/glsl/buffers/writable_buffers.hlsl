// What a vertex shader may write from shader model 5.0 on: buffers are storage blocks, typed buffers and textures are images,
// whose format has 32 bits a component. A component of a texel is written by way of the whole texel.
// RUN: %clipc -T vs_5_0 --target=glsl450 --validate %s -o - | FileCheck %s --check-prefix=CHECK
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o - | FileCheck %s --check-prefix=VULKAN
// AUTOUPDATE
struct Particle {
  float4 place;
  uint hits;
};
RWStructuredBuffer<float4> rows : register(u1);
RWByteAddressBuffer bytes;
RWBuffer<float> numbers;
RWTexture2D<uint2> picture;
RWTexture3D<float3> volume;

float4 main(float4 p : POSITION, uint id : SV_VertexID) : SV_Position {
  uint i = 0;
  rows[i++] = p;
  rows[id].y += 2;
  rows[id].xz = p.yx;
  numbers[id] = rows[0].x + numbers[2];
  numbers[1]++;
  picture[uint2(1, id)] = uint2(2, i);
  picture[uint2(1, 2)].x = picture.Load(int2(3, 4)).y;
  volume[uint3(1, 2, 3)] = p.xyz;
  bytes.Store(4, i);
  bytes.Store3(id * 4, uint3(1, 2, 3));
  uint width, height;
  picture.GetDimensions(width, height);
  return p + bytes.Load(8) + width;
}

// CHECK: #version 450
// CHECK-NEXT: #extension GL_ARB_shader_draw_parameters : require
// CHECK-EMPTY:
// CHECK-NEXT: layout(std430, binding = 1) buffer rows_block {  // u1
// CHECK-NEXT:     vec4 rows[];
// CHECK-NEXT: };
// CHECK-NEXT: layout(std430, binding = 0) buffer bytes_block {  // u0
// CHECK-NEXT:     uint bytes[];
// CHECK-NEXT: };
// CHECK-NEXT: layout(binding = 2, r32f) uniform imageBuffer numbers;  // u2
// CHECK-NEXT: layout(binding = 3, rg32ui) uniform uimage2D picture;  // u3
// CHECK-NEXT: layout(binding = 4, rgba32f) uniform image3D volume;  // u4
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-EMPTY:
// CHECK-NEXT: void bytes_store(uint address, uint value) {
// CHECK-NEXT:     bytes[address / 4u] = value;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void bytes_store3(uint address, uvec3 value) {
// CHECK-NEXT:     bytes[address / 4u] = value.x;
// CHECK-NEXT:     bytes[address / 4u + 1u] = value.y;
// CHECK-NEXT:     bytes[address / 4u + 2u] = value.z;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: uint bytes_load(uint address) {
// CHECK-NEXT:     uint i_2 = address / 4u;
// CHECK-NEXT:     return bytes[i_2];
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     uint id = uint(gl_VertexID - gl_BaseVertexARB);
// CHECK-NEXT:     uint i = 0u;
// CHECK-NEXT:     rows[i++] = in_POSITION0;
// CHECK-NEXT:     vec4 temporary = rows[id];
// CHECK-NEXT:     temporary.y += 2.0;
// CHECK-NEXT:     rows[id].y = temporary.y;
// CHECK-NEXT:     rows[id].x = in_POSITION0.y;
// CHECK-NEXT:     rows[id].z = in_POSITION0.x;
// CHECK-NEXT:     imageStore(numbers, int(id), vec4(rows[0].x + imageLoad(numbers, 2).x, 0.0, 0.0, 0.0));
// CHECK-NEXT:     float temporary_2 = imageLoad(numbers, 1).x;
// CHECK-NEXT:     float temporary_3 = temporary_2++;
// CHECK-NEXT:     imageStore(numbers, 1, vec4(temporary_2, 0.0, 0.0, 0.0));
// CHECK-NEXT:     imageStore(picture, ivec2(uvec2(1u, id)), uvec4(uvec2(2u, i), 0u, 0u));
// CHECK-NEXT:     uvec2 temporary_4 = imageLoad(picture, ivec2(1, 2)).xy;
// CHECK-NEXT:     temporary_4.x = imageLoad(picture, ivec2(3, 4)).xy.y;
// CHECK-NEXT:     imageStore(picture, ivec2(1, 2), uvec4(temporary_4, 0u, 0u));
// CHECK-NEXT:     imageStore(volume, ivec3(1, 2, 3), vec4(in_POSITION0.xyz, 0.0));
// CHECK-NEXT:     bytes_store(4u, i);
// CHECK-NEXT:     bytes_store3(id * 4u, uvec3(1u, 2u, 3u));
// CHECK-NEXT:     uint width;
// CHECK-NEXT:     ivec2 temporary_5 = imageSize(picture);
// CHECK-NEXT:     width = uint(temporary_5.x);
// CHECK-NEXT:     gl_Position = in_POSITION0 + float(bytes_load(8u)) + float(width);
// CHECK-NEXT: }

// VULKAN: #version 460
// VULKAN-EMPTY:
// VULKAN-NEXT: layout(std430, set = 0, binding = 161) buffer rows_block {  // u1
// VULKAN-NEXT:     vec4 rows[];
// VULKAN-NEXT: };
// VULKAN-NEXT: layout(std430, set = 0, binding = 160) buffer bytes_block {  // u0
// VULKAN-NEXT:     uint bytes[];
// VULKAN-NEXT: };
// VULKAN-NEXT: layout(set = 0, binding = 162, r32f) uniform imageBuffer numbers;  // u2
// VULKAN-NEXT: layout(set = 0, binding = 163, rg32ui) uniform uimage2D picture;  // u3
// VULKAN-NEXT: layout(set = 0, binding = 164, rgba32f) uniform image3D volume;  // u4
// VULKAN-EMPTY:
// VULKAN-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// VULKAN-EMPTY:
// VULKAN-NEXT: void bytes_store(uint address, uint value) {
// VULKAN-NEXT:     bytes[address / 4u] = value;
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: void bytes_store3(uint address, uvec3 value) {
// VULKAN-NEXT:     bytes[address / 4u] = value.x;
// VULKAN-NEXT:     bytes[address / 4u + 1u] = value.y;
// VULKAN-NEXT:     bytes[address / 4u + 2u] = value.z;
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: uint bytes_load(uint address) {
// VULKAN-NEXT:     uint i_2 = address / 4u;
// VULKAN-NEXT:     return bytes[i_2];
// VULKAN-NEXT: }
// VULKAN-EMPTY:
// VULKAN-NEXT: void main() {
// VULKAN-NEXT:     uint id = uint(gl_VertexIndex - gl_BaseVertex);
// VULKAN-NEXT:     uint i = 0u;
// VULKAN-NEXT:     rows[i++] = in_POSITION0;
// VULKAN-NEXT:     vec4 temporary = rows[id];
// VULKAN-NEXT:     temporary.y += 2.0;
// VULKAN-NEXT:     rows[id].y = temporary.y;
// VULKAN-NEXT:     rows[id].x = in_POSITION0.y;
// VULKAN-NEXT:     rows[id].z = in_POSITION0.x;
// VULKAN-NEXT:     imageStore(numbers, int(id), vec4(rows[0].x + imageLoad(numbers, 2).x, 0.0, 0.0, 0.0));
// VULKAN-NEXT:     float temporary_2 = imageLoad(numbers, 1).x;
// VULKAN-NEXT:     float temporary_3 = temporary_2++;
// VULKAN-NEXT:     imageStore(numbers, 1, vec4(temporary_2, 0.0, 0.0, 0.0));
// VULKAN-NEXT:     imageStore(picture, ivec2(uvec2(1u, id)), uvec4(uvec2(2u, i), 0u, 0u));
// VULKAN-NEXT:     uvec2 temporary_4 = imageLoad(picture, ivec2(1, 2)).xy;
// VULKAN-NEXT:     temporary_4.x = imageLoad(picture, ivec2(3, 4)).xy.y;
// VULKAN-NEXT:     imageStore(picture, ivec2(1, 2), uvec4(temporary_4, 0u, 0u));
// VULKAN-NEXT:     imageStore(volume, ivec3(1, 2, 3), vec4(in_POSITION0.xyz, 0.0));
// VULKAN-NEXT:     bytes_store(4u, i);
// VULKAN-NEXT:     bytes_store3(id * 4u, uvec3(1u, 2u, 3u));
// VULKAN-NEXT:     uint width;
// VULKAN-NEXT:     ivec2 temporary_5 = imageSize(picture);
// VULKAN-NEXT:     width = uint(temporary_5.x);
// VULKAN-NEXT:     gl_Position = in_POSITION0 + float(bytes_load(8u)) + float(width);
// VULKAN-NEXT: }
