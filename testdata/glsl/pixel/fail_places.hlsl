// What a target lacks of a pixel's places, with the nearest target that has it.
// RUN: not %clipc -T ps_6_4 --target=glsl330 %s -o - 2>&1 | FileCheck %s
// RUN: not %clipc -T ps_6_4 --target=vulkan -E changed %s -o - 2>&1 | FileCheck %s --check-prefix=CHANGED
// RUN: not %clipc -T ps_6_4 --target=vulkan -E subpass %s -o - 2>&1 | FileCheck %s --check-prefix=SUBPASS
// RUN: not %clipc -T ps_6_4 --target=vulkan -E vertices %s -o - 2>&1 | FileCheck %s --check-prefix=VERTICES
// RUN: not %clipc -T ps_6_4 --target=glsl430 -E vertex %s -o - 2>&1 | FileCheck %s --check-prefix=VERTEX
// RUN: not %clipc -T ps_6_4 --target=essl320 -E inner %s -o - 2>&1 | FileCheck %s --check-prefix=INNER
// RUN: not %clipc -T ps_6_4 --target=webgl2 -E samples %s -o - 2>&1 | FileCheck %s --check-prefix=WEB
float4 main(float4 a : A, float3 weights : SV_Barycentrics, uint s : SV_SampleIndex) : SV_Target {
  return EvaluateAttributeCentroid(a) + weights.x + s;
}
// CHECK: error: `SV_Barycentrics` is an input or output that target `glsl330` lacks [target-pixel-value]
// CHECK: note: target `glsl450` can
// CHECK: error: `SV_SampleIndex` is an input or output that target `glsl330` lacks [target-pixel-value]
// CHECK: note: target `glsl400` can
// CHECK: [[#@LINE-6]]:10: error: `EvaluateAttributeCentroid` reads an input at another place of the pixel; target `glsl330` has no function for that [target-interpolant]
// CHECK: note: target `glsl400` can

float4 changed(float4 a : A) : SV_Target { return EvaluateAttributeCentroid(a * 2); }
// CHANGED: error: `EvaluateAttributeCentroid` is given a value that is not an input of the shader, unchanged, or components of one; GLSL evaluates inputs only [interpolant-not-input]

SubpassInput colors;
float4 subpass() : SV_Target { return colors.SubpassLoad(); }
// SUBPASS: error: `colors` has no `vk::input_attachment_index`; target `vulkan` knows a subpass input by that number [target-subpass-input]

float4 inner(uint c : SV_InnerCoverage) : SV_Target { return c; }
// INNER: error: `SV_InnerCoverage` is an input or output that target `essl320` lacks [target-pixel-value]
// INNER: note: target `glsl450` can

float4 vertices(nointerpolation float4 a : A, float4 b : B) : SV_Target {
  // VERTICES: [[#@LINE+1]]:10: error: `GetAttributeAtVertex` is given vertex 3; those of a primitive are 0, 1 and 2 [attribute-vertex]
  return GetAttributeAtVertex(a, 3) +
         // VERTICES: [[#@LINE+1]]:10: error: `GetAttributeAtVertex` is given `B0`, which is not `nointerpolation`; an input whose vertices are read has that modifier [attribute-interpolated]
         GetAttributeAtVertex(b, 0);
}

float4 vertex(nointerpolation float4 a : A) : SV_Target { return GetAttributeAtVertex(a, 0); }
// VERTEX: error: `GetAttributeAtVertex` reads an input at another place of the pixel; target `glsl430` has no function for that [target-interpolant]
// VERTEX: note: target `glsl450` can

// No browser has OES_sample_variables.
// WEB: error: `SV_SampleIndex` is an input or output that target `webgl2` lacks [target-pixel-value]
// WEB: note: target `glsl400` can
float4 samples(uint number : SV_SampleIndex) : SV_Target { return number; }
