// A file's own typedef of a name of 16, 32 or 64 bits is meant, as in older headers (DXC's test typedef_fixed_width_types_pre_2018.hlsl).
// RUN: %clipc -T vs_6_0 -HV 2017 %s --validate | FileCheck %s
typedef uint uint16_t;
typedef int int16_t;
typedef float float16_t;
typedef float float64_t;
struct Packed { uint16_t a; float16_t b; };
// CHECK: uint a;
// CHECK-NEXT: float b;
Packed given;
float64_t wide;
// CHECK: float wide() {
float4 main(int16_t id : ID) : SV_Position { return given.a + given.b + uint16_t(id) + wide; }
