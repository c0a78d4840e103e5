// The file name of #line has no escapes, as in fxc: its preprocessor writes names of Windows as they are.
// RUN: %clipc --dump=tokens %s 2>&1 | FileCheck %s --implicit-check-not=escape
// RUN: %clipc %s -T vs_5_0 -Zi -Wno-warning-directive -o - | FileCheck %s --check-prefix=LINES
#line 1 "shaders\unlit.hlsl"
#warning one
// CHECK: shaders\unlit.hlsl:1:2: warning: one
#line 10 "a\rain\new.hlsl"
#warning two
// CHECK: a\rain\new.hlsl:10:2: warning: two
# 20 "a\other\x.hlsl"
#warning three
// CHECK: a\other\x.hlsl:20:2: warning: three
#line 30 "C:\\doubled\\x.hlsl"
#warning four
// CHECK: C:\\doubled\\x.hlsl:30:2: warning: four
#line 40 "shaders\rain\new.hlsl"
float4 main(float4 p : POSITION) : SV_Position { return p; }
// LINES: shaders{{.}}rain{{.}}new.hlsl
