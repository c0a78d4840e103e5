// Effects of Direct3D 10: constant buffers with default values, a matrix of rows, an array, an int and a bool.
// SET Rows = 1 0 0 0  0 1 0 0  0 0 1 0  0 0 0 1
// DRAW Buffers
// PIXEL 8 8 = 51 102 153 255
// SET Tint = 1 0 0 1
// PIXEL 8 8 = 51 102 153 255
// DRAW Buffers
// PIXEL 8 8 = 255 0 0 255
// SETI Use = 0
// DRAW Buffers
// PIXEL 8 8 = 0 255 0 255
cbuffer Frame : register(b0) { row_major float4x4 Rows; float Weights[3] = {0.25, 0.5, 0.25}; };
cbuffer Material : register(b1) { float4 Tint = float4(0.2, 0.4, 0.6, 1); bool Use = true; int Count = 3; };
float4 VS(float4 p : POSITION) : SV_Position { return mul(p, Rows); }
float4 PS() : SV_Target {
  float sum = 0;
  for (int i = 0; i < Count; i++) sum += Weights[i];
  return Use ? Tint * sum : float4(0, 1, 0, 1);
}
technique10 Buffers { pass P0 { SetVertexShader(CompileShader(vs_4_0, VS())); SetPixelShader(CompileShader(ps_4_0, PS())); } }
