// The position of a shader that runs for each sample is the pixel's center, and the sample's where it says so. Oracle: vkd3d's
// eval-attrib.shader_test, checked against Direct3D.
// RUN: %clipc -T ps_5_0 -E centers %s -o - | FileCheck --check-prefix=CENTER %s
// RUN: %clipc -T ps_5_0 -E samples %s -o - | FileCheck --check-prefix=SAMPLE %s
// RUN: %draw compare %s -T ps_5_0 -E centers --target glsl450,vulkan
float4 centers(float4 place : SV_Position, uint number : SV_SampleIndex) : SV_Target {
  // CENTER: vec4(floor(gl_FragCoord.xy) + 0.5, {{.*}})
  return place + number;
}

float4 samples(sample float4 place : SV_Position, sample float4 color : COLOR) : SV_Target {
  // SAMPLE-NOT: floor
  return place + color;
}
