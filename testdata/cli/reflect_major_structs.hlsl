// The fields of a struct say how its matrices lie, not the pragma at the variable. Oracle: vkd3d's majority-pragma.shader_test, line 186.
// RUN: %clipc -T vs_5_0 %s -o /dev/null --reflect=- | FileCheck %s --implicit-check-not=rowMajor
struct Pair { float2x2 m; };
#pragma pack_matrix(row_major)
struct Other { float2x2 n; };
uniform Pair pair;
uniform Other other;
// CHECK: "name": "n"
// CHECK: "rowMajor": true
float4 main(float4 p : POSITION) : SV_Position { return p + float4(pair.m[0], pair.m[1]) + other.n[1].xyxy; }
