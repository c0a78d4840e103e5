// What std140 would move is read out of an array of rows: scalars behind arrays, matrices and structs in their last row,
// vectors that std140 would align, matrices whose registers hold one component, structs that mix row_major and column_major.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl150 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o %t
// AUTOUPDATE
cbuffer Floats {
  float x;
  float3 y;
  float weights[3];
  float after_array;
  float3x3 normal;
  float after_matrix;
  row_major float4x3 frame;
  float4x4 bones[2];
  float1x4 across;
};
struct Mixed {
  row_major float2x2 r;
  float2x2 c;
  float tail;
};
cbuffer Kinds {
  Mixed mixed;
  float after_struct;
  int i;
  uint2 u;
  bool b[2];
  bool after_bools;
  float f[2];
};

float4 main(float4 p : POSITION, uint n : INDEX) : SV_Position {
  float4 r = x + y.xyzx + weights[n] + weights[2] + after_array + after_matrix;
  r.xyz += mul(p.xyz, normal) + normal[1];
  r.xyz += mul(p, frame);
  r += mul(p, bones[n]) + across;
  float all[3] = weights;
  r.x += all[n];
  r.xy += mixed.r[0] + mixed.c[1] + mixed.tail + after_struct;
  r += i + u.xyxy + f[n];
  if (b[n] && after_bools) r = 0;
  return r;
}
