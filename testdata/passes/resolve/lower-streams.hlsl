// Append is a call of the function that writes the outputs and emits them; a stream is not a parameter of other functions.
// RUN: %clipc %s -T gs_5_0 --dump-after=lower-streams | FileCheck %s
// RUN: %draw compare %s -T gs_5_0 --target=glsl410,glsl450
struct V { float4 p : SV_Position; };

// CHECK: append_stream(
// CHECK: emit vertex
// CHECK: Add(V
// CHECK-NOT: TriangleStream
// CHECK: append_stream(
// CHECK: end primitive
void Add(V v, inout TriangleStream<V> to, bool ends) {
  to.Append(v);
  if (ends) to.RestartStrip();
}

[maxvertexcount(3)]
void main(triangle V v[3], inout TriangleStream<V> stream) {
  for (uint i = 0; i < 3; ++i) Add(v[i], stream, i == 2);
}
