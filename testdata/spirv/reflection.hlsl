// Names for reflection: the semantics of inputs and outputs, the types of objects and buffers.
// RUN: %clipc -T ps_6_0 -spirv -fspv-reflect -S %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_0 -spirv -fspv-reflect %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %clipc -T ps_6_0 -spirv -fspv-reflect -fspv-target-env=vulkan1.2 -S %s -o - | FileCheck %s --check-prefix=NEW
// RUN: %clipc -T ps_6_0 -spirv -fspv-reflect -fspv-target-env=vulkan1.2 %s -o %t.spv && spirv-val --target-env vulkan1.2 %t.spv
// RUN: %clipc -T ps_6_0 -spirv -S %s -o - | FileCheck %s --check-prefix=PLAIN
// CHECK-DAG: OpExtension "SPV_GOOGLE_hlsl_functionality1"
// CHECK-DAG: OpExtension "SPV_GOOGLE_user_type"
// CHECK-DAG: OpDecorateString %vs_TEXCOORD2 {{UserSemantic|HlslSemanticGOOGLE}} "TexCoord2"
// CHECK-DAG: OpDecorateString %gl_FragCoord {{UserSemantic|HlslSemanticGOOGLE}} "SV_Position"
// CHECK-DAG: OpDecorateString %SV_Target0 {{UserSemantic|HlslSemanticGOOGLE}} "SV_Target"
// CHECK-DAG: OpDecorateString %map UserTypeGOOGLE "texture2d:<float3>"
// CHECK-DAG: OpDecorateString %soft UserTypeGOOGLE "samplerstate"
// CHECK-DAG: OpDecorateString %bytes UserTypeGOOGLE "byteaddressbuffer"
// CHECK-DAG: OpDecorateString %items UserTypeGOOGLE "structuredbuffer:<Item>"
// CHECK-DAG: OpDecorateString %part UserTypeGOOGLE "constantbuffer:<Item>"
// NEW-NOT: hlsl_functionality
// NEW: OpExtension "SPV_GOOGLE_user_type"
// PLAIN-NOT: OpDecorateString
struct Item {
  float4 color;
};
Texture2D<float3> map : register(t0);
SamplerState soft : register(s0);
ByteAddressBuffer bytes : register(t1);
StructuredBuffer<Item> items : register(t2);
ConstantBuffer<Item> part : register(b0);
float4 main(float4 p : SV_Position, float2 uv : TexCoord2) : SV_Target {
  return map.Sample(soft, uv).xyzz * p + bytes.Load(0) + items[2].color + part.color;
}
