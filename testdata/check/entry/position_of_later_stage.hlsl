// A plain output POSITION in a file with a hull, domain or geometry shader: that may write the position, so nothing is said.
// RUN: %clipc -T vs_5_0 -E vs -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T vs_5_0 -E vs -DALONE -fsyntax-only %s 2>&1 | FileCheck %s
struct V {
  // CHECK: [[#@LINE+1]]:21: warning: `POSITION` is an output like any other under `vs_5_0`, and nothing is the position;
  float4 position : POSITION;
};
V vs(float4 p : POSITION) { V v; v.position = p; return v; }
#ifndef ALONE
struct G { float4 position : SV_Position; };
[maxvertexcount(3)]
void gs(triangle V v[3], inout TriangleStream<G> stream) {
  for (int i = 0; i < 3; i++) { G g; g.position = v[i].position; stream.Append(g); }
}
#endif
