// `|=` and `&=` of truths evaluate both sides, in every profile: only `&&`, `||` and `?:` may leave one out (DXC's
// SpirvEmitter::processBinaryOp emits both operands of BO_OrAssign). A side without effects may be left out.
// RUN: %clipc -T ps_6_0 %s | FileCheck %s
// RUN: %clipc -T ps_5_0 %s | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
// AUTOUPDATE
cbuffer Scene { float4 spheres[2]; };

bool Hit(float2 place, float4 sphere, inout float nearest) {
  float distance_to = distance(place, sphere.xy);
  nearest = min(nearest, distance_to);
  return distance_to < sphere.w;
}

float4 main(float2 place : PLACE) : SV_Target {
  float nearest = 1000;
  bool hit = Hit(place, spheres[0], nearest), inside = hit;
  hit |= Hit(place, spheres[1], nearest);
  inside &= Hit(place.yx, spheres[1], nearest);
  hit |= place.x > 3;
  return float4(nearest, hit, inside, 1);
}

// CHECK: #version 450
// CHECK-EMPTY:
// CHECK-NEXT: layout(std140, binding = 0) uniform Scene {  // b0
// CHECK-NEXT:     vec4 spheres[2];
// CHECK-NEXT: } scene;
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) in vec2 vs_PLACE0;  // place : PLACE0
// CHECK-EMPTY:
// CHECK-NEXT: layout(location = 0) out vec4 SV_Target0;  // main : SV_Target0
// CHECK-EMPTY:
// CHECK-NEXT: bool Hit(vec2 place, vec4 sphere, inout float nearest) {
// CHECK-NEXT:     float distance_to = distance(place, sphere.xy);
// CHECK-NEXT:     nearest = min(nearest, distance_to);
// CHECK-NEXT:     return distance_to < sphere.w;
// CHECK-NEXT: }
// CHECK-EMPTY:
// CHECK-NEXT: void main() {
// CHECK-NEXT:     float nearest = 1000.0;
// CHECK-NEXT:     bool hit = Hit(vs_PLACE0, scene.spheres[0], nearest);
// CHECK-NEXT:     bool inside = hit;
// CHECK-NEXT:     hit = any(bvec2(hit, Hit(vs_PLACE0, scene.spheres[1], nearest)));
// CHECK-NEXT:     inside = all(bvec2(inside, Hit(vs_PLACE0.yx, scene.spheres[1], nearest)));
// CHECK-NEXT:     hit = hit || vs_PLACE0.x > 3.0;
// CHECK-NEXT:     SV_Target0 = vec4(nearest, float(hit), float(inside), 1.0);
// CHECK-NEXT: }
