// RUN: %clipc --dump=tokens %s | FileCheck %s
0 42 017 0x1F 5u 5UL 5ll 5ull 4294967295
// CHECK:      int 0
// CHECK-NEXT: int 42
// CHECK-NEXT: int 15
// CHECK-NEXT: hexadecimal 31
// CHECK-NEXT: uint 5
// CHECK-NEXT: uint 5
// CHECK-NEXT: int64 5
// CHECK-NEXT: uint64 5
// CHECK-NEXT: int 4294967295
.5 1. 1.f 1e3 1.5h 2.0L 1f
// CHECK-NEXT: float 0.5
// CHECK-NEXT: float 1
// CHECK-NEXT: float 1
// CHECK-NEXT: float 1000
// CHECK-NEXT: half 1.5
// CHECK-NEXT: double 2
// CHECK-NEXT: float 1
1.#INF 1.#IND -1.#INF
// CHECK-NEXT: float inf
// CHECK-NEXT: float nan
// CHECK-NEXT: -
// CHECK-NEXT: float inf
1.0.yyy 1.xxx 1..xxxx 0x1e+2
// CHECK-NEXT: :1 {{ *}}float 1
// CHECK-NEXT: :4 {{ *}}~.
// CHECK-NEXT: :5 {{ *}}~identifier yyy
// CHECK-NEXT: int 1
// CHECK-NEXT: ~.
// CHECK-NEXT: ~identifier xxx
// CHECK-NEXT: float 1
// CHECK-NEXT: ~.
// CHECK-NEXT: ~identifier xxxx
// CHECK-NEXT: hexadecimal 30
// CHECK-NEXT: ~+
// CHECK-NEXT: ~int 2
"two " "halves" 'a'
// CHECK-NEXT: string "two halves"
// CHECK-NEXT: int 97
// CHECK-NEXT: end
