// The operators that a struct cannot overload, as for dxc (err_hlsl_overloading_operator_disallowed).
// RUN: not %clipc -T vs_6_0 %s 2>&1 | FileCheck %s
struct N {
  float x;
  // CHECK: [[#@LINE+1]]:8: error: `operator=` cannot be overloaded; an assignment to a struct copies it, and compound assignments and increments are for numbers [operator-not-overloaded]
  void operator=(N b) { x = b.x * 2; }
  // CHECK: [[#@LINE+1]]:5: error: `operator+=` cannot be overloaded
  N operator+=(N b) { x += b.x; return this; }
  // CHECK: [[#@LINE+1]]:5: error: `operator<<=` cannot be overloaded
  N operator<<=(int b) { return this; }
  // CHECK: [[#@LINE+1]]:5: error: `operator++` cannot be overloaded
  N operator++() { return this; }
  // CHECK-NOT: error
  bool operator==(N b) { return x == b.x; }
  bool operator<=(N b) { return x <= b.x; }
  N operator+(N b) { b.x += x; return b; }
};
float4 main(float4 p : P) : SV_Position { N n = {1}; return p * n.x; }
