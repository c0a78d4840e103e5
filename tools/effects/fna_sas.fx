// FNA and XNA: annotations of every type, semantics, and parameters that nothing reads.
// SET WorldViewProj = 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1
// DRAW Shade
// PIXEL 8 8 = 64 64 191 255
float Script : STANDARDSGLOBAL <string UIWidget = "none"; string ScriptClass = "object";> = 0.8;
float4x4 WorldViewProj : WorldViewProjection <string UIWidget = "None";>;
float3 LampPoint : Position <string Object = "PointLight0"; string UIName = "Lamp"; string Space = "World";> = {-0.5f, 2.0f, 1.25f};
float3 SurfaceColor : DIFFUSE <string UIWidget = "Color"; float UIMin = 0; float UIMax = 1;> = {0.5f, 0.5f, 1.5f};
float Kd <string UIName = "Diffuse"; float UIMin = 0.0; float UIStep = 0.01;> = 1.0 / 2;
float4 VS(float4 p : POSITION) : POSITION { return mul(p, WorldViewProj); }
float4 PS() : COLOR { return float4(SurfaceColor * Kd, 1); }
technique Shade <string Script = "Pass=p0;";> {
  pass p0 <string Script = "Draw=geometry;";> { ZEnable = true; CullMode = None; VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS(); }
}
