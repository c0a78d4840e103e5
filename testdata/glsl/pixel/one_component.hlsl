// An input of Direct3D 9 that is a vector of one component is read as the number that it is; --dump=ir names inputs that have no GLSL.
// RUN: %clipc -T ps_2_0 %s -o - --validate | FileCheck %s
// RUN: %clipc -T ps_2_0 %s --dump=ir -o - | FileCheck %s --check-prefix=IR
struct Varyings { float4 position : POSITION; float1 fog : TEXCOORD1; };
// IR: input float4 in_POSITION0 : POSITION0 builtin untranslated
// IR: input float in_TEXCOORD1 : TEXCOORD1 location 0
// CHECK: layout(location = 0) in float vs_TEXCOORD1;
// CHECK: SV_Target0 = vec4(fog);
float4 main(Varyings v) : COLOR { return v.fog.xxxx; }
