// Every form of an operand that is refused, each with fxc's code.
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=float4(0,0,1,0) %s 2>&1 | FileCheck %s --check-prefix=MEMBER
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=1 %s 2>&1 | FileCheck %s --check-prefix=MEMBER
// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=float4(p.xyz,1)" %s 2>&1 | FileCheck %s --check-prefix=MEMBER
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=kPlane %s 2>&1 | FileCheck %s --check-prefix=MEMBER
// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=flag?p:q" %s 2>&1 | FileCheck %s --check-prefix=MEMBER
// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=p+q" %s 2>&1 | FileCheck %s --check-prefix=MEMBER
// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=-p" %s 2>&1 | FileCheck %s --check-prefix=MEMBER
// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=(float4)f3" %s 2>&1 | FileCheck %s --check-prefix=MEMBER
// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=-p" %s 2>&1 | FileCheck %s --check-prefix=NEGATED
// NEGATED: `-p` is not a clip plane;
// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=flag?p:q+p" %s 2>&1 | FileCheck %s --check-prefix=CHOICE
// CHOICE: `flag ? p : q + p` is not a clip plane;
// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=(float4)f3" %s 2>&1 | FileCheck %s --check-prefix=CAST
// CAST: `(float4)f3` is not a clip plane;
// MEMBER: is not a clip plane; a clip plane must be a member of a constant buffer, without literals or arithmetic [clip-plane-not-constant-buffer-member, X3084]

// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=planes[index]" %s 2>&1 | FileCheck %s --check-prefix=INDEX
// INDEX: the index in clip plane `planes[index]` is not constant; a clip plane must be known at compile time [clip-plane-index-not-constant, X3084]

// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=planes[4]" %s 2>&1 | FileCheck %s --check-prefix=BOUND
// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=planes[-1]" %s 2>&1 | FileCheck %s --check-prefix=NEGATIVE
// BOUND: error: index 4 of a `float4[4]` is out of bounds; it has 4 elements [index-out-of-bounds, X3504]
// NEGATIVE: error: index -1 of a `float4[4]` is out of bounds; it has 4 elements [index-out-of-bounds, X3504]

// RUN: not %clipc -T vs_5_0 -E main "-DPLANE=make()" %s 2>&1 | FileCheck %s --check-prefix=CALL
// CALL: error: a clip plane is given by a function call; it must be a member of a constant buffer [clip-plane-function-call, X3682]

// RUN: not %clipc -T vs_5_0 -E main -DPLANE=variable %s 2>&1 | FileCheck %s --check-prefix=STATIC
// STATIC: `variable` is not a member of a cbuffer; a clip plane must lie in a constant buffer [clip-plane-not-in-cbuffer, X3084]
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=shared_plane %s 2>&1 | FileCheck %s --check-prefix=GROUPSHARED
// GROUPSHARED: `shared_plane` is not a member of a cbuffer; a clip plane must lie in a constant buffer [clip-plane-not-in-cbuffer, X3084]
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=texture_plane %s 2>&1 | FileCheck %s --check-prefix=TBUFFER
// TBUFFER: `texture_plane` is a member of a tbuffer; a clip plane must lie in a constant buffer [clip-plane-not-in-cbuffer, X3084]
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=v %s 2>&1 | FileCheck %s --check-prefix=PARAMETER
// PARAMETER: error: `v` is not declared

// RUN: not %clipc -T vs_5_0 -E main -DPLANE=f3 %s 2>&1 | FileCheck %s --check-prefix=FLOAT3
// FLOAT3: clip plane `f3` has type `float3`; a clip plane is a `float4` [clip-plane-not-float4, X3084]
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=h4 %s 2>&1 | FileCheck %s --check-prefix=HALF4
// HALF4: clip plane `h4` has type `half4`; a clip plane is a `float4` [clip-plane-not-float4, X3084]
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=m4 %s 2>&1 | FileCheck %s --check-prefix=MIN16
// MIN16: clip plane `m4` has type `min16float4`; a clip plane is a `float4` [clip-plane-not-float4, X3084]
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=i4 %s 2>&1 | FileCheck %s --check-prefix=INT4
// INT4: clip plane `i4` has type `int4`; a clip plane is a `float4` [clip-plane-not-float4, X3084]
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=matrix4 %s 2>&1 | FileCheck %s --check-prefix=MATRIX
// MATRIX: clip plane `matrix4` has type `float4x4`; a clip plane is a `float4` [clip-plane-not-float4, X3084]
// RUN: not %clipc -T vs_5_0 -E main -DPLANE=planes %s 2>&1 | FileCheck %s --check-prefix=ARRAY
// ARRAY: clip plane `planes` has type `float4[4]`; a clip plane is a `float4` [clip-plane-not-float4, X3084]

cbuffer Planes {
  float4 p, q;
  float4 planes[4];
  float3 f3;
  half4 h4;
  min16float4 m4;
  int4 i4;
  float4x4 matrix4;
  int index;
  bool flag;
};
tbuffer Texture { float4 texture_plane; };
static const float4 kPlane = {0, 0, 1, 0};
static float4 variable;
groupshared float4 shared_plane;
float4 make() { return p; }

[clipplanes(PLANE)]
float4 main(float4 v : POSITION) : SV_Position { return v; }
