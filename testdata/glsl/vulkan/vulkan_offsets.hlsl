// [[vk::offset]] of a struct's fields, which leaves gaps: in push constants, in a buffer and within another struct.
// RUN: %clipc -T vs_5_1 %s --target=vulkan --validate -o - | FileCheck %s --check-prefixes=CHECK,VULKAN
// RUN: %clipc -T vs_5_1 %s --target=glsl450 --validate -o - | FileCheck %s
// RUN: %clipc -T vs_5_1 %s --target=glsl330 --validate -o - | FileCheck %s --check-prefix=PADDED
// RUN: %clipc -T vs_5_1 %s --target=vulkan -o /dev/null --reflect=- | FileCheck %s --check-prefix=JSON
// RUN: %clipc -T vs_5_1 %s --target=vulkan -o %t.spv && spirv-val %t.spv
// RUN: spirv-dis %t.spv | FileCheck %s --check-prefix=SPIRV
// RUN: %clipc -T vs_5_1 %s --target=vulkan -o /dev/null --reflect=%t.h && FileCheck %s --input-file=%t.h --check-prefix=STRUCT
// RUN: %draw compare %s -T vs_5_1 --target vulkan,glsl450,glsl330,essl300 | FileCheck %s --check-prefix=VALUES
// VALUES: : 0 wrong,

// VULKAN: layout(std140, push_constant) uniform push_block {
// CHECK: layout(offset = 64) vec4 tint;
// CHECK-NEXT: float size;
// CHECK-NEXT: layout(offset = 96) uint index;
// PADDED: vec4 padding_0[4];
// PADDED-NEXT: vec4 tint;
// JSON: "name": "tint",
// JSON-NEXT: "type": "float4",
// JSON-NEXT: "offset": 64,
// SPIRV-DAG: OpMemberDecorate %Push 0 Offset 64
// SPIRV-DAG: OpMemberDecorate %Push 1 Offset 80
// SPIRV-DAG: OpMemberDecorate %Push 2 Offset 96
// STRUCT: CLIPC_ASSERT(offsetof(struct {{.*}}, tint) == 64
// STRUCT: CLIPC_ASSERT(offsetof(struct {{.*}}, index) == 96
struct Push {
  [[vk::offset(64)]] float4 tint;
  float size;
  [[vk::offset(96)]] uint index;
};
[[vk::push_constant]] Push push;

struct Inner {
  float a;
  [[vk::offset(32)]] float2 b;
};
struct Outer {
  float first;
  Inner inner[2];
  float last;
};
ConstantBuffer<Outer> outer : register(b3);

float4 main(float4 p : POSITION) : SV_Position {
  return p * push.size + push.tint * push.index + outer.first + outer.inner[1].b.xyxy * outer.inner[0].a + outer.last;
}
