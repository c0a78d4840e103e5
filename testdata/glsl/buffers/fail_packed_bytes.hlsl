// RUN: not %clipc -T vs_6_6 --target=glsl120 %s -o %t 2>&1 | FileCheck %s
float4 main(float4 p : POSITION, uint2 i : I) : SV_Position {
  // CHECK: [[#@LINE+1]]:14: error: `dot4add_u8packed` reads the bits of a number; target `glsl120` has no function for that [target-bit-cast]
  return p + dot4add_u8packed(i.x, i.y, 1);
}
