// Templates come with HLSL 2021 and enums with 2017. Oracles: DXC's tests cpp-errors.hlsl, "'template' is a reserved keyword in HLSL",
// and cpp-errors-hv2015.hlsl, "enum is unsupported in HLSL before 2017".
// RUN: not %clipc -T vs_6_0 -HV 2016 -fsyntax-only %s 2>&1 | FileCheck %s --check-prefixes=CHECK,OLD
// RUN: not %clipc -T vs_6_0 -HV 2018 -fsyntax-only %s 2>&1 | FileCheck %s --check-prefixes=CHECK,YOUNGER
// RUN: %clipc -T vs_6_0 -fsyntax-only %s 2>&1 | count 0
// CHECK: [[#@LINE+1]]:24: error: templates come with HLSL 2021; this is HLSL 201{{[68]}} [language-needed]
template<typename T> T twice(T x) { return x + x; }
// CHECK: [[#@LINE+1]]:29: error: templates come with HLSL 2021
template<typename T> struct Pair { T a, b; };
// OLD: [[#@LINE+2]]:1: error: enums come with HLSL 2017; this is HLSL 2016 [language-needed]
// YOUNGER-NOT: error:
enum class Kind { kOne, kTwo };
float4 main(float4 p : POSITION) : SV_Position {
  return p;
}
