// An array of textures in a struct takes no room, and what follows it begins a register; a texture alone changes nothing (vkd3d's
// test of offsets after objects, checked against native).
// RUN: %clipc -T vs_5_0 %s --reflect=- -o %t | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,vulkan
struct Material {
  float2 scale;
  Texture2D one;
  float bias;
  Texture2D maps[2];
  float gain;
};
Material material;
// CHECK: "name": "bias",
// CHECK-NEXT: "type": "float",
// CHECK-NEXT: "offset": 8,
// CHECK: "name": "gain",
// CHECK-NEXT: "type": "float",
// CHECK-NEXT: "offset": 16,
float4 main(float4 p : POSITION) : SV_Position {
  return p * float4(material.scale, material.bias, material.gain);
}
