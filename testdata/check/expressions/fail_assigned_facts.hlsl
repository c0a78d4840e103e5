// The value of a call is not a variable, also where it is an input of the shader.
// RUN: not %clipc -T cs_6_0 %s 2>&1 | FileCheck %s
RWStructuredBuffer<uint> values;
[numthreads(32, 1, 1)] void main(uint id : SV_GroupIndex) {
  id = 1;
  // CHECK: [[#@LINE+1]]:3: error: this cannot be assigned to; {{.*}} [not-assignable, X3025]
  WaveGetLaneIndex() = 3;
  // CHECK: [[#@LINE+1]]:3: error: this cannot be assigned to; {{.*}} [not-assignable, X3025]
  WaveGetLaneCount()++;
  values[id] = 1;
}
