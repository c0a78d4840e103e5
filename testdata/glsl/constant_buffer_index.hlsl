// An index of a ConstantBuffer array that is not constant, and one whose T is read from rows.
// RUN: %clipc -T vs_5_1 --target=glsl400 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_1 --target=vulkan --validate %s -o %t
// RUN: not %clipc -T vs_5_1 --target=glsl330 %s 2>&1 | FileCheck %s --check-prefix=OLD
// AUTOUPDATE
struct Object {
  float4 color;
};
struct Packed {
  float x;
  float3 y;
};
ConstantBuffer<Object> objects[3];
ConstantBuffer<Packed> packed[2];
ConstantBuffer<Packed> single;

float4 Read(Object o) { return o.color; }

float4 main(float4 p : POSITION, int i : INDEX) : SV_Position {
  return p + objects[i].color + Read(objects[i + 1]) + packed[i].y.xyzx + packed[1].x + single.y.xyzx;
}
