// The modifiers of inputs and outputs that agree.
// RUN: %clipc -T vs_5_0 --validate %s -o - 2>%t.err | FileCheck %s
// RUN: FileCheck %s --input-file=%t.err --check-prefix=SAID

// CHECK: layout(location = 0) sample out vec4 vs_A0;
// CHECK-NEXT: layout(location = 1) flat out vec4 vs_B0;
// CHECK-NEXT: layout(location = 2) noperspective centroid out vec4 vs_C0;
struct Right {
  // SAID: :[[#@LINE+1]]:26: warning: `sample` overrides `centroid`; a value is read at one place [-Wcentroid-overridden]
  centroid sample float4 a : A;
  // SAID: :[[#@LINE+1]]:33: warning: `nointerpolation` overrides `sample`; {{.*}} [-Wsample-overridden]
  nointerpolation sample float4 b : B;
  linear noperspective centroid float4 c : C;
};
// SAID-NOT: warning
float4 main(float4 p : POSITION, out Right right) : SV_Position {
  right = (Right)p.x;
  return p;
}
