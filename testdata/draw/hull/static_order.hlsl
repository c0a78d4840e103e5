// The function of the constants runs by itself: statics that the control points change have their first values there, and first values
// that are computed are computed again.
// RUN: %clipc -T hs_5_0 --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T hs_5_0
struct Vertex { float4 position : POSITION; };
struct Constants { float edges[3] : SV_TessFactor; float inside : SV_InsideTessFactor; };

static float count = 1;
float Next() { return ++count; }
static float first = Next();
static float unnamed = Next();
static float untouched = 3;

Constants OfPatch(InputPatch<Vertex, 3> patch) {
  Constants c;
  c.edges[0] = count;
  c.edges[1] = first;
  c.edges[2] = untouched;
  c.inside = Next();
  return c;
}
// CHECK: void main() {
// CHECK-NEXT: first = Next();
// CHECK-NEXT: unnamed = Next();
// CHECK: if (gl_InvocationID == 0) {
// CHECK-NEXT: count = 1.0;
// CHECK-NEXT: first = Next();
// CHECK-NEXT: unnamed = Next();
// CHECK: c.edges[0] = count;
[domain("tri")] [partitioning("integer")] [outputtopology("triangle_cw")] [outputcontrolpoints(3)] [patchconstantfunc("OfPatch")]
Vertex main(InputPatch<Vertex, 3> patch, uint id : SV_OutputControlPointID) {
  Vertex v = patch[id];
  v.position += count + first;
  count += 5;
  first += 2;
  return v;
}
