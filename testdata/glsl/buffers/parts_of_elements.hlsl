// A store to a part of an element of a structured buffer stores that part alone: another invocation
// may change the others at the same time. Oracles: store_structured in a listing of fxc, which has a mask and a byte offset;
// "gep + store for each component that we're writing to" in DXC's EmitStoreThroughExtVectorComponentLValue.
// RUN: %clipc %s -T ps_5_0 --validate -o - 2>&1 | FileCheck %s
struct Inner { float2 a; int b, c; };
struct Aligned { float4 color; Inner inner; float4 rows[2]; };
struct Tight { float3 color; bool seen; Inner inner; float last; float2 list[2]; };
RWStructuredBuffer<Aligned> aligned : register(u1);
RWStructuredBuffer<Tight> tight : register(u2);
RWStructuredBuffer<float4> vectors : register(u3);
RWStructuredBuffer<float1> ones : register(u4);
RWStructuredBuffer<float4x3> matrices : register(u5);
RWStructuredBuffer<int4> counts : register(u6);

void change(inout int x, out float2 y) { x *= 2; y = x; }

float4 main(float4 p : SV_Position, int k : K, int n : N) : SV_Target {
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
  // CHECK-NEXT: vectors[i].x = gl_FragCoord.x;
  // CHECK-NEXT: vectors[i].z = gl_FragCoord.y;
  vectors[i].xz = p.xy;
  // CHECK-NEXT: vectors[i].yzw = gl_FragCoord.yxz;
  vectors[i].zyw = p.xyz;
  // CHECK-NEXT: vectors[i] = vec4({{.*}}).wzyx;
  vectors[i].wzyx = p;
  // CHECK-NEXT: vectors[i][vs_K0] = 2.0;
  vectors[i][k] = 2;
  // CHECK-NEXT: vectors[i][ivec2(0, 3)[vs_K0]] = 2.0;
  vectors[i].xw[k] = 2;
  // CHECK-NEXT: aligned[i].rows[vs_K0].x = gl_FragCoord.x;
  // CHECK-NEXT: aligned[i].rows[vs_K0].w = gl_FragCoord.y;
  aligned[i].rows[k].xw = p.xy;
  // CHECK-NEXT: tight_store_part_at(i, vs_K0, 1.0);
  tight[i].color[k] = 1;
  // CHECK-NEXT: tight_store_part_at(i, 2 * vs_K0 + 9, gl_FragCoord.xy);
  tight[i].list[k] = p.xy;
  // CHECK-NEXT: matrices[i][1] = gl_FragCoord.xyz;
  matrices[i][1] = p.xyz;
  // CHECK-NEXT: matrices[i][1].yz = gl_FragCoord.xy;
  matrices[i][1].yz = p.xy;
  // CHECK-NEXT: matrices[i][0].yz = gl_FragCoord.yx;
  // CHECK-NEXT: matrices[i][3][1] = gl_FragCoord.z;
  matrices[i]._m02_m01_m31 = p.xyz;
  // What chooses the element and the component is evaluated once, and before what may change it.
  // CHECK-NEXT: vec2 [[T:[a-z0-9_]+]] = vec2(float(n++), float(n++));
  // CHECK-NEXT: vectors[n].x = [[T]].x;
  // CHECK-NEXT: vectors[n].z = [[T]].y;
  vectors[n].xz = float2(n++, n++);
  // CHECK-NEXT: atomicAdd(counts[i][vs_K0], 1);
  InterlockedAdd(counts[i][k], 1);
  // CHECK: vectors[i].w =
  return vectors[i].w = p.x;
}
