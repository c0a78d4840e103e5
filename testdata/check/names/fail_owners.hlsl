// A member without the variable that has it, and with the buffer that it is in.
// RUN: not %clipc -T vs_5_0 %s 2>&1 | grep -v '^ ' | FileCheck %s
struct Lake {
  float4 plane, tint;
};
cbuffer Frame {
  Lake lake;
  float4x4 transform;
};

// CHECK: [[#@LINE+1]]:13: error: `plane` is not declared; did you mean `lake.plane`? [undeclared-name, X3004]
[clipplanes(plane)]
float4 main(float4 p : POSITION, out float4 c : COLOR) : SV_Position {
  // CHECK: [[#@LINE+1]]:7: error: `tint` is not declared; did you mean `lake.tint`? [undeclared-name, X3004]
  c = tint;
  // CHECK: [[#@LINE+1]]:17: error: `Frame` is not declared; `Frame` is a constant buffer, and its members have no prefix [undeclared-name, X3004]
  return mul(p, Frame.transform);
}
