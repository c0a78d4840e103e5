// A hexadecimal number without a suffix is a uint up to vs_5_1, as fxc has it, and an int from 6.0 on. Direct3D 9 counts in floats.
// RUN: %clipc -T vs_5_1 %s -o - | FileCheck %s --check-prefix=UINT
// RUN: %clipc -T vs_6_0 %s -o - | FileCheck %s --check-prefix=INT
// RUN: %draw compare %s -T vs_5_0
// UINT: gl_Position = vec4(float(uint(in_INDEX0) ^ 3u), float(in_INDEX0 >> 1u), float(uint(in_INDEX0) > 7u), float(in_INDEX0 / 2));
// INT: gl_Position = vec4(float(in_INDEX0 ^ 3), float(in_INDEX0 >> 1), float(in_INDEX0 > 7), float(in_INDEX0 / 2));
float4 main(int i : INDEX) : SV_Position { return float4(i ^ 0x3, i >> 0x1, i > 0x7, i / 2); }
