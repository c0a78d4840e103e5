// A store to a part of an element of a structured buffer stores that part alone: another invocation
// may change the others at the same time, as by store_structured in a listing of fxc.
// RUN: %clipc %s -T ps_5_0 --validate -o - 2>&1 | FileCheck %s
struct Inner { float2 a; int b, c; };
struct Aligned { float4 color; Inner inner; float4 rows[2]; };
struct Tight { float3 color; bool seen; Inner inner; float last; };
RWStructuredBuffer<Aligned> aligned : register(u1);
RWStructuredBuffer<Tight> tight : register(u2);
RWStructuredBuffer<float4> vectors : register(u3);
RWStructuredBuffer<float1> ones : register(u4);

void change(inout int x, out float2 y) { x *= 2; y = x; }

float4 main(float4 p : SV_Position) : SV_Target {
  const int i = int(p.x);
  // CHECK: void main() {
  // CHECK: aligned[i].color = vec4(
  aligned[i].color = p;
  // CHECK-NEXT: aligned[i].inner = Inner(vec2(0.0), 0, 0);
  aligned[i].inner = (Inner)0;
  // CHECK-NEXT: aligned[i].inner.a.y = 2.0;
  aligned[i].inner.a.y = 2;
  // CHECK-NEXT: aligned[i].rows[1].yz = gl_FragCoord.xy;
  aligned[i].rows[1].yz = p.xy;
  // CHECK: Aligned [[A:[a-z0-9_]+]] = aligned[i];
  // CHECK-NEXT: [[A]].inner.b += 3;
  // CHECK-NEXT: aligned[i].inner.b = [[A]].inner.b;
  aligned[i].inner.b += 3;
  // CHECK: tight_store3_at(i, true);
  tight[i].seen = true;
  // CHECK-NEXT: tight_store4_at(i, Inner(
  tight[i].inner = (Inner)1;
  // CHECK-NEXT: tight_store4_at(i, gl_FragCoord.xy);
  tight[i].inner.a = p.xy;
  // CHECK-NEXT: tight_store1_at(i, gl_FragCoord.xy);
  tight[i].color.gb = p.xy;
  // CHECK: tight_store6_at(i,
  // CHECK: tight_store4_at(i,
  change(tight[i].inner.b, tight[i].inner.a);
  // CHECK-NEXT: vectors[i].w = 1.0;
  vectors[i][3] = 1;
  // CHECK-NEXT: ones[i] = 1.0;
  ones[i].x = 1;
  // CHECK-NEXT: vec4 [[V:[a-z0-9_]+]] = vectors[i];
  // CHECK-NEXT: [[V]].xz = gl_FragCoord.xy;
  // CHECK-NEXT: vectors[i] = [[V]];
  vectors[i].xz = p.xy;
  // CHECK: vectors[i].w =
  return vectors[i].w = p.x;
}
