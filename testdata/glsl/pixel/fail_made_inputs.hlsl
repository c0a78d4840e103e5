// SV_PointSize may stand in the struct that a vertex shader returns and a pixel shader takes; reading it means nothing there.
// RUN: not %clipc -T ps_5_0 %s -o - 2>&1 | FileCheck %s
struct Point { float4 position : SV_Position; float size : SV_PointSize; };
float4 main(Point p) : SV_Target { return p.size; }
// CHECK: [[#@LINE-2]]:60: error: `SV_PointSize` is read; clipc does not translate this input of a pixel shader for target `glsl450` [target-pixel-input]
