// What only other stages have may stand in the struct that a vertex shader returns and a pixel shader takes. Reading it is an error:
// fxc's X4502, "invalid ps input semantic 'SV_VertexID'", and DXC's signature table, where column PSIn has no SV_VertexID.
// RUN: not %clipc -T ps_5_0 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_5_0 -E number %s -o - 2>&1 | FileCheck %s --check-prefix=NUMBER
// RUN: not %clipc -T ps_5_0 -E group %s -o - 2>&1 | FileCheck %s --check-prefix=GROUP
// RUN: %clipc -T ps_5_0 -E carried %s -o %t
struct Point { float4 position : SV_Position; float size : SV_PointSize; };
float4 main(Point p) : SV_Target { return p.size; }
// CHECK: [[#@LINE-2]]:60: error: `SV_PointSize` is not an input of a pixel shader [semantic-not-for-stage, X4502]
// NUMBER: error: `SV_VertexID` is not an input of a pixel shader [semantic-not-for-stage, X4502]
float4 number(uint vertex : SV_VertexID) : SV_Target { return vertex; }
// GROUP: error: `SV_GroupID` is not an input of a pixel shader [semantic-not-for-stage, X4502]
float4 group(uint3 group : SV_GroupID) : SV_Target { return group.xyzx; }
float4 carried(uint vertex : SV_VertexID) : SV_Target { return 1; }
