// Up to shader model 5.0 the views of unordered access come after the render targets: fxc X4509, "UAV registers live in the same name
// space as outputs, so they must be bound to at least u1". A view that nothing uses has no register.
// RUN: not %clipc -T ps_5_0 %s -o - 2>&1 | FileCheck %s
// RUN: %clipc -T ps_5_1 %s -o - 2>&1 | FileCheck %s --check-prefix=NEWER
// RUN: %clipc -T ps_5_0 -E depth %s -o - 2>&1 | FileCheck %s --check-prefix=DEPTH
// RUN: %clipc -T ps_5_0 -E after %s -o - 2>&1 | FileCheck %s --check-prefix=AFTER
// CHECK: [[#@LINE+1]]:26: error: `counts` is bound to register u1; up to shader model 5.0 the render targets have the registers before u3; bind it to one from there on [register-of-target, X4509]
RWStructuredBuffer<uint> counts : register(u1);
RWTexture2D<float> image : register(u3);
RWTexture2D<float> unused : register(u0);
// CHECK-NOT: error
// NEWER: // u1
struct Targets { float4 a : SV_Target0, b : SV_Target2; };
Targets main(float4 p : SV_Position) {
  Targets t = { p, p };
  counts[0] = 1;
  image[uint2(0, 0)] = 1;
  return t;
}
// DEPTH: // u1
float depth(float4 p : SV_Position) : SV_Depth { counts[0] = 1; return p.z; }
// AFTER: // u3
float4 after(float4 p : SV_Position) : SV_Target2 { image[uint2(0, 0)] = 1; return p; }
