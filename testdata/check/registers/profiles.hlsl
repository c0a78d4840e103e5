// register(ps, t1) counts for pixel shaders alone up to 5.1; from 6.0 on the last register counts, whatever its profile. Oracle:
// vkd3d's register-reservations-profile.shader_test and -space, checked against fxc and dxc.
// RUN: %clipc -T ps_5_0 %s --dump=ir | FileCheck --check-prefix=FXC %s
// RUN: %clipc -T ps_6_0 %s --dump=ir 2>%t | FileCheck --check-prefix=DXC %s
// RUN: FileCheck --check-prefix=MESSAGE --implicit-check-not=warning %s <%t
// FXC: resource Texture2D<float4> other : t0
// FXC: resource Texture2D<float4> several : t3 explicit
// DXC: resource Texture2D<float4> other : t1 explicit
// DXC: resource Texture2D<float4> several : t4 explicit
Texture2D other : register(vs, t1);
// MESSAGE: [[#@LINE+1]]:21: warning: the register has no effect: from shader model 6 on the last one counts, whatever its profile [-Wregister-without-effect]
Texture2D several : register(ps, t3) : register(vs, t4);

float4 main() : SV_Target { return other.Load(0) + several.Load(0); }
