// `unsigned` before a typedef of anything but integers: fxc X3085 ("unsigned can not be used with type", DXC's matrix-syntax.hlsl).
// RUN: not %clipc -T vs_5_0 %s -o - 2>&1 | FileCheck %s
typedef float real_t;
// CHECK: [[#@LINE+1]]:50: error: `unsigned` is written before `float`; it makes an unsigned type of an integer type only [unsigned-type, X3085]
float4 main(float4 p : POSITION) : SV_Position { unsigned real_t x = 1; return p * x; }
