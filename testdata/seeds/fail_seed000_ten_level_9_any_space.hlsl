// "User clip planes on feature level 9 hardware", Background and 10Level9 feature levels: at feature level 9 there is no
// SV_ClipDistance, and so no plane but in clip space.
// RUN: not %clipc -T vs_4_0_level_9_1 %s -o - 2>&1 | FileCheck %s

struct Output {
  float4 position : SV_Position;
  // CHECK: fail_seed000_ten_level_9_any_space.hlsl{{.*}}error: the shader writes `SV_ClipDistance`; `vs_4_0_level_9_1` has no clip distances; give the planes with `clipplanes` [level9-clip-distance, X4583]
  float distance : SV_ClipDistance;
};

Output main(float4 position : POSITION) {
  Output output;
  output.position = position;
  output.distance = position.x;
  return output;
}
