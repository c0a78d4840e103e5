// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#version 130
in vec3 vs_NORMAL0;
in vec3 vs_TEXCOORD0;  // in world space
out vec4 fragment;
uniform vec4 color;
uniform vec4 eye;  // in world space; of a reflection, mirrored

void main() {
  vec3 normal = normalize(vs_NORMAL0);
  vec3 to_eye = normalize(eye.xyz - vs_TEXCOORD0);
  vec3 to_sun = vec3(-0.48, 0.64, -0.6);
  // The inside, where something is cut open.
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  float light = 0.45 + 0.15 * normal.y + 0.5 * max(0.0, dot(normal, to_sun));
  float shine = 0.35 * pow(max(0.0, dot(normal, normalize(to_sun + to_eye))), 40.0);
  fragment = vec4(color.rgb * light + shine, 1.0);
}
