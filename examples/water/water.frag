// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#version 130
in vec3 vs_NORMAL0;
out vec4 fragment;
uniform vec4 color;

void main() {
  float light = 0.35 + 0.65 * max(0.0, dot(normalize(vs_NORMAL0), vec3(-0.48, 0.8, -0.36)));
  fragment = vec4(color.rgb * light, color.a);
}
