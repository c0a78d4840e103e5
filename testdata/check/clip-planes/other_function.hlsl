// RUN: %clipc -T vs_4_0 -E main %s -o - 2>&1 | FileCheck %s
cbuffer Planes { float4 p; };
// CHECK: other_function.hlsl:[[#@LINE+1]]:1: warning: `clipplanes` on `helper` is ignored; it has an effect only on the entry point [-Wclip-planes-not-on-entry]
[clipplanes(p)]
float4 helper(float4 v) { return v * 2; }
// Nothing calls these.
// CHECK: :[[#@LINE+1]]:1: warning: `clipplanes` on `other_entry` is ignored;
[clipplanes(p)] float4 other_entry(float4 v : POSITION) : SV_Position { return v; }
// CHECK: :[[#@LINE+1]]:1: warning: `clipplanes` on `prototype` is ignored;
[clipplanes(p)] float4 prototype(float4 v);
struct S {
  // CHECK: :[[#@LINE+1]]:3: warning: `clipplanes` on `method` is ignored;
  [clipplanes(p)] float4 method() { return 0; }
};
namespace N {
// CHECK: :[[#@LINE+1]]:1: warning: `clipplanes` on `main` is ignored;
[clipplanes(p)] float4 main(float4 v : POSITION) : SV_Position { return v; }
}
float4 main(float4 v : POSITION) : SV_Position { return helper(v); }
// CHECK-NOT: warning:
// CHECK-NOT: gl_ClipDistance
