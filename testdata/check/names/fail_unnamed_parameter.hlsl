// A parameter without a name is not an owner of the member that an undeclared name is.
// RUN: not %clipc -T vs_5_0 -fsyntax-only %s 2>&1 | FileCheck %s
struct Light { float4 color; };
float4 main(Light : LIGHT, float4 position : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:10: error: `color` is not declared [undeclared-name, X3004]
  return color + position;
}
