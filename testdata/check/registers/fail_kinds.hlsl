// What fxc says of each register: DXC's packreg.hlsl. A register of another kind has no effect, which
// is a warning, since shaders that no Direct3D compiler has seen have them.
// RUN: not %clipc -T vs_5_1 %s 2>&1 | grep -v '^ ' | FileCheck %s --implicit-check-not=warning --implicit-check-not=error:
// CHECK-DAG: [[#@LINE+1]]:17: warning: register `c2` has no effect on `Block`, which needs a register `b`; fxc reports an error [-Wregister-kind]
cbuffer Block : register(c2) { float4 a; }
// CHECK-DAG: [[#@LINE+1]]:17: warning: register `b1` has no effect on `Texel`, which needs a register `t`
tbuffer Texel : register(B1) { float4 b; }
struct S { float4 c; };
// CHECK-DAG: [[#@LINE+1]]:28: warning: register `t1` has no effect on `object`, which needs a register `b`
ConstantBuffer<S> object : register(t1);
// CHECK-DAG: [[#@LINE+1]]:21: warning: register `u3` has no effect on `picture`, which needs a register `t`
Texture2D picture : register(u3);
// CHECK-DAG: [[#@LINE+1]]:24: warning: register `t3` has no effect on `reading`, which needs a register `s`
SamplerState reading : register(t3);
// CHECK-DAG: [[#@LINE+1]]:31: warning: register `t4` has no effect on `written`, which needs a register `u`
RWByteAddressBuffer written : register(t4);
// CHECK-DAG: [[#@LINE+1]]:17: warning: register `t5` has no effect on `number`, which needs a register `c`
float4 number : register(t5);
bool flag : register(b0) : register(c7);
// Shader model 5.1 takes the first register, whatever its profile.
// CHECK-DAG: [[#@LINE+1]]:25: warning: register `u3` has no effect on `other_stage`, which needs a register `t`
Texture2D other_stage : register(ps, u3) : register(vs, t7);
AppendStructuredBuffer<float4> unused : register(u5);

// CHECK-DAG: [[#@LINE+1]]:34: error: `twice` is bound to both `t4` and `t5`; remove one of them [register-conflict, X3115]
Texture2D twice : register(t4) : register(t5);
// CHECK-DAG: [[#@LINE+1]]:31: error: `again` is bound to both `c8` and `c9`; remove one of them
float4 again : register(c8) : register(c9);
// CHECK-DAG: [[#@LINE+2]]:51: error: `stage` is bound to both `b5` and `b6`; remove one of them
// CHECK-DAG: [[#@LINE+1]]:32: warning: the register has no effect: in shader model 5.1 the first one counts, whatever its profile
cbuffer stage : register(b4) : register(vs, b5) : register(vs, b6) { float4 d; }
cbuffer same : register(b9) : register(b9) { float4 e; }
float4 main(float4 p : P) : SV_Position {
  written.Load(0);
  return a + b + object.c + picture.SampleLevel(reading, p.xy, 0) + number + flag + again + d + e +
         other_stage.Load(0) + twice.Load(0);
}
