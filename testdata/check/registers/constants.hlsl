// register(c#) places what is in $Globals, with the number in brackets added up to shader model 5.1; elsewhere it has no effect
// (vkd3d's test of numeric register reservations, checked against native).
// RUN: %clipc -T vs_5_0 %s --validate 2>%t.messages | FileCheck %s
// RUN: FileCheck %s --check-prefix=MESSAGE --input-file=%t.messages
// RUN: %clipc -T vs_6_0 %s --validate 2>%t.messages | FileCheck %s --check-prefix=DXIL
// RUN: FileCheck %s --check-prefix=MESSAGE-DXIL --input-file=%t.messages
float placed : register(c0[1 + 1]);
float4 low : register(c2[-1]);
Texture2D colors : register(t1[2]);
SamplerState smooth : register(s0);
// CHECK: layout(offset = 16) vec4 low;
// CHECK-NEXT: {{^    }}float placed;
// DXIL: {{^    }}float placed;
// DXIL: layout(offset = 32) vec4 low;
cbuffer Others {
  // CHECK: {{^    }}float other;
  // MESSAGE: [[#@LINE+1]]:17: warning: the register has no effect: a member of another buffer than `$Globals` has its place by `packoffset` [-Wregister-without-effect]
  float other : register(c1);
};
// CHECK: layout(binding = 3) uniform sampler2D colors;
// DXIL: layout(binding = 1) uniform sampler2D colors;
// MESSAGE-DXIL: 7:16: warning: the register has no effect: the number in brackets counts up to shader model 5.1
float4 main() : SV_Position { return placed + low + other + colors.SampleLevel(smooth, 0, 0); }
