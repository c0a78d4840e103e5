// RUN: %clipc -T vs_4_0 -E main %s -o - 2>&1 | FileCheck %s
cbuffer Planes { float4 p; };
// CHECK: other_function.hlsl:[[#@LINE+1]]:1: warning: `clipplanes` on `helper` is ignored; it has an effect only on the entry point [-Wclip-planes-not-on-entry]
[clipplanes(p)]
float4 helper(float4 v) { return v * 2; }
// Nothing calls these.
// CHECK: :[[#@LINE+1]]:1: warning: `clipplanes` on `unused` is ignored;
[clipplanes(p)] float4 unused(float4 v) { return v; }
// CHECK: :[[#@LINE+1]]:1: warning: `clipplanes` on `prototype` is ignored;
[clipplanes(p)] float4 prototype(float4 v);
struct S {
  // CHECK: :[[#@LINE+1]]:3: warning: `clipplanes` on `method` is ignored;
  [clipplanes(p)] float4 method() { return 0; }
};
// CHECK: :[[#@LINE+1]]:1: warning: `clipplanes` on `called_entry` is ignored;
[clipplanes(p)] float4 called_entry(float4 v : POSITION) : SV_Position { return v; }
float4 main(float4 v : POSITION) : SV_Position { return called_entry(helper(v)); }
// Other shaders of the file keep their planes.
namespace N {
[clipplanes(p)] float4 main(float4 v : POSITION) : SV_Position { return v; }
}
struct Vertex { float4 position : SV_Position; };
[clipplanes(p)] void other_entry(out Vertex v) { v.position = 0; }
// CHECK-NOT: warning:
// CHECK-NOT: gl_ClipDistance
