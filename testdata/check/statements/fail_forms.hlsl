// Forms of declarations that fxc and DXC refuse.
// RUN: not %clipc -T vs_6_0 %s -o %t 2>&1 | FileCheck %s
// RUN: not %clipc -T vs_6_0 -DLISTS %s -o %t 2>&1 | FileCheck %s --check-prefix=LISTS
// RUN: not %clipc -T ms_6_5 -DPIXEL %s -o %t 2>&1 | FileCheck %s --check-prefix=PIXEL
// AUTOUPDATE
#if defined(LISTS)
float4 main(float4 p : POSITION) : SV_Position {
  float2 a = {1, 2};
// LISTS: fail_forms.hlsl:[[#@LINE+3]]:11: error: unexpected `{`; expected an expression [unexpected-token, X3000]
// LISTS-NEXT:    [[#@LINE+2]] |   a = a + {1, 2};
// LISTS-NEXT:       |           ^
  a = a + {1, 2};
// LISTS-NEXT: fail_forms.hlsl:[[#@LINE+3]]:21: error: unexpected `return`; expected `{` after `switch (...)` [unexpected-token, X3000]
// LISTS-NEXT:    [[#@LINE+2]] |   switch ((int)p.x) return p;
// LISTS-NEXT:       |                     ^~~~~~
  switch ((int)p.x) return p;
  return p;
}
#elif defined(PIXEL)
float4 main(float4 p : POSITION) : SV_Position { return p; }
#else
// CHECK: fail_forms.hlsl:[[#@LINE+3]]:13: error: `float` is the underlying type of an enum; it must be an integer type [enum-not-integer, X3000]
// CHECK-NEXT:    [[#@LINE+2]] | enum Real : float { kOne };
// CHECK-NEXT:       |             ^~~~~
enum Real : float { kOne };
// CHECK-NEXT: fail_forms.hlsl:[[#@LINE+3]]:44: error: `input` of type `Texture2D<float4>` cannot be an input or output of the entry point [semantic-on-object, X3530]
// CHECK-NEXT:    [[#@LINE+2]] | float4 main(float4 p : POSITION, Texture2D input : TEXTURE) : SV_Position { return p + kOne; }
// CHECK-NEXT:       |                                            ^~~~~
float4 main(float4 p : POSITION, Texture2D input : TEXTURE) : SV_Position { return p + kOne; }
#endif

// PIXEL: clipc: error: profile `ms_6_5` is for none of vertex, hull, domain, geometry, pixel and compute shaders; clipc compiles no others, use dxc or glslang for them [other-stage-profile]
