// The modifiers that agree, and those that do not: what fxc says of each pair is in DXC's
// varmods-syntax_noerr.hlsl.
// RUN: not %clipc -T vs_5_0 -E wrong %s 2>&1 | FileCheck %s --check-prefix=WRONG
// RUN: %clipc -T vs_5_0 --validate %s -o - 2>%t.err | FileCheck %s
// RUN: FileCheck %s --input-file=%t.err --check-prefix=SAID

// WRONG: :[[#@LINE+1]]:48: error: `nointerpolation` and `centroid` are used together; remove one of them [interpolation-conflict, X3048]
struct Wrong { nointerpolation centroid float4 c : C; };
// WRONG: :[[#@LINE+2]]:92: error: `nointerpolation` and `linear` are used together
// WRONG: :[[#@LINE+1]]:38: error: `nointerpolation` and `noperspective` are used together
nointerpolation noperspective float4 wrong(float4 p : P, nointerpolation linear out float4 a : A, out Wrong w) : B {
  a = p;
  w = (Wrong)p.x;
  return p;
}

// CHECK: layout(location = 0) sample out vec4 vs_A0;
// CHECK-NEXT: layout(location = 1) flat sample out vec4 vs_B0;
// CHECK-NEXT: layout(location = 2) noperspective centroid out vec4 vs_C0;
struct Right {
  // SAID: :[[#@LINE+1]]:26: warning: `sample` overrides `centroid`; a value is read at one place [-Wcentroid-overridden]
  centroid sample float4 a : A;
  nointerpolation sample float4 b : B;
  linear noperspective centroid float4 c : C;
};
// SAID-NOT: warning
float4 main(float4 p : POSITION, out Right right) : SV_Position {
  right = (Right)p.x;
  return p;
}
