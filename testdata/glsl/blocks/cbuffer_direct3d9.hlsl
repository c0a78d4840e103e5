// In Direct3D 9 no two variables share a register: `count` does not begin in the last register of `cube`, from which std140 could
// not read it as a member. In Direct3D 11 it does, as fxc and DXC lay out $Globals (DirectXShaderCompiler issue 1900).
// RUN: %clipc -T vs_3_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 -DPOSITION=SV_Position %s -o - | FileCheck %s --check-prefix=LATER
float3 cube[2] : register(c21);
int count : register(i0);
float scale;

float4 main(float4 p : TEXCOORD) : POSITION {
  for (int i = 0; i < count; ++i) p.xyz += cube[i] * scale;
  return p;
}

// CHECK: layout(offset = 336) vec3 cube[2];
// CHECK-NEXT: int count;
// CHECK-NEXT: float scale;
// LATER: layout(offset = 336) uvec4 cube_rows[2];
// LATER-NEXT: float scale;
