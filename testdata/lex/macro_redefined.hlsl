// RUN: %clipc --dump=tokens %s -DB=1 2>&1 | FileCheck %s
#define A 1
#define A 2
// CHECK: macro_redefined.hlsl:3:9: warning: 'A' macro redefined [-Wmacro-redefined]
// CHECK: macro_redefined.hlsl:2:9: note: previous definition is here
#define B 2
// CHECK: macro_redefined.hlsl:6:9: warning: 'B' macro redefined
// CHECK: <command line>:1:9: note: previous definition is here
