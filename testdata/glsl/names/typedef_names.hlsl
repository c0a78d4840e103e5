// A struct without a name is called like the typedef that it stands in.
// RUN: %clipc -T vs_5_0 %s --validate -o - | FileCheck %s
// CHECK: struct Unnamed {
// CHECK: struct vertex_in {
// CHECK-NOT: struct
typedef struct { float4 p : POSITION; float k : K; } vertex_in;
static struct { float4 sum; } state;
float4 f(vertex_in v) { return v.p * v.k; }
float4 g() { return state.sum; }
float4 main(vertex_in v) : SV_Position {
  state.sum = f(v);
  return g() + f(v);
}
