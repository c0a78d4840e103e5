// A variable that a condition declares lives as long as its statement (DXC's CodeGenSPIRV/cf.if.plain.hlsl and cf.switch.ifstmt.hlsl).
// RUN: %clipc -T ps_6_0 %s -o - | FileCheck %s
// RUN: %draw compare %s -T ps_6_0
float4 main(float4 p : P) : SV_Target {
  float x = 0;
  // CHECK: float y = {{.*}};
  // CHECK-NEXT: if (bool(y)) {
  [branch] if (float y = floor(p.x))
    x += y;
  else if (const int z = (int)p.y)
    x += y + z;
  else
    x -= z;
  float n = 3;
  // CHECK: while (true) {
  // CHECK-NEXT: float left = {{.*}};
  // CHECK-NEXT: if (!bool(left)) {
  while (float left = n - 1) {
    n--;
    if (left > 1) continue;
    x += left;
  }
  switch (int x = (int)p.z) {
    case 1: n += x; break;
    default: n -= x; break;
  }
  return p + x + n;
}
