// Vertex and instance numbers, and instance data in an array of buffers.
// RUN: %draw compare %s -T vs_5_1 -E main --target glsl450,glsl410,essl320,vulkan

struct Camera {
  float4 offset;
  float scale;
  float4 plane;
};
ConstantBuffer<Camera> cameras[2] : register(b3);

[clipplanes(cameras[1].plane)]
float4 main(float4 position : POSITION, uint vertex : SV_VertexID, uint instance : SV_InstanceID,
            out uint2 numbers : NUMBERS) : SV_Position {
  numbers = uint2(vertex, instance);
  return position * cameras[1].scale + cameras[0].offset * (float)instance;
}
