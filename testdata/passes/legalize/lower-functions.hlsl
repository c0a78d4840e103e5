// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-functions --stop-after=lower-functions %s | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl120 --verify --dump-after=lower-functions --stop-after=lower-functions %s | FileCheck %s --check-prefix=OLD
// RUN: %clipc -T vs_5_0 %s -o - | FileCheck %s --check-prefix=GLSL
// RUN: %draw compare %s -T vs_5_0
// RUN: %draw compare %s -T vs_5_0 --target=glsl120
// RUN: %draw compare %s -T vs_5_0 --target=essl100
// AUTOUPDATE

// A function that no language like GLSL has is a helper function, which may call others; GLSL 1.20
// lacks more of them. Edges that are in order make smoothstep() one of GLSL's own. A float1 is a
// scalar.
float4 main(float4 p : POSITION) : SV_Position
{
    float1 only = p.w;
    float2 soft = smoothstep(p.xy, p.zw, 0.5);
    float hard = smoothstep(0.25, 0.75, p.x);
    return float4(saturate(p.xy) + soft, tanh(p.z) + hard, isfinite(only) ? only.x : 0);
}

// CHECK: program vs_5_0 form legalized
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   float1 only = splat<float1>(in_POSITION0.w)
// CHECK-NEXT:   float2 soft = smoothstep(in_POSITION0.xy, in_POSITION0.zw, splat<float2>(0.5))
// CHECK-NEXT:   float hard = smoothstep(0.25, 0.75, in_POSITION0.x)
// CHECK-NEXT:   vs_SV_POSITION0 = float4(saturate(in_POSITION0.xy) + soft, tanh(in_POSITION0.z) + hard, bool1(isfinite(only.x)).x ? only.x : 0.0)
// CHECK-NEXT: }
// CHECK-NEXT: helper float2 smoothstep(float2 a, float2 b, float2 x) {
// CHECK-NEXT:   float2 t = saturate((x - a) / (b - a))
// CHECK-NEXT:   return (t * t) * ((t * splat<float2>(-2.0)) + splat<float2>(3.0))
// CHECK-NEXT: }
// CHECK-NEXT: helper float2 saturate(float2 x.1) {
// CHECK-NEXT:   return min(max(splat<float2>(0.0), x.1), splat<float2>(1.0))
// CHECK-NEXT: }
// CHECK-NEXT: helper bool isfinite(float x.2) {
// CHECK-NEXT:   return !(isnan(x.2) or_else isinf(x.2))
// CHECK-NEXT: }

// OLD: program vs_5_0 form legalized
// OLD-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// OLD-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// OLD-NEXT: entry void main() {
// OLD-NEXT: }
// OLD-NEXT: main void main.1() {
// OLD-NEXT:   float1 only = splat<float1>(in_POSITION0.w)
// OLD-NEXT:   float2 soft = smoothstep(in_POSITION0.xy, in_POSITION0.zw, splat<float2>(0.5))
// OLD-NEXT:   float hard = smoothstep(0.25, 0.75, in_POSITION0.x)
// OLD-NEXT:   vs_SV_POSITION0 = float4(saturate(in_POSITION0.xy) + soft, tanh(in_POSITION0.z) + hard, bool1(isfinite(only.x)).x ? only.x : 0.0)
// OLD-NEXT: }
// OLD-NEXT: helper float2 smoothstep(float2 a, float2 b, float2 x) {
// OLD-NEXT:   float2 t = saturate((x - a) / (b - a))
// OLD-NEXT:   return (t * t) * ((t * splat<float2>(-2.0)) + splat<float2>(3.0))
// OLD-NEXT: }
// OLD-NEXT: helper float2 saturate(float2 x.1) {
// OLD-NEXT:   return min(max(splat<float2>(0.0), x.1), splat<float2>(1.0))
// OLD-NEXT: }
// OLD-NEXT: helper float tanh(float x.2) {
// OLD-NEXT:   float e = exp(-2.0 * abs(x.2))
// OLD-NEXT:   return (convert<float>(sign(x.2)) * (1.0 - e)) / (1.0 + e)
// OLD-NEXT: }
// OLD-NEXT: helper bool isfinite(float x.3) {
// OLD-NEXT:   return !(isnan(x.3) or_else isinf(x.3))
// OLD-NEXT: }
// OLD-NEXT: helper bool isnan(float x.4) {
// OLD-NEXT:   return x.4 != x.4
// OLD-NEXT: }
// OLD-NEXT: helper bool isinf(float x.5) {
// OLD-NEXT:   return (x.5 != 0.0) and_then ((x.5 + x.5) == x.5)
// OLD-NEXT: }

// GLSL: #version 450
// GLSL-EMPTY:
// GLSL-NEXT: layout(location = 0) in vec4 in_POSITION0;  // p : POSITION0
// GLSL-EMPTY:
// GLSL-NEXT: vec2 saturate(vec2 x) {
// GLSL-NEXT:     return min(max(vec2(0.0), x), 1.0);  // 0 for NaN
// GLSL-NEXT: }
// GLSL-EMPTY:
// GLSL-NEXT: vec2 smoothstep_(vec2 a, vec2 b, vec2 x) {
// GLSL-NEXT:     vec2 t = saturate((x - a) / (b - a));
// GLSL-NEXT:     return t * t * (t * -2.0 + 3.0);
// GLSL-NEXT: }
// GLSL-EMPTY:
// GLSL-NEXT: bool isfinite(float x) {
// GLSL-NEXT:     return !(isnan(x) || isinf(x));
// GLSL-NEXT: }
// GLSL-EMPTY:
// GLSL-NEXT: void main() {
// GLSL-NEXT:     float only = in_POSITION0.w;
// GLSL-NEXT:     vec2 soft = smoothstep_(in_POSITION0.xy, in_POSITION0.zw, vec2(0.5));
// GLSL-NEXT:     float hard = smoothstep(0.25, 0.75, in_POSITION0.x);
// GLSL-NEXT:     gl_Position = vec4(saturate(in_POSITION0.xy) + soft, tanh(in_POSITION0.z) + hard, isfinite(only) ? only : 0.0);
// GLSL-NEXT: }
