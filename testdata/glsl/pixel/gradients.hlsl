// Derivatives where neighbouring pixels may not be: fxc X4121 and X4014.
// RUN: %clipc -T ps_5_0 -E branch %s -o - 2>&1 >%t.frag | FileCheck %s --check-prefix=BRANCH
// RUN: %clipc -T ps_5_0 -E loop %s -o - 2>&1 >%t.frag | FileCheck %s --check-prefix=LOOP
// RUN: %clipc -T ps_5_0 -E after_return %s -o - 2>&1 >%t.frag | FileCheck %s --check-prefix=RETURN
// RUN: %clipc -T ps_5_0 -E both_sides -Werror %s -o %t.frag
// RUN: %clipc -T ps_5_0 -E through_calls %s -o - 2>&1 >%t.frag | FileCheck %s --check-prefix=CALLS
// RUN: %clipc -T ps_5_0 -E uniform_flow -Werror %s -o %t.frag
// RUN: %clipc -T ps_5_0 -E once %s -o - 2>&1 >%t.frag | FileCheck %s --check-prefix=ONCE --implicit-check-not=warning
// RUN: %clipc -T ps_5_0 -E same_place -Werror %s -o %t.frag
// RUN: %clipc -T ps_5_0 -E place_by_branch %s -o - 2>&1 >%t.frag | FileCheck %s --check-prefix=PLACE --implicit-check-not=warning
Texture2D map;
SamplerState linearly;
cbuffer C {
  float4 setting;
  int count;
};

float4 branch(float2 uv : UV) : SV_Target {
  float4 c = 0;
  if (uv.x > 0) c = map.Sample(linearly, uv);
  if (uv.x > 0) c += map.SampleLevel(linearly, uv, 0);
  if (c.x > 0) c += ddx(uv.y);
  return c;
}
// BRANCH: [[#@LINE-5]]:21: warning: a sample uses differences between neighbouring pixels in flow that they may not share, where GLSL leaves them undefined; {{.*}} [-Wgradient-in-branch]
// BRANCH-NOT: warning
// BRANCH: [[#@LINE-5]]:21: warning: a derivative uses differences

float4 loop(float2 uv : UV, float n : N) : SV_Target {
  float4 c = 0;
  for (int i = 0; i < n; ++i) c += map.Sample(linearly, uv);
  for (int k = 0; k < 4; ++k) {
    c += map.Sample(linearly, uv);
    if (c.x > 1) break;
  }
  return c;
}
// LOOP: [[#@LINE-7]]:36: warning: a sample uses differences between neighbouring pixels in a loop whose iterations they may not share, {{.*}} [-Wgradient-in-loop]
// LOOP: [[#@LINE-6]]:10: warning: a sample uses {{.*}} [-Wgradient-in-loop]

float4 after_return(float2 uv : UV) : SV_Target {
  if (uv.x < 0) return 0;
  return map.Sample(linearly, uv);
}
// RETURN: [[#@LINE-2]]:10: warning: a sample uses {{.*}} [-Wgradient-in-branch]

float4 Read(float2 uv) { return map.Sample(linearly, uv); }
float Test(float x, out bool is_far) { is_far = x > 1; return 0; }
float4 through_calls(float2 uv : UV) : SV_Target {
  bool is_far;
  Test(uv.y, is_far);
  if (is_far) return 0;
  return Read(uv);
}
// CALLS: [[#@LINE-8]]:33: warning: a sample uses {{.*}} [-Wgradient-in-branch]

// The two sides of `?:` are evaluated.
float4 both_sides(float2 uv : UV) : SV_Target {
  bool is_far;
  Test(uv.y, is_far);
  return is_far ? 0 : Read(uv);
}

// What all pixels of a quad agree on: constants, flat inputs, the front face, a discard.
float4 uniform_flow(float2 uv : UV, nointerpolation float material : MATERIAL, uint id : ID, bool front : SV_IsFrontFace) : SV_Target {
  float4 c = 0;
  if (setting.x > 0 && material > 1 && id > 2 && front) c = map.Sample(linearly, uv);
  for (int i = 0; i < count; ++i) c += map.Sample(linearly, uv * i);
  clip(uv.x);
  [unroll] for (int k = 0; k < 3; ++k) c += ddx(uv.x * k);
  if (setting.y > 0) return c;
  return c + fwidth(uv.x);
}

// The loop of SPIRV-Cross that runs once has no iterations that differ: fxc takes a sample in it, and one before or after its breaks.
float4 once(float2 uv : UV) : SV_Target {
  float4 c = 0;
  do {
    c = map.Sample(linearly, uv);
    if (c.w < 0.5) break;
    // ONCE: [[#@LINE+1]]:10: warning: a sample uses {{.*}} [-Wgradient-in-branch]
    c += map.Sample(linearly, 2 * uv);
  } while (false);
  return c + map.Sample(linearly, 3 * uv);
}

// A place that all pixels of a quad agree on has no differences, in whatever flow: uniforms, constants, flat inputs, through functions,
// locals and arrays.
static const float2 kPlaces[2] = {float2(0.25, 0.5), float2(0.5, 0.75)};
float2 Place(float2 uv) { return uv * 2 + setting.zw; }
float4 same_place(float2 uv : UV, nointerpolation float2 flat_uv : FLAT) : SV_Target {
  float4 c = 0;
  float2 local = setting.xy;
  local.x += 1;
  if (uv.x > 0.5) {
    c = map.Sample(linearly, setting.xy) + map.Sample(linearly, float2(0.5, 0.5)) + map.Sample(linearly, local);
    c += map.Sample(linearly, Place(setting.xy)) + Read(flat_uv) + map.Sample(linearly, kPlaces[count]) + ddx(setting.x);
  }
  return c;
}
// The branches chose other places.
float4 place_by_branch(float2 uv : UV) : SV_Target {
  float2 place = setting.xy;
  if (uv.x > 0.5) place = setting.zw;
  // PLACE: [[#@LINE+1]]:26: warning: a sample uses {{.*}} [-Wgradient-in-branch]
  if (uv.y > 0.5) return map.Sample(linearly, place);
  // PLACE: [[#@LINE+1]]:10: warning: a sample uses {{.*}} [-Wgradient-in-branch]
  return map.Sample(linearly, Place(uv));
}
