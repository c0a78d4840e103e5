// RUN: %clipc --dump=ast %s | FileCheck %s
// AUTOUPDATE
// The effects framework is read past; the shaders that it compiles are remembered.
float4 tint : DIFFUSE <string UIName = "Tint"; float UIMin = 0; bool on = true;> = {1, 1, 1, 1};
float4x4 world : WORLD <>;
texture base <string name = "a.dds"; vector<float, 4> v = {1, 2, 3, 4};>;
Texture2D diffuse;
sampler2D old = sampler_state {
  Texture = <base>;
  MinFilter = LINEAR;
  AddressU = Wrap;
};
sampler pair[2] = { sampler_state { Texture = (base); }, sampler_state { Texture = (base); } };
SamplerState linear_sampler : register(s0) { Filter = MIN_MAG_MIP_LINEAR; AddressU = Wrap; };
BlendState blend { BlendEnable[0] = TRUE; SrcBlend = SRC_ALPHA; };
DepthStencilState depth { DepthEnable = false; }
RasterizerState raster = { CullMode = NONE; };
stateblock block = stateblock_state { ZEnable = true; };
VertexShader compiled = compile vs_3_0 old_main(1, true);
VertexShader several[2] = { compile vs_2_0 array_a(), compile vs_2_0 array_b() };
PixelShader pixel = compile ps_3_0 old_pixel();
VertexShader assembled = asm { vs_1_1 mov oPos, v0 };
GeometryShader streamed = ConstructGSWithSO(CompileShader(vs_4_0, stream_main()), "SV_Position.xyzw");

technique Old <string script = "x";> {
  pass P0 <int order = 1;> {
    VertexShader = compile vs_2_0 two_main();
    PixelShader = asm { ps_1_1 mov r0, c0 };
    ZEnable = FALSE;
  }
  pass { VertexShader = (several[1]); }
}
technique11 <bool water = true;> { pass <bool first = true;> { ZEnable = TRUE; } }
TECHNIQUE { pass p { VertexShader = compile VS_2_0 two_main(); } }
technique10 Ten {
  pass P { SetVertexShader(CompileShader(vs_4_0, ten_main(world))); SetPixelShader(NULL); }
}
fxgroup group {
  technique11 Eleven { pass P { SetVertexShader(CompileShader(vs_5_0, space::eleven_main())); } }
}
float4 after() : SV_Position { return 0; }

// CHECK: variable tint : float4 semantic DIFFUSE = {1, 1, 1, 1}
// CHECK-NEXT: variable world : float4x4 semantic WORLD
// CHECK-NEXT: variable base : texture
// CHECK-NEXT: variable diffuse : Texture2D
// CHECK-NEXT: variable old : sampler2D state block
// CHECK-NEXT: variable pair[2] : sampler state block
// CHECK-NEXT: variable linear_sampler : SamplerState register(s0) state block
// CHECK-NEXT: variable blend : BlendState state block
// CHECK-NEXT: variable depth : DepthStencilState state block
// CHECK-NEXT: variable raster : RasterizerState state block
// CHECK-NEXT: variable block : stateblock state block
// CHECK-NEXT: variable compiled : VertexShader state block
// CHECK-NEXT: variable several[2] : VertexShader state block
// CHECK-NEXT: variable pixel : PixelShader state block
// CHECK-NEXT: variable assembled : VertexShader state block
// CHECK-NEXT: variable streamed : GeometryShader state block
// CHECK-NEXT: function after : float4 semantic SV_Position
// CHECK-NEXT:   block
// CHECK-NEXT:     return 0
// CHECK-NEXT: technique compiles vs old_main
// CHECK-NEXT: technique compiles vs array_a
// CHECK-NEXT: technique compiles vs array_b
// CHECK-NEXT: technique compiles ps old_pixel
// CHECK-NEXT: technique compiles vs stream_main
// CHECK-NEXT: technique compiles vs two_main
// CHECK-NEXT: technique compiles vs ten_main
// CHECK-NEXT: technique compiles vs eleven_main
