// Plane space `object` is refused where it is doubtful what the object's own position is.
// RUN: not %clipc --plane-space=object -DASSIGNED %s 2>&1 | FileCheck %s --check-prefix=ASSIGNED
// RUN: not %clipc --plane-space=object -DPART %s 2>&1 | FileCheck %s --check-prefix=PART
// RUN: not %clipc --plane-space=object -DWHOLE %s 2>&1 | FileCheck %s --check-prefix=WHOLE
// RUN: not %clipc --plane-space=object -DPASSED %s 2>&1 | FileCheck %s --check-prefix=PASSED
// RUN: not %clipc --plane-space=object -DINTRINSIC %s 2>&1 | FileCheck %s --check-prefix=INTRINSIC
// RUN: not %clipc --plane-space=object -DELEMENT --position-input=POSITION2 %s 2>&1 | FileCheck %s --check-prefix=ELEMENT
// RUN: %clipc --plane-space=object -DELEMENT --position-input=POSITION3 %s | FileCheck %s --check-prefix=THIRD
// RUN: not %clipc --plane-space=object -DINOUT %s 2>&1 | FileCheck %s --check-prefix=INOUT
// RUN: not %clipc --plane-space=object --position-input=POSITOIN0 %s 2>&1 | FileCheck %s --check-prefix=MISSING
// RUN: not %clipc --plane-space=object --position-input=TEXCOORD %s 2>&1 | FileCheck %s --check-prefix=SHORT
// RUN: not %clipc --plane-space=object --position-input=COLOR %s 2>&1 | FileCheck %s --check-prefix=INTEGER
// RUN: %clipc --plane-space=object -DNO_PLANES --position-input=NOTHING %s

float4 plane;
float scale;
struct Input {
  float4 position : POSITION;
  float2 uv : TEXCOORD;
  uint4 color : COLOR;
};
void Move(inout float3 p) { p *= scale; }

#ifndef NO_PLANES
[clipplanes(plane)]
#endif
#if defined ELEMENT
float4 main(float4 p[4] : POSITION, uniform int which) : SV_Position {
  p[2].y = 0;  // ELEMENT: fail_position_input.hlsl:[[#@LINE]]:3: error: the input `POSITION2` is changed here; {{.*}} so change a copy instead
  return p[3] + p[2];
}
// THIRD: gl_ClipDistance[0] = dot(in_POSITION3, globals.plane);
#elif defined INOUT
void main(inout float4 p : POSITION, out float4 q : SV_Position) {
  q = p;
  p.x++;  // INOUT: :[[#@LINE]]:3: error: the input `POSITION0` is changed here
}
#else
// MISSING: error: the entry point has no input `POSITOIN0`; plane space `object` clips by that input, and `--position-input` can name another; did you mean `POSITION0`? [position-input-missing]
// SHORT: :[[#@LINE-21]]:15: error: the input `TEXCOORD` is a `float2`; plane space `object` needs a `float3` or a `float4` [position-input-type]
// INTEGER: error: the input `COLOR` is a `uint4`; plane space `object`
float4 main(Input input) : SV_Position {
#if defined ASSIGNED
  input.position *= scale;  // ASSIGNED: :[[#@LINE]]:3: error: the input `POSITION0` is changed here; plane space `object` clips by the unchanged input, so change a copy instead [position-input-changed]
  // ASSIGNED: note: the input `POSITION0` is declared here
#elif defined PART
  if (scale > 0) input.position.xy = input.uv;  // PART: :[[#@LINE]]:18: error: the input `POSITION0` is changed here
#elif defined WHOLE
  Input other = input;
  input = other;  // WHOLE: :[[#@LINE]]:3: error: the input `POSITION0` is changed here
#elif defined PASSED
  Move(input.position.xyz);  // PASSED: :[[#@LINE]]:8: error: the input `POSITION0` is changed here
#elif defined INTRINSIC
  float s;
  sincos(scale, s, input.position.x);  // INTRINSIC: :[[#@LINE]]:20: error: the input `POSITION0` is changed here
#endif
  return input.position;
}
#endif
