// RUN: %clipc --dump=tokens %s | FileCheck %s
#define WIDTH 1
#pragma push_macro("WIDTH")
#undef WIDTH
#define WIDTH 2
WIDTH
#pragma pop_macro("WIDTH")
WIDTH
// CHECK: 2
// CHECK: 1
