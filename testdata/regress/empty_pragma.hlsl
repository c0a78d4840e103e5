// A line with nothing behind #pragma ran past the end of the text.
// RUN: %clipc %s -o - | FileCheck %s
#pragma
float4 main(float4 v : POSITION) : SV_Position { return v; }
#pragma
// CHECK: gl_Position
#pragma