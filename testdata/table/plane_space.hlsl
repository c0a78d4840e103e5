// The table names the space that the planes must be given in.
// RUN: %clipc --plane-space=xyw1 %s -o %t.vert --table %t.json && FileCheck %s --check-prefix=XYW1 < %t.json
// RUN: %clipc --plane-space=object %s -o %t.vert --table %t.h && FileCheck %s --check-prefix=OBJECT < %t.h
// RUN: %clipc --plane-space=object %s -o %t.vert --reflect %t.json && FileCheck %s --check-prefix=REFLECT < %t.json

float4 plane;
[clipplanes(plane)]
float4 main(float4 position : POSITION) : SV_Position { return position; }

// XYW1: "lowering": "clip-distance",
// XYW1-NEXT: "position_space": "xyw1",
// OBJECT: "clip-distance", "object",
// REFLECT: "positionSpace": "object"
