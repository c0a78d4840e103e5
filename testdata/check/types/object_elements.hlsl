// An index that is constant once local variables are known chooses an object: vkd3d's object-references.shader_test, line 29, checked against
// fxc and dxc.
// RUN: %clipc -T ps_5_0 %s --validate -o - | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
Texture2D good, bad;
float4 main(int2 at : AT) : SV_Target {
  const int2 p = at & 1;
  Texture2D chosen, all[2];
  const int4 zeros = { 0, 0, 0, 1 };
  int4 more = { 0, 0, 1, 0 };
  all[more.x + more.y] = good;
  all[zeros.w] = bad;
  chosen = all[0];
  all[0] = bad;
  // CHECK: texelFetch(good, {{.*}}) + texelFetch(bad
  return chosen[p] + all[more.z][p];
}
