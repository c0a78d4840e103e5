// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#version 130
in vec3 vs_NORMAL0;
in vec3 vs_TEXCOORD0;  // in world space
out vec4 fragment;
uniform vec4 eye;      // in world space

void main() {
  vec3 normal = normalize(vs_NORMAL0);
  vec3 to_eye = normalize(eye.xyz - vs_TEXCOORD0);
  vec3 to_lamp = vec3(-0.48, 0.64, -0.6);
  bool inside = dot(normal, to_eye) < 0.0;
  if (inside) normal = -normal;
  vec3 color = inside ? vec3(0.80, 0.40, 0.22) : vec3(0.72, 0.76, 0.82);
  float light = 0.45 + 0.15 * normal.y + 0.45 * max(0.0, dot(normal, to_lamp));
  float shine = inside ? 0.0 : 0.3 * pow(max(0.0, dot(normal, normalize(to_lamp + to_eye))), 40.0);
  fragment = vec4(color * light + shine, 1.0);
}
