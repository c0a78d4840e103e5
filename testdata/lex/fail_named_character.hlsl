// `\N{...}` of C++23 is not HLSL: no character has a name.
// RUN: not %clipc -T vs_5_0 %s 2>&1 | FileCheck %s
float4 main() : SV_Position {
  // CHECK: [[#@LINE+1]]:12: error: 'LATIN SMALL LETTER A' is not a valid Unicode character name [preprocessor-error, X1500]
  float \N{LATIN SMALL LETTER A} = 1;
  return 1;
}
