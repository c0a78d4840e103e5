// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
float a = 1abc;
// CHECK: [[#@LINE-1]]:11: error: `1abc` is not a number; the suffixes are u, l, ll, f and h [invalid-number, X3000]
// CHECK-NEXT: float a = 1abc;
// CHECK-NEXT: {{^ *\|           \^~~~$}}
int b = 089;
// CHECK: [[#@LINE-1]]:9: error: `089` is not a number; digits after a leading 0 are octal [invalid-number, X3000]
int c = 18446744073709551616;
// CHECK: [[#@LINE-1]]:9: error: `18446744073709551616` is not a number; an integer has at most 64 bits [invalid-number, X3000]
float d = 1e39;
// CHECK: [[#@LINE-1]]:11: warning: `1e39` is too large for its type and becomes infinity [-Wfloat-literal-range]
