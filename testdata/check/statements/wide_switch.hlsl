// A switch over 64 bits compares all of them: labels that differ in their upper halves alone are two. Oracle: vkd3d's
// switch.shader_test, checked against dxc.
// RUN: %clipc -T ps_6_0 -E ps %s -o - | FileCheck %s
// RUN: %clipc -T ps_6_0 -E signed_value %s -o - | FileCheck --check-prefix=SIGNED %s
uint64_t2 picked;
int64_t steps;

float4 ps() : SV_Target {
  // CHECK: switch (globals.picked.y == 7ul ? 0 : globals.picked.y == 4294967303ul ? 1 : globals.picked.y == 1099511627776ul ? 2 : -1) {
  // CHECK-NEXT: case 0:
  // CHECK-NEXT: case 1:
  // CHECK-NEXT: return vec4(0.25);
  // CHECK-NEXT: case 2:
  // CHECK-NEXT: return vec4(0.5);
  // CHECK-NEXT: default:
  // CHECK-NEXT: return vec4(0.75);
  switch (picked.y) {
    case 7:
    case 0x100000007: return 0.25;
    case 0x10000000000: return 0.5;
    default: return 0.75;
  }
}

float4 signed_value() : SV_Target {
  // The value is computed once.
  // SIGNED: switch (temporary = globals.steps * 3l, temporary == -4294967296l ? 0 : -1) {
  switch (steps * 3) {
    case -0x100000000: return 1;
  }
  return 0;
}
