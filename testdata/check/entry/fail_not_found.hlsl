// RUN: not %clipc -T vs_5_0 -E VSMian %s 2>&1 | FileCheck %s --check-prefix=NEAR
// RUN: not %clipc -T vs_5_0 -E twice %s 2>&1 | FileCheck %s --check-prefix=TWICE
// RUN: not %clipc -T vs_5_0 -E overloaded %s 2>&1 | FileCheck %s --check-prefix=OVERLOADED
// RUN: not %clipc -T vs_5_0 -E prototype %s 2>&1 | FileCheck %s --check-prefix=DECLARED
// RUN: not %clipc -T vs_5_0 -E q::VSMain %s 2>&1 | FileCheck %s --check-prefix=NONE
// RUN: not %clipc -T vs_5_0 -E something_else_entirely %s 2>&1 | FileCheck %s --check-prefix=HINT
// RUN: not %clipc -T ps_5_0 -E something_else_entirely %s 2>&1 | FileCheck %s --check-prefix=PIXEL
float4 VSMain(float4 v : POSITION) : SV_Position { return v; }
namespace a { float4 twice(float4 v : POSITION) : SV_Position { return v; } }
namespace b { float4 twice(float4 v : POSITION) : SV_Position { return v; } }
float4 overloaded(float4 v : POSITION) : SV_Position { return v; }
float4 overloaded(float3 v : POSITION) : SV_Position { return v.xyzz; }
float4 prototype(float4 v : POSITION) : SV_Position;
// DECLARED: [[#@LINE-1]]:8: error: entry point `prototype` is only declared; it needs a body [entry-only-declared, X3501]
technique T { pass P { VertexShader = compile vs_3_0 VSMain(); PixelShader = compile PS_3_0 a::twice(); } }
// NEAR: error: entry point `VSMian` was not found; did you mean `VSMain`? [entry-not-found, X3501]
// TWICE: error: entry point `twice` may be one of 2 functions; name one of them in full, or rename the others [entry-ambiguous, X3501]
// TWICE: note: candidate: `a::twice`
// TWICE: note: candidate: `b::twice`
// OVERLOADED: error: entry point `overloaded` may be one of 2 functions
// NONE: error: entry point `{{.*}}` was not found
// HINT: error: entry point `something_else_entirely` was not found; its techniques compile `VSMain` [entry-not-found, X3501]
// PIXEL: error: entry point `something_else_entirely` was not found; its techniques compile `twice` [entry-not-found, X3501]
