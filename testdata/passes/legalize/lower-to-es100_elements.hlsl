// Elements of an index that is not constant are chosen by helper functions; vectors take the index of a loop.
// RUN: %clipc -T vs_5_0 --target=essl100 --verify --dump-after=lower-to-es100 --stop-after=lower-to-es100 %s | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=essl100 --validate %s -o %t
// RUN: %draw compare %s -T vs_5_0 --target essl100,glsl450 --lower none --ints 0..1
// AUTOUPDATE
struct Part {
  float3 v[2];
  float2x3 m;
};
float Change(inout float x, out float y, float z) {
  y = x + z;
  return x *= 2;
}
void Set(inout float3 x) { x += 1; }

float4 main(float4 p : POSITION, int2 i : I) : SV_Position {
  Part parts[2] = {{{p.xyz, p.yzw}, p.xyz, p.yyy}, {{p.wzy, p.xxx}, p.zzz, p.www}};
  float4 sum = p;
  for (int k = 0; k < 3; k++) sum[k] += p[k + 1];
  sum[i.x] = parts[i.x].v[i.y].z;
  parts[i.y].v[i.x].yz *= 2;
  parts[1].m[i.x][i.y] = 7;
  parts[i.x].m._m10 = 3;
  sum.w += Change(parts[i.x].v[1].x, sum[i.y], p.x);
  Set(parts[0].v[i.y]);
  sincos(p.x, sum[i.x], parts[i.y].v[0].y);
  int counts[3] = {1, 2, 3};
  sum.x += counts[i.x++]++ + --counts[i.x];
  return sum + parts[0].v[1].xyzx + parts[i.y].m[1].xyzx + counts[1];
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: struct Part {
// CHECK-NEXT:   float3 v[2]
// CHECK-NEXT:   float2x3 m
// CHECK-NEXT: }
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: input int2 in_I0 : I0 location 1
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: float Change(inout float x, out float y, float z) {
// CHECK-NEXT:   y = x + z
// CHECK-NEXT:   return x *= 2.0
// CHECK-NEXT: }
// CHECK-NEXT: void Set(inout float3 x.1) {
// CHECK-NEXT:   x.1 += splat<float3>(1.0)
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   int index
// CHECK-NEXT:   float value.1
// CHECK-NEXT:   int index.1
// CHECK-NEXT:   float value.2
// CHECK-NEXT:   float result.1
// CHECK-NEXT:   int index.2
// CHECK-NEXT:   float3 value.3
// CHECK-NEXT:   int2 i = in_I0
// CHECK-NEXT:   Part parts[2] = Part[2]{Part{float3[2]{in_POSITION0.xyz, in_POSITION0.yzw}, float2x3(in_POSITION0.xyz, in_POSITION0.yyy)}, Part{float3[2]{in_POSITION0.wzy, in_POSITION0.xxx}, float2x3(in_POSITION0.zzz, in_POSITION0.www)}}
// CHECK-NEXT:   float4 sum = in_POSITION0
// CHECK-NEXT:   for (int k = 0; k < 3; k++) {
// CHECK-NEXT:     sum[k] += in_POSITION0[k + 1]
// CHECK-NEXT:   }
// CHECK-NEXT:   set_element(i.x, element.1(element.2(parts, i.x).v, i.y).z, sum)
// CHECK-NEXT:   assign_multiply_element_field0_element_yz(i.y, i.x, splat<float2>(2.0), parts)
// CHECK-NEXT:   set_element_element(i.x, i.y, 7.0, parts[1].m)
// CHECK-NEXT:   set_element_field1_1_0(i.x, 3.0, parts)
// CHECK-NEXT:   float value
// CHECK-NEXT:   (value = ((((((index = i.x), (value.1 = element.2(parts, index).v[1].x)), (index.1 = i.y)), (result.1 = Change(value.1, value.2, in_POSITION0.x))), set_element_field0_1_x(index, value.1, parts)), set_element(index.1, value.2, sum)), result.1), (sum.w += value)
// CHECK-NEXT:   (((index.2 = i.y), (value.3 = element.1(parts[0].v, index.2))), Set(value.3)), set_element.1(index.2, value.3, parts[0].v)
// CHECK-NEXT:   sincos_element_element_field0_0_y(in_POSITION0.x, i.x, i.y, sum, parts)
// CHECK-NEXT:   int counts[3] = int[3]{1, 2, 3}
// CHECK-NEXT:   sum.x += convert<float>(post_increment_element(i.x++, counts) + pre_decrement_element(i.x, counts))
// CHECK-NEXT:   vs_SV_POSITION0 = ((sum + parts[0].v[1].xyzx) + element.2(parts, i.y).m[1].xyzx) + splat<float4>(convert<float>(counts[1]))
// CHECK-NEXT: }
// CHECK-NEXT: helper float set_element(int i.1, float x.2, inout float4 a) {
// CHECK-NEXT:   if (i.1 == 0) {
// CHECK-NEXT:     return a[0u] = x.2
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.1 == 1) {
// CHECK-NEXT:     return a[1u] = x.2
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.1 == 2) {
// CHECK-NEXT:     return a[2u] = x.2
// CHECK-NEXT:   }
// CHECK-NEXT:   return a[3u] = x.2
// CHECK-NEXT: }
// CHECK-NEXT: helper float2 assign_multiply_element_field0_element_yz(int i.2, int i2, float2 x.3, inout Part a.1[2]) {
// CHECK-NEXT:   if (i.2 == 0) {
// CHECK-NEXT:     return assign_multiply_element_yz(i2, x.3, a.1[0u].v)
// CHECK-NEXT:   }
// CHECK-NEXT:   return assign_multiply_element_yz(i2, x.3, a.1[1u].v)
// CHECK-NEXT: }
// CHECK-NEXT: helper float set_element_element(int i.3, int i2.1, float x.4, inout float2x3 a.2) {
// CHECK-NEXT:   if (i.3 == 0) {
// CHECK-NEXT:     return set_element.2(i2.1, x.4, a.2[0u])
// CHECK-NEXT:   }
// CHECK-NEXT:   return set_element.2(i2.1, x.4, a.2[1u])
// CHECK-NEXT: }
// CHECK-NEXT: helper float set_element_field1_1_0(int i.4, float x.5, inout Part a.3[2]) {
// CHECK-NEXT:   if (i.4 == 0) {
// CHECK-NEXT:     return a.3[0u].m[1u][0u] = x.5
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.3[1u].m[1u][0u] = x.5
// CHECK-NEXT: }
// CHECK-NEXT: helper float set_element_field0_1_x(int i.5, float x.6, inout Part a.4[2]) {
// CHECK-NEXT:   if (i.5 == 0) {
// CHECK-NEXT:     return a.4[0u].v[1].x = x.6
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.4[1u].v[1].x = x.6
// CHECK-NEXT: }
// CHECK-NEXT: helper float3 set_element.1(int i.6, float3 x.7, inout float3 a.5[2]) {
// CHECK-NEXT:   if (i.6 == 0) {
// CHECK-NEXT:     return a.5[0u] = x.7
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.5[1u] = x.7
// CHECK-NEXT: }
// CHECK-NEXT: helper void sincos_element(float x.8, int i.7, inout float x2, inout float4 a.6) {
// CHECK-NEXT:   if (i.7 == 0) {
// CHECK-NEXT:     sincos(x.8, a.6[0u], x2)
// CHECK-NEXT:     return
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.7 == 1) {
// CHECK-NEXT:     sincos(x.8, a.6[1u], x2)
// CHECK-NEXT:     return
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.7 == 2) {
// CHECK-NEXT:     sincos(x.8, a.6[2u], x2)
// CHECK-NEXT:     return
// CHECK-NEXT:   }
// CHECK-NEXT:   sincos(x.8, a.6[3u], x2)
// CHECK-NEXT: }
// CHECK-NEXT: helper void sincos_element_element_field0_0_y(float x.9, int x2.1, int i.8, inout float4 x3, inout Part a.7[2]) {
// CHECK-NEXT:   if (i.8 == 0) {
// CHECK-NEXT:     sincos_element(x.9, x2.1, a.7[0u].v[0].y, x3)
// CHECK-NEXT:     return
// CHECK-NEXT:   }
// CHECK-NEXT:   sincos_element(x.9, x2.1, a.7[1u].v[0].y, x3)
// CHECK-NEXT: }
// CHECK-NEXT: helper int post_increment_element(int i.9, inout int a.8[3]) {
// CHECK-NEXT:   if (i.9 == 0) {
// CHECK-NEXT:     return a.8[0u]++
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.9 == 1) {
// CHECK-NEXT:     return a.8[1u]++
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.8[2u]++
// CHECK-NEXT: }
// CHECK-NEXT: helper int pre_decrement_element(int i.10, inout int a.9[3]) {
// CHECK-NEXT:   if (i.10 == 0) {
// CHECK-NEXT:     return --a.9[0u]
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.10 == 1) {
// CHECK-NEXT:     return --a.9[1u]
// CHECK-NEXT:   }
// CHECK-NEXT:   return --a.9[2u]
// CHECK-NEXT: }
// CHECK-NEXT: helper float element(float4 a.10, int i.11) {
// CHECK-NEXT:   if (i.11 == 0) {
// CHECK-NEXT:     return a.10[0u]
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.11 == 1) {
// CHECK-NEXT:     return a.10[1u]
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.11 == 2) {
// CHECK-NEXT:     return a.10[2u]
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.10[3u]
// CHECK-NEXT: }
// CHECK-NEXT: helper float3 element.1(float3 a.11[2], int i.12) {
// CHECK-NEXT:   if (i.12 == 0) {
// CHECK-NEXT:     return a.11[0u]
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.11[1u]
// CHECK-NEXT: }
// CHECK-NEXT: helper Part element.2(Part a.12[2], int i.13) {
// CHECK-NEXT:   if (i.13 == 0) {
// CHECK-NEXT:     return a.12[0u]
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.12[1u]
// CHECK-NEXT: }
// CHECK-NEXT: helper float element.3(float3 a.13, int i.14) {
// CHECK-NEXT:   if (i.14 == 0) {
// CHECK-NEXT:     return a.13[0u]
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.14 == 1) {
// CHECK-NEXT:     return a.13[1u]
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.13[2u]
// CHECK-NEXT: }
// CHECK-NEXT: helper float3 element.4(float2x3 a.14, int i.15) {
// CHECK-NEXT:   if (i.15 == 0) {
// CHECK-NEXT:     return a.14[0u]
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.14[1u]
// CHECK-NEXT: }
// CHECK-NEXT: helper int element.5(int a.15[3], int i.16) {
// CHECK-NEXT:   if (i.16 == 0) {
// CHECK-NEXT:     return a.15[0u]
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.16 == 1) {
// CHECK-NEXT:     return a.15[1u]
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.15[2u]
// CHECK-NEXT: }
// CHECK-NEXT: helper float2 assign_multiply_element_yz(int i.17, float2 x.10, inout float3 a.16[2]) {
// CHECK-NEXT:   if (i.17 == 0) {
// CHECK-NEXT:     return a.16[0u].yz *= x.10
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.16[1u].yz *= x.10
// CHECK-NEXT: }
// CHECK-NEXT: helper float set_element.2(int i.18, float x.11, inout float3 a.17) {
// CHECK-NEXT:   if (i.18 == 0) {
// CHECK-NEXT:     return a.17[0u] = x.11
// CHECK-NEXT:   }
// CHECK-NEXT:   if (i.18 == 1) {
// CHECK-NEXT:     return a.17[1u] = x.11
// CHECK-NEXT:   }
// CHECK-NEXT:   return a.17[2u] = x.11
// CHECK-NEXT: }
