// `#pragma` alone on a line, or at the end of the file, has no effect.
// RUN: %clipc %s -o - | FileCheck %s
#pragma
float4 main(float4 v : POSITION) : SV_Position { return v; }
#pragma
// CHECK: gl_Position
#pragma