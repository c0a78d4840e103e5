// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#version 130
in vec4 vs_COLOR0;
out vec4 fragment;
void main() { fragment = vs_COLOR0; }
