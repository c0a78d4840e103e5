// Direct3D's own record has no word for the space of the planes.
// RUN: not %clipc --plane-space=object %s -o %t.vert --table %t.bin 2>&1 | FileCheck %s --check-prefix=BIN

float4 plane;
[clipplanes(plane)]
float4 main(float4 position : POSITION) : SV_Position { return position; }

// BIN: error: cannot write `{{.*}}.bin`: the binary form holds planes in clip space only; these are in space object
