// DXC has no bool of the coverage, which fxc has: testdata/draw/pixel/coverage_bool.hlsl.
// RUN: not %clipc -T ps_6_0 %s 2>&1 | FileCheck %s
// CHECK: [[#@LINE+1]]:28: error: `SV_Coverage` has type `bool`; it must be a `uint` [semantic-type, X4503]
float4 main(bool covered : SV_Coverage) : SV_Target { return covered; }
