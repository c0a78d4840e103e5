// A macro that is an operand of `##`: fxc expands it first, from an argument (DXC's issues 1005, 1089) or in the definition itself (issue
// 2158); dxc does not, except from an argument under -flegacy-macro-expansion. The tokens here are those that fxc makes of these lines.
// RUN: %clipc --dump=tokens %s -T vs_5_0 2>&1 | FileCheck %s --check-prefix=FXC --implicit-check-not=warning
// RUN: %clipc --dump=tokens %s -T vs_6_0 -flegacy-macro-expansion 2>&1 | FileCheck %s --check-prefix=FXC --implicit-check-not=warning
// RUN: %clipc --dump=tokens %s -T vs_6_0 2>&1 | FileCheck %s --check-prefixes=DXC,WARN
// RUN: %clipc --dump=tokens %s -T vs_6_0 -Wno-pasted-macro 2>&1 | FileCheck %s --check-prefix=DXC --implicit-check-not=warning

#define SLOT 3
#define CB(n) b##n
CB(SLOT)
// FXC: identifier b3
// WARN: :[[#@LINE-2]]:1: warning: `SLOT` beside `##` is not expanded, as in dxc; fxc expands it first; `-flegacy-macro-expansion` does so too [-Wpasted-macro]

#define KIND_spot 2
#define IS(k) (KIND_##k == 2)
#define light spot
#if IS(light)
taken
#else
not_taken
#endif
// FXC: identifier taken
// WARN: :[[#@LINE-6]]:5: warning: `light` beside `##`

#define W 4
#define FLOAT float##W
FLOAT
// FXC: identifier float4
// WARN: :[[#@LINE-2]]:1: warning: `W` beside `##`

// What an operand becomes is not expanded again inside of itself, and macros with parameters are not operands.
#define SELF SELF##_
#define CALL(x) x
#define FIRST SECOND
#define SECOND last
#define CHAIN(x) x##FIRST
#define NAMES(a, b) x##a##_##b##_##CALL a
SELF CHAIN(SELF) NAMES(W, SLOT)
// FXC: identifier SELF_
// FXC: identifier SELF_last
// FXC: identifier x4_3_CALL
// FXC-NEXT: int 4

// C's own way around it gives the same everywhere.
#define PASTE(a, b) PASTE1(a, b)
#define PASTE1(a, b) a##b
PASTE(float, W)
// FXC: identifier float4
// WARN-NOT: `PASTE1`

// DXC: identifier bSLOT
// DXC: identifier not_taken
// DXC: identifier floatW
// DXC: identifier float4
