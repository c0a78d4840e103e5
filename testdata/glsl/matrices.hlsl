// HLSL's rows are GLSL's columns: products turn round, indices, constructors and swizzles stay. Column-major memory is row_major here.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=glsl120 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=vulkan --validate %s -o %t
// AUTOUPDATE
cbuffer Camera {
  float4x4 view;
  float4x4 projection;
  float3x4 bone;
  float4x3 frame;
  float2x3 uv;
};

float4 main(float4 p : POSITION, float3 n : NORMAL, float2 t : TEXCOORD) : SV_Position {
  float4 r = mul(mul(p, view), projection);
  r += mul(view, p);
  r += mul(n, bone);
  r.xyz += mul(bone, p);
  r.xyz += mul(p, frame);
  r += mul(frame, n);
  r.xyz += mul(t, uv);
  r += mul(view, projection)[1];
  r.xyz += mul(uv, bone)[0].xyz;
  r += view[2];
  r.x += view[2][1] + view._m21 + view._32;
  r += view._m00_m11_m22_m33 + view._m10_m11_m12_m13;
  r += transpose(view)[0];
  r.xyz += transpose(bone)[3].xyz;
  float4x4 m = view * projection;
  m *= view;
  m += projection;
  m = m * 2 - 1;
  m[0] = p;
  m[1].xy = t;
  m._m23 = 3;
  r += m[3];
  r.xyz += mul(n, (float3x3)view);
  r.xyz += ((float1x3)view)[0] + ((float3x2)view)[0].xyx;
  r += float4x4(p, p, r, r)[1] + float4x4(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16)[2];
  r.x += determinant(view) + determinant((float2x2)view);
  return r;
}
