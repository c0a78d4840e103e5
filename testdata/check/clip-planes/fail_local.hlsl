// An operand that is a parameter or a local variable: the attribute stands outside of both.
// RUN: not %clipc -T vs_5_0 -E parameter %s -o - 2>&1 | FileCheck %s --check-prefix=PARAMETER
// RUN: not %clipc -T vs_5_0 -E local %s -o - 2>&1 | FileCheck %s --check-prefix=LOCAL
// RUN: not %clipc -T vs_5_0 -E later %s -o - 2>&1 | FileCheck %s --check-prefix=LATER
// RUN: not %clipc -T vs_5_0 -E near %s -o - 2>&1 | FileCheck %s --check-prefix=NEAR

// PARAMETER: [[#@LINE+1]]:13: error: `q` is not declared; a clip plane is a global variable or a member of a constant buffer [undeclared-name, X3004]
[clipplanes(q)] float4 parameter(float4 p : POSITION, float4 q : TEXCOORD) : SV_Position { return p + q; }

// LOCAL: [[#@LINE+1]]:13: error: `sea` is not declared; a clip plane is a global variable or a member of a constant buffer [undeclared-name, X3004]
[clipplanes(sea)] float4 local(float4 p : POSITION) : SV_Position {
  float4 sea = p;
  return sea;
}

// LATER: [[#@LINE+1]]:13: error: `water` is not declared; a name must be declared before its use [undeclared-name, X3004]
[clipplanes(water)] float4 later(float4 p : POSITION) : SV_Position { return p; }
cbuffer Clip { float4 water; };

// NEAR: [[#@LINE+1]]:13: error: `watr` is not declared; did you mean `water`? [undeclared-name, X3004]
[clipplanes(watr)] float4 near(float4 p : POSITION) : SV_Position { return p; }
