// RUN: not %clipc %s 2>&1 | FileCheck %s
#if 1
#error no vertex data
#endif
// CHECK: fail_error_directive.hlsl:3:2: error: no vertex data [error-directive]
#if undefined_function(1)
#endif
// CHECK: :6:5: error: {{.*}}undefined_function{{.*}} [preprocessor-error, X1500]
