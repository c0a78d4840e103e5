// RUN: not %clipc -T vs_5_0 -E twice %s 2>&1 | FileCheck %s --check-prefix=TWICE
// RUN: not %clipc -T vs_5_0 -E rows %s 2>&1 | FileCheck %s --check-prefix=ROWS
// RUN: not %clipc -T vs_5_0 -E high %s 2>&1 | FileCheck %s --check-prefix=HIGH
// RUN: not %clipc -T ps_5_0 -E views %s 2>&1 | FileCheck %s --check-prefix=VIEWS
cbuffer A : register(b1) { float4 a; };
cbuffer B : register(b1) { float4 b; };
// TWICE: error: `A` and `B` are both bound to register b1; each needs its own [register-twice, X4500]
// TWICE: note: `A` is declared here
float4 twice(float4 v : POSITION) : SV_Position { return a + b; }
// HIGH: error: register b14 of `C` is too high; the highest under this profile is 13 [register-too-high, X4567]
cbuffer C : register(b14) { float4 c; };
// HIGH: error: register b4294967295 of `Low` is too high
cbuffer Low : register(b2[-3]) { float4 low; };
float4 high(float4 v : POSITION) : SV_Position { return c + low; }
// ROWS: :[[#@LINE+1]]:16: error: register c65536 of `loose` is too high; the highest under this profile is 65535 [register-too-high, X4567]
float4 loose : register(c65536);
cbuffer D {
  float4 fits : packoffset(c65535);
  // ROWS: :[[#@LINE+1]]:16: error: register c65536 of `row` is too high
  float4 row : packoffset(c65536);
  // ROWS: :[[#@LINE+1]]:16: error: register c4294967295 of `sum` is too high
  float4 sum : packoffset(c4294967295[18446744073709551615]);
}
float4 rows(float4 v : POSITION) : SV_Position { return fits + row + sum + loose; }
// Direct3D 11.1 has 64 views, D3D11_1_UAV_SLOT_COUNT.
RWTexture2D<float4> last : register(u63);
// VIEWS: [[#@LINE+1]]:21: error: register u64 of `beyond` is too high; the highest under this profile is 63
RWTexture2D<float4> beyond : register(u64);
float4 views() : SV_Target { last[uint2(0, 0)] = 1; beyond[uint2(0, 0)] = 1; return 0; }
