// SARIF counts Unicode code points, and says so; text and JSON count bytes, as Clang does. SARIF 2.1.0, 3.14.17 and 3.30.6.
// RUN: not %clipc %s --diagnostics=sarif 2>&1 | FileCheck %s --match-full-lines
// RUN: not %clipc %s --diagnostics=json 2>&1 | FileCheck %s --check-prefix=JSON --match-full-lines
// CHECK:       "columnKind": "unicodeCodePoints",
// CHECK:             "startLine": [[#LINE:]],
// CHECK-NEXT:        "startColumn": 47,
// CHECK-NEXT:        "endLine": [[#LINE]],
// CHECK-NEXT:        "endColumn": 48
// JSON:       "column": 51,
float4 main() : SV_Position { /* 😀ä	*/ return x; }
