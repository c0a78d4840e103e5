// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Water over what it reflects: the flatter the eye looks at it, the more it reflects (Schlick).
#version 130
in vec3 vs_NORMAL0;
in vec3 vs_TEXCOORD0;  // in world space
out vec4 fragment;
uniform vec4 color;
uniform vec4 eye;

void main() {
  float steepness = normalize(eye.xyz - vs_TEXCOORD0).y;
  float reflected = 0.35 + 0.65 * pow(1.0 - steepness, 5.0);
  fragment = vec4(color.rgb, 1.0 - reflected);
}
