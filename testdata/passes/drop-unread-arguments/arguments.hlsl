// Whole arguments, and the fields of a struct that is made for the call, become zeros.
// RUN: %clipc -T vs_5_0 --dump-after=drop-idle-clip-distances %s | FileCheck %s --check-prefix=BEFORE
// RUN: %clipc -T vs_5_0 --dump-after=drop-unread-arguments %s | FileCheck %s --check-prefix=AFTER
bool is_on;
struct Vertex {
  float4 position : POSITION;
  float3 normal : NORMAL;
};

// BEFORE: main void main.1() {
// BEFORE-NEXT: Vertex v.1 = Vertex{in_POSITION0, in_NORMAL0}
// BEFORE-NEXT: vs_SV_POSITION0 = main(v.1, in_UNREAD0, in_READ0)
// AFTER: main void main.1() {
// AFTER-NEXT: Vertex v.1 = Vertex{in_POSITION0, zero<float3>}
// AFTER-NEXT: vs_SV_POSITION0 = main(v.1, zero<float4>, in_READ0)
float4 main(Vertex v, float4 unread : UNREAD, float2 read : READ) : SV_Position {
  if (is_on) return v.position;
  return read.xyxy;
}
