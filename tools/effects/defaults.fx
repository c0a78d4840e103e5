// Default values of every shape: initialiser lists without nesting, casts, operators, constants, structs, arrays and matrices in
// both orders. Each is in the bytes of its buffer, also between values without one.
// DRAW Defaults Sums
// PIXEL 8 8 = 51 102 153 255
// DRAW Defaults Structs
// PIXEL 8 8 = 26 51 77 102
// DRAW Defaults Matrices
// PIXEL 8 8 = 51 77 102 128
// SET Row = 0.4 0.4
// DRAW Defaults Sums
// PIXEL 8 8 = 102 102 153 255
static const float Unit = 0.1;
float2 Row = {Unit * 2, 0.4};
float Unset;
int Three = 2 + 1;
bool On = true;
float Odd[3] = {0.1, {0.2, 0.3}};
struct Lamp { float3 color; float power; float2 at[2]; };
Lamp Lamps[2] = {0, 0, 0, 0, 0, 0, 0, 0, float3(1, 2, 3) * Unit, 0.4, 0.5, 0.6, 0.7, 0.8};
float2x3 Columns = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
row_major float2x3 Rows = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
float4 VS(float4 p : POSITION) : POSITION { return p; }
float4 PSSums() : COLOR { return float4(Row, Odd[2] + Odd[2], On ? Three / 3.0 : 0) + Unset; }
float4 PSStructs() : COLOR { return float4(Lamps[1].color, Lamps[1].power + Lamps[0].power); }
float4 PSMatrices() : COLOR { return float4(Columns[0].y, Rows[0].z, Columns[1].x, Rows[1].y); }
technique Defaults {
  pass Sums { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PSSums(); }
  pass Structs { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PSStructs(); }
  pass Matrices { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PSMatrices(); }
}
