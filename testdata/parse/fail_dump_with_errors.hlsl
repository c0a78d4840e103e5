// --dump=ast shows what the parser read around an error.
// RUN: not %clipc --dump=ast %s 2>&1 | FileCheck %s

// CHECK-DAG: function first : float4
// CHECK-DAG: function second : float4
// CHECK-DAG: error: {{.*}}[missing-semicolon, X3000]
float4 first() { return 1 }
float4 second() { return 2; }
