// RUN: %clipc --dump=tokens %s 2>&1 | FileCheck %s
#line 100 "generated.hlsl"
#warning from the generator
// CHECK: generated.hlsl:100:2: warning: from the generator [-Wwarning-directive]
before __LINE__
// CHECK: generated.hlsl:
// CHECK-NEXT: 102:1 {{ *}}identifier before
// CHECK-NEXT: int 102
