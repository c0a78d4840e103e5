// A function that the target has for scalars only is called once for each component.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-components --stop-after=lower-components %s | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl120 --verify --dump-after=lower-components --stop-after=lower-components %s | FileCheck %s --check-prefix=OLD
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float4 main(float4 p : POSITION) : SV_Position {
  bool2 finite = isfinite(p.xy);
  return float4(finite.x ? round(p.xy) : p.zw, 0, 1);
}

// CHECK: program vs_5_0 form inlined
// CHECK-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// CHECK-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// CHECK-NEXT: entry void main() {
// CHECK-NEXT: }
// CHECK-NEXT: main void main.1() {
// CHECK-NEXT:   bool2 finite = isfinite(in_POSITION0.xy)
// CHECK-NEXT:   vs_SV_POSITION0 = float4(finite.x ? round(in_POSITION0.xy) : in_POSITION0.zw, 0.0, 1.0)
// CHECK-NEXT: }
// CHECK-NEXT: helper bool2 isfinite(float2 a) {
// CHECK-NEXT:   return bool2(isfinite(a.x), isfinite(a.y))
// CHECK-NEXT: }

// OLD: program vs_5_0 form inlined
// OLD-NEXT: input float4 in_POSITION0 : POSITION0 location 0
// OLD-NEXT: output float4 vs_SV_POSITION0 : SV_Position0 builtin position
// OLD-NEXT: entry void main() {
// OLD-NEXT: }
// OLD-NEXT: main void main.1() {
// OLD-NEXT:   bool2 finite = isfinite(in_POSITION0.xy)
// OLD-NEXT:   vs_SV_POSITION0 = float4(finite.x ? round(in_POSITION0.xy) : in_POSITION0.zw, 0.0, 1.0)
// OLD-NEXT: }
// OLD-NEXT: helper bool2 isfinite(float2 a) {
// OLD-NEXT:   return bool2(isfinite(a.x), isfinite(a.y))
// OLD-NEXT: }
// OLD-NEXT: helper float2 round(float2 a.1) {
// OLD-NEXT:   return float2(round(a.1.x), round(a.1.y))
// OLD-NEXT: }
