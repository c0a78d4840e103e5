// A dropped plane is a wrong image, so a misspelt attribute is an error, not a warning.
// RUN: not %clipc -T vs_5_0 -E main -DATTRIBUTE=clipplane %s 2>&1 | FileCheck %s -DNAME=clipplane
// RUN: not %clipc -T vs_5_0 -E main -DATTRIBUTE=clipplanez %s 2>&1 | FileCheck %s -DNAME=clipplanez
// RUN: not %clipc -T vs_5_0 -E main -DATTRIBUTE=clip_planes %s 2>&1 | FileCheck %s -DNAME=clip_planes
// RUN: not %clipc -T vs_5_0 -E main -DATTRIBUTE=Clip_Plane %s 2>&1 | FileCheck %s -DNAME=Clip_Plane
// CHECK: error: unknown attribute `[[NAME]]`; did you mean `clipplanes`? without its clip planes the shader draws a wrong image [clip-planes-misspelt]
cbuffer Planes { float4 p; };
[ATTRIBUTE(p)]
float4 main(float4 v : POSITION) : SV_Position { return v; }
