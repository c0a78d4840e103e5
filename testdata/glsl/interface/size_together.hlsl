// GetDimensions writes the components of one variable at once.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 --target glsl450,vulkan
Texture2D t;
Texture2DArray array;
Texture3D cube;
float4 main(float4 p : POSITION) : SV_Position {
  float2 s;
  // CHECK: s = vec2(textureSize(t, 0));
  t.GetDimensions(s.x, s.y);
  float4 u = p;
  // CHECK-NEXT: vec4 u = in_POSITION0;
  // CHECK-NEXT: u.wyx = vec3(textureSize(array, 0));
  array.GetDimensions(u.w, u.y, u.x);
  uint levels;
  uint3 v;
  // CHECK: v = uvec3(textureSize(cube, 1));
  // CHECK: levels = uint(textureQueryLevels(cube));
  cube.GetDimensions(1, v.x, v.y, v.z, levels);
  // CHECK: ivec2 temporary = textureSize(t, 0);
  float2 w[2];
  t.GetDimensions(w[0].x, w[1].y);
  // CHECK: = textureSize(t, 0);
  t.GetDimensions(u.z, u.z);
  return p + s.xyxy + u + levels + v.xyzx + w[0].x + w[1].y;
}
