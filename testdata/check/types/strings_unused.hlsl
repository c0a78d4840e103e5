// A string that nobody uses is left out wherever it stands.
// RUN: %clipc -T ps_6_0 %s | FileCheck %s
// RUN: %clipc -T ps_6_0 -spirv %s -o %t.spv
// RUN: %draw compare %s -T ps_6_0
// AUTOUPDATE
float4 main(float4 p : P) : SV_Target {
  "words";
  static string kept = "static";
  const string copy = kept;
  for ("first"; p.x < 3; p.x++, "last") {
    string inner = "loop";
    (p.y++, inner);
  }
  if (p.y > 2) {
    string inner = "branch";
    p.z += 1;
  }
  copy;
  return p * (("before a comma", 2));
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec4 vs_P0;  // p : P0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out vec4 SV_Target0;  // main : SV_Target0
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     vec4 p = vs_P0;
// CHECK-NEXT:     for (; p.x < 3.0; p.x++) {
// CHECK-NEXT:         p.y++;
// CHECK-NEXT:     }
// CHECK-NEXT:     if (p.y > 2.0) {
// CHECK-NEXT:         p.z += 1.0;
// CHECK-NEXT:     }
// CHECK-NEXT:     SV_Target0 = p * 2.0;
// CHECK-NEXT: }
