// What a register has too much: vkd3d's register-reservations-numeric.shader_test, line 427 on, and register-reservations-profile.shader_test,
// line 279, checked against fxc and DXC.
// RUN: %clipc -T ps_5_0 %s --validate -o - 2>%t.messages | FileCheck %s
// RUN: FileCheck %s --check-prefix=MESSAGE --input-file=%t.messages
// CHECK: layout(offset = 32) float late;
// CHECK-NEXT: float named;
// CHECK-NEXT: float profile;
// MESSAGE: [[#@LINE+1]]:16: warning: the text after `c2` has no effect [-Wregister-rest]
float late   : register(c2manymanyletters);
// MESSAGE: [[#@LINE+1]]:15: warning: the register has no effect: fxc does not read it [-Wregister-without-effect]
float named : register(banana);
// MESSAGE: [[#@LINE+1]]:17: warning: the register has no effect: fxc does not read it
float profile : register(ps[5], c1);
float4 main() : SV_Target { return late + named + profile; }
