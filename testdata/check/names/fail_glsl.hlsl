// Names of GLSL in HLSL are answered with HLSL's.
// RUN: not %clipc -T vs_5_0 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_5_0 %s -o - 2>&1 | FileCheck %s --check-prefix=GLOBAL
// RUN: not %clipc -T vs_5_0 -DVERSION %s -o - 2>&1 | FileCheck %s --check-prefix=VERSION
#ifdef VERSION
// VERSION: [[#@LINE+1]]:2: error: invalid preprocessing directive; `#version` is GLSL's, and clipc reads HLSL [preprocessor-error, X1500]
#version 450
#endif

// GLOBAL: [[#@LINE+1]]:1: error: `mat4` is not a type; in HLSL it is `float4x4` [unknown-type, X3000]
mat4 view;
float4x4 projection;

float4 main(float4 position : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:3: error: `vec4` is not a type; in HLSL it is `float4` [unknown-type, X3000]
  vec4 p = 1;
  // CHECK: [[#@LINE+1]]:14: error: there is no function `mix`; in HLSL it is `lerp` [unknown-function, X3004]
  position = mix(position, 1, 0.5);
  // CHECK: [[#@LINE+1]]:3: error: `gl_Position` is not declared; what GLSL calls `gl_...` is a semantic in HLSL, `SV_Position` [undeclared-name, X3004]
  gl_Position = position;
  // CHECK: [[#@LINE+2]]:19: error: operator `*` is applied to `float4` and `float4x4`; the operands need a common type [operands-mismatch, X3020]
  // CHECK: note: a vector or a matrix is multiplied by a matrix with `mul(a, b)`
  return position * projection;
}
