// ConstantBuffer<T> is a block with an instance name; before GLSL 1.50 a block of one struct.
// RUN: %clipc -T vs_5_1 --target=glsl450 --validate %s -o - | FileCheck %s --check-prefixes=CHECK,NEW
// RUN: %clipc -T vs_5_1 --target=glsl140 --validate -DONE %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_5_1 --target=glsl330 --validate %s -o %t
// RUN: %clipc -T vs_5_1 --target=essl300 --validate %s -o %t
// RUN: %clipc -T vs_5_1 --target=glsl120 --validate %s -o %t
// AUTOUPDATE
struct Object {
  float4x4 world;
  float4 color;
};
ConstantBuffer<Object> object : register(b1);
ConstantBuffer<Object> objects[3] : register(b2);

float4 Tint(Object o) { return o.color * 2; }

float4 main(float4 p : POSITION) : SV_Position {
  float4 r = mul(p, object.world) + object.color + Tint(object);
#ifndef ONE
  r += objects[1].color + Tint(objects[2]);
#endif
  return r;
}
