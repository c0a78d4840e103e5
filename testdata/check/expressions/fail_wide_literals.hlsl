// Integers of more than 32 bits come with shader model 6; before it a number that does not fit is an error.
// RUN: not %clipc -T vs_5_0 %s -o %t 2>&1 | FileCheck %s
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK: [[#@LINE+1]]:12: error: 4294967296 does not fit into 32 bits [integer-too-large, X3000]
  uint x = 4294967296;
  // CHECK: [[#@LINE+1]]:3: error: 8589934591 does not fit into 32 bits [integer-too-large, X3000]
  0x1FFFFFFFF;
  int y = 4294967295;
  return p * x + y;
}
