// A function that the target has for scalars only is called once for each component.
// RUN: %clipc -T vs_5_0 --verify --dump-after=lower-components --stop-after=lower-components %s | FileCheck %s
// RUN: %clipc -T vs_5_0 --target=glsl120 --verify --dump-after=lower-components --stop-after=lower-components %s | FileCheck %s --check-prefix=OLD
// RUN: %draw compare %s -T vs_5_0
// AUTOUPDATE
float4 main(float4 p : POSITION) : SV_Position {
  bool2 finite = isfinite(p.xy);
  return float4(finite.x ? round(p.xy) : p.zw, 0, 1);
}
