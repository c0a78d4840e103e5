// Integers are not interpolated. Oracles: fxc's X4576, "signature specifies invalid interpolation mode for integer component type"; DXC's
// rule META.INTEGERINTERPMODE. `sample` is "available in shader model 4.1 and later" ("Struct Type" of Microsoft's HLSL reference).
// RUN: not %clipc -T ps_5_0 -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_6_0 -fsyntax-only %s 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_5_0 -E outputs -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=OUTPUTS
// RUN: %clipc -T ps_5_0 -E right -Wno-sample-overridden -fsyntax-only %s 2>&1 | count 0
// RUN: not %clipc -T ps_4_0 -E samples -fsyntax-only %s 2>&1 | FileCheck %s --check-prefix=SAMPLES
// RUN: %clipc -T ps_4_1 -E samples -Wno-sample-overridden -fsyntax-only %s 2>&1 | count 0
// RUN: %clipc -T ps_5_0 -E both -o - %s 2>&1 | FileCheck %s --check-prefix=BOTH
struct V {
  // CHECK: [[#@LINE+1]]:25: error: `v.a` is `noperspective` and holds integers, which are never interpolated; remove the modifier, or write `nointerpolation` [interpolated-integer, X4576]
  noperspective int a : A;
  float2 b : B;
};
float4 main(V v,
            // CHECK: [[#@LINE+1]]:29: error: `c` is `linear` and holds integers
            linear int4 c : C,
            // CHECK: [[#@LINE+1]]:31: error: `d` is `centroid` and holds integers
            centroid uint d : D,
            // CHECK: [[#@LINE+1]]:29: error: `e` is `sample` and holds integers
            sample bool e : E) : SV_Target {
  return v.a + c + d + e;
}
// OUTPUTS: [[#@LINE+1]]:56: error: `a` is `linear` and holds integers
float4 outputs(float4 p : POSITION, out linear int a : A) : SV_Position { a = 1; return p; }
struct W { int a : A; nointerpolation int2 b : B; linear float c : C; };
float4 right(noperspective W w, nointerpolation uint d : D) : SV_Target { return w.a + w.b.x + w.c + d; }
// SAMPLES: [[#@LINE+1]]:34: error: `sample` needs profile ps_4_1 or later; this is `ps_4_0` [qualifier-profile, X4532]
float4 samples(sample float4 a : A) : SV_Target { return a; }
// BOTH: [[#@LINE+2]]:43: warning: `nointerpolation` overrides `sample`; a value that is not interpolated is the same at every sample [-Wsample-overridden]
// BOTH: layout(location = 0) flat in vec4 vs_A0;
float4 both(nointerpolation sample float4 a : A) : SV_Target { return a; }
