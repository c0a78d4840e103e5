// The initial value of a constant has its type, as in fxc, although no shader reads it.
// RUN: not %clipc %s -o - 2>&1 | FileCheck %s
// CHECK: [[#@LINE+1]]:15: error: the initialiser has too few components; `float4` has 4 [initialiser-count, X3037]
float4 tint = {1, 2};
float4 main(float4 p : POSITION) : SV_Position { return p * tint; }
