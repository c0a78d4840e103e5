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

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Camera {  // b0
// CHECK-NEXT:     layout(row_major) mat4 view;
// CHECK-NEXT:     layout(row_major) mat4 projection;
// CHECK-NEXT:     layout(row_major) mat3x4 bone;
// CHECK-NEXT:     layout(row_major) mat4x3 frame;
// CHECK-NEXT:     layout(row_major) mat2x3 uv;
// CHECK-NEXT: } camera;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// CHECK-NEXT: layout(location = 1) in vec3 in_NORMAL0;  // n : NORMAL0
// CHECK-NEXT: layout(location = 2) in vec2 in_TEXCOORD0;  // t : TEXCOORD0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     gl_Position = camera.projection * (camera.view * in_POSITION0);
// CHECK-NEXT:     gl_Position += in_POSITION0 * camera.view;
// CHECK-NEXT:     gl_Position += camera.bone * in_NORMAL0;
// CHECK-NEXT:     gl_Position.xyz += in_POSITION0 * camera.bone;
// CHECK-NEXT:     gl_Position.xyz += camera.frame * in_POSITION0;
// CHECK-NEXT:     gl_Position += in_NORMAL0 * camera.frame;
// CHECK-NEXT:     gl_Position.xyz += camera.uv * in_TEXCOORD0;
// CHECK-NEXT:     gl_Position += (camera.projection * camera.view)[1];
// CHECK-NEXT:     gl_Position.xyz += (camera.bone * camera.uv)[0].xyz;
// CHECK-NEXT:     gl_Position += camera.view[2];
// CHECK-NEXT:     gl_Position.x += camera.view[2][1] + camera.view[2][1] + camera.view[2][1];
// CHECK-NEXT:     gl_Position += vec4(camera.view[0][0], camera.view[1][1], camera.view[2][2], camera.view[3][3]) + camera.view[1].xyzw;
// CHECK-NEXT:     gl_Position += transpose(camera.view)[0];
// CHECK-NEXT:     gl_Position.xyz += transpose(camera.bone)[3].xyz;
// CHECK-NEXT:     mat4 m = matrixCompMult(camera.view, camera.projection);
// CHECK-NEXT:     m = matrixCompMult(m, camera.view);
// CHECK-NEXT:     m += camera.projection;
// CHECK-NEXT:     m = m * 2.0 - 1.0;
// CHECK-NEXT:     m[0] = in_POSITION0;
// CHECK-NEXT:     m[1].xy = in_TEXCOORD0;
// CHECK-NEXT:     m[2][3] = 3.0;
// CHECK-NEXT:     gl_Position += m[3];
// CHECK-NEXT:     gl_Position.xyz += mat3(camera.view) * in_NORMAL0;
// CHECK-NEXT:     gl_Position.xyz += camera.view[0].xyz + mat3x2(camera.view)[0].xyx;
// CHECK-NEXT:     gl_Position += mat4(in_POSITION0, in_POSITION0, gl_Position, gl_Position)[1] + mat4(1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0)[2];
// CHECK-NEXT:     gl_Position.x += determinant(camera.view) + determinant(mat2(camera.view));
// CHECK-NEXT: }
