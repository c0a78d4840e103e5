// dxc expands macros in the words of pack_matrix, fxc does not: there the pragma has no effect. Oracle: vkd3d's
// majority-pragma.shader_test, line 71, checked against both.
// RUN: %clipc -T vs_6_0 %s -o - 2>&1 | FileCheck --check-prefix=DXC --implicit-check-not=warning %s
// RUN: %clipc -T vs_5_0 %s -o - 2>&1 | FileCheck --check-prefix=FXC %s
#define VALUE row_major
#pragma pack_matrix(VALUE)
// DXC: {{^ *}}mat3x4 m;
// FXC: [[#@LINE-2]]:9: warning: {{.*}}pack_matrix
// FXC: layout(row_major) mat3x4 m;
uniform float3x4 m;
#define LONG row_major, row_major, row_major, row_major, row_major, row_major, row_major, row_major, row_major, row_major
#ifdef WRONG
#pragma pack_matrix(LONG)
#endif
// RUN: %clipc -T vs_6_0 -DWRONG %s -o - 2>&1 | FileCheck --check-prefix=LONG %s
// LONG: [[#@LINE-3]]:9: warning: {{.*}}pack_matrix
float4 main(float4 p : POSITION) : SV_Position { return float4(mul(m, p), 1); }
