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

// The word alone makes the shader run for each sample: reading gl_SampleID does so in GLSL.
// RUN: %clipc -T ps_5_0 -E alone %s --validate -o - | FileCheck --check-prefix=ALONE %s
// RUN: %clipc -T ps_5_0 -E alone %s --target=vulkan --validate -o - | FileCheck --check-prefix=ALONE %s
float4 alone(sample float4 place : SV_Position) : SV_Target {
  // ALONE: + float(uint(gl_SampleID) >> 5u);
  return place.xyxy;
}

// RUN: %clipc -T ps_5_0 -E centroids %s -o - 2>&1 | FileCheck --check-prefix=CENTROID %s
// CENTROID: [[#@LINE+1]]:42: warning: `centroid` has no effect on the position, which GLSL has at the pixel's center [-Wqualifier-without-effect]
float4 centroids(centroid float4 place : SV_Position) : SV_Target { return place; }
