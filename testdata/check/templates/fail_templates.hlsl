// RUN: not %clipc -T vs_6_6 -E main %s 2>&1 | FileCheck %s
// CHECK-DAG: error: templates have more than 4096 instances [too-many-instances]
template<int N> float endless(float x) { return endless<N + 1>(x); }
template<typename T> T of_nothing() { return 0; }
template<typename T> T larger(T a, T b) { return a > b ? a : b; }
float4 main(float4 p : POSITION) : SV_Position {
  // CHECK-DAG: [[#@LINE+1]]:3: error: no function `of_nothing` takes () [no-matching-function, X3013]
  of_nothing();
  int i = 1;
  // CHECK-DAG: [[#@LINE+1]]:3: error: no function `larger` takes (int, float) [no-matching-function, X3013]
  larger(i, p.x);
  // CHECK-DAG: [[#@LINE+1]]:3: error: no function `larger` takes (int, float) [no-matching-function, X3013]
  larger(1, 2.5);
  // A literal becomes what the other argument is, but not if it loses its fraction: [temp.deduct.call] of C++, which DXC follows.
  // CHECK-DAG: [[#@LINE+1]]:3: error: no function `larger` takes (int, float) [no-matching-function, X3013]
  larger(i, 2.5);
  return p * endless<0>(1);
}
