// The bits of numbers; older targets get functions of HLSL's names. glslang has GL_ARB_shader_bit_encoding from 1.50 on only.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s --check-prefix=NEW
// RUN: %clipc -T vs_5_0 --target=glsl330 --validate %s -o - | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_5_0 --target=glsl150 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl300 --validate %s -o %t
// RUN: %clipc -T vs_5_0 --target=essl310 --validate %s -o %t
// AUTOUPDATE
uint u;
uint2 u2;
int i;
float f;

float4 main(float4 p : POSITION) : SV_Position {
  uint r = countbits(u) + firstbithigh(u) + firstbithigh(i) + firstbitlow(u) + reversebits(u) + countbits(u2).x + firstbithigh(u2).y;
  r += asuint(f) + asint(f) + asuint(i) + asint(u) + f32tof16(f) + f32tof16(p.xy).y;
  float s = asfloat(u) + asfloat(i) + asfloat(f) + f16tof32(u) + f16tof32(u2).y;
  return p + r + s;
}

// NEW: #version 450
// NEW-EMPTY:
// NEW-NEXT: layout(std140, binding = 0) uniform Globals {  // b0
// NEW-NEXT:     uint u;
// NEW-NEXT:     uint u2_x;
// NEW-NEXT:     uint u2_y;
// NEW-NEXT:     int i;
// NEW-NEXT:     float f;
// NEW-NEXT: } globals;
// NEW-EMPTY:
// NEW-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// NEW-EMPTY:
// NEW-NEXT: uvec2 u2() {  // offset 4
// NEW-NEXT:     return uvec2(globals.u2_x, globals.u2_y);
// NEW-NEXT: }
// NEW-EMPTY:
// NEW-NEXT: uvec2 f32tof16(vec2 a) {
// NEW-NEXT:     return uvec2(packHalf2x16(vec2(a.x, 0.0)), packHalf2x16(vec2(a.y, 0.0)));
// NEW-NEXT: }
// NEW-EMPTY:
// NEW-NEXT: vec2 f16tof32(uvec2 a) {
// NEW-NEXT:     return vec2(unpackHalf2x16(a.x).x, unpackHalf2x16(a.y).x);
// NEW-NEXT: }
// NEW-EMPTY:
// NEW-NEXT: void main() {
// NEW-NEXT:     uint r = uint(bitCount(globals.u)) + uint(findMSB(globals.u)) + uint(findMSB(globals.i)) + uint(findLSB(globals.u)) + bitfieldReverse(globals.u) + uvec2(bitCount(u2())).x + uvec2(findMSB(u2())).y;
// NEW-NEXT:     r += floatBitsToUint(globals.f) + uint(floatBitsToInt(globals.f)) + uint(globals.i) + uint(int(globals.u)) + packHalf2x16(vec2(globals.f, 0.0)) + f32tof16(in_POSITION0.xy).y;
// NEW-NEXT:     float s = uintBitsToFloat(globals.u) + intBitsToFloat(globals.i) + globals.f + unpackHalf2x16(globals.u).x + f16tof32(u2()).y;
// NEW-NEXT:     gl_Position = in_POSITION0 + float(r) + s;
// NEW-NEXT: }

// OLD: #version 330
// OLD-EMPTY:
// OLD-NEXT: layout(std140) uniform Globals {  // b0
// OLD-NEXT:     uint u;
// OLD-NEXT:     uint u2_x;
// OLD-NEXT:     uint u2_y;
// OLD-NEXT:     int i;
// OLD-NEXT:     float f;
// OLD-NEXT: } globals;
// OLD-EMPTY:
// OLD-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// OLD-EMPTY:
// OLD-NEXT: uvec2 u2() {  // offset 4
// OLD-NEXT:     return uvec2(globals.u2_x, globals.u2_y);
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: uint countbits(uint x) {
// OLD-NEXT:     x -= (x >> 1) & 0x55555555u;
// OLD-NEXT:     x = (x & 0x33333333u) + ((x >> 2) & 0x33333333u);
// OLD-NEXT:     x = (x + (x >> 4)) & 0x0F0F0F0Fu;
// OLD-NEXT:     return (x * 0x01010101u) >> 24;
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: uint firstbithigh(uint x) {
// OLD-NEXT:     for (int i = 31; i >= 0; --i) {
// OLD-NEXT:         if (((x >> (i & 31)) & 1u) != 0u) {
// OLD-NEXT:             return uint(i);
// OLD-NEXT:         }
// OLD-NEXT:     }
// OLD-NEXT:     return 0xFFFFFFFFu;
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: uint firstbithigh(int x) {
// OLD-NEXT:     for (int i = 30; i >= 0; --i) {
// OLD-NEXT:         if (((x >> (i & 31)) & 1) != (x < 0 ? 1 : 0)) {
// OLD-NEXT:             return uint(i);
// OLD-NEXT:         }
// OLD-NEXT:     }
// OLD-NEXT:     return 0xFFFFFFFFu;
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: uint firstbitlow(uint x) {
// OLD-NEXT:     for (int i = 0; i < 32; ++i) {
// OLD-NEXT:         if (((x >> (i & 31)) & 1u) != 0u) {
// OLD-NEXT:             return uint(i);
// OLD-NEXT:         }
// OLD-NEXT:     }
// OLD-NEXT:     return 0xFFFFFFFFu;
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: uint reversebits(uint x) {
// OLD-NEXT:     x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
// OLD-NEXT:     x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
// OLD-NEXT:     x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
// OLD-NEXT:     x = ((x >> 8) & 0x00FF00FFu) | ((x & 0x00FF00FFu) << 8);
// OLD-NEXT:     return (x >> 16) | (x << 16);
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: uvec2 countbits(uvec2 x) {
// OLD-NEXT:     x -= (x >> 1) & 0x55555555u;
// OLD-NEXT:     x = (x & 0x33333333u) + ((x >> 2) & 0x33333333u);
// OLD-NEXT:     x = (x + (x >> 4)) & 0x0F0F0F0Fu;
// OLD-NEXT:     return (x * 0x01010101u) >> 24;
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: uvec2 firstbithigh(uvec2 a) {
// OLD-NEXT:     return uvec2(firstbithigh(a.x), firstbithigh(a.y));
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: uint f32tof16(float x) {
// OLD-NEXT:     uint bits = floatBitsToUint(x);
// OLD-NEXT:     uint sign_bit = (bits >> 16) & 0x8000u;
// OLD-NEXT:     bits &= 0x7FFFFFFFu;
// OLD-NEXT:     if (bits > 0x7F800000u) {
// OLD-NEXT:         return sign_bit | 0x7E00u;
// OLD-NEXT:     }
// OLD-NEXT:     if (bits >= 0x477FF000u) {
// OLD-NEXT:         return sign_bit | 0x7C00u;
// OLD-NEXT:     }
// OLD-NEXT:     if (bits < 0x38800000u) {
// OLD-NEXT:         return sign_bit | uint(roundEven(abs(x) * 16777216.0));
// OLD-NEXT:     }
// OLD-NEXT:     return sign_bit | ((bits - 0x38000000u + 0x0FFFu + ((bits >> 13) & 1u)) >> 13);
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: uvec2 f32tof16(vec2 a) {
// OLD-NEXT:     return uvec2(f32tof16(a.x), f32tof16(a.y));
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: float f16tof32(uint x) {
// OLD-NEXT:     uint sign_bit = (x & 0x8000u) << 16;
// OLD-NEXT:     uint exponent = (x >> 10) & 31u;
// OLD-NEXT:     uint mantissa = x & 1023u;
// OLD-NEXT:     if (exponent == 0u) {
// OLD-NEXT:         return uintBitsToFloat(sign_bit | floatBitsToUint(float(mantissa) * exp2(-24.0)));
// OLD-NEXT:     }
// OLD-NEXT:     if (exponent == 31u) {
// OLD-NEXT:         return uintBitsToFloat(sign_bit | 0x7F800000u | (mantissa << 13));
// OLD-NEXT:     }
// OLD-NEXT:     return uintBitsToFloat(sign_bit | ((exponent + 112u) << 23) | (mantissa << 13));
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: vec2 f16tof32(uvec2 a) {
// OLD-NEXT:     return vec2(f16tof32(a.x), f16tof32(a.y));
// OLD-NEXT: }
// OLD-EMPTY:
// OLD-NEXT: void main() {
// OLD-NEXT:     uint r = countbits(globals.u) + firstbithigh(globals.u) + firstbithigh(globals.i) + firstbitlow(globals.u) + reversebits(globals.u) + countbits(u2()).x + firstbithigh(u2()).y;
// OLD-NEXT:     r += floatBitsToUint(globals.f) + uint(floatBitsToInt(globals.f)) + uint(globals.i) + uint(int(globals.u)) + f32tof16(globals.f) + f32tof16(in_POSITION0.xy).y;
// OLD-NEXT:     float s = uintBitsToFloat(globals.u) + intBitsToFloat(globals.i) + globals.f + f16tof32(globals.u) + f16tof32(u2()).y;
// OLD-NEXT:     gl_Position = in_POSITION0 + float(r) + s;
// OLD-NEXT: }
