// Direct3D 9: matrices of other shapes, row_major and column_major, and an array of them.
// SET Columns = 0 1 2  3 4 5  6 7 8
// SET Rows = 0 1 2  3 4 5
// SET Several = 1 2 3 4  5 6 7 8
// DRAW Shapes
// PIXEL 8 8 = 50 40 80 255
column_major float3x3 Columns;
row_major float2x3 Rows;
float2x2 Several[2];
float4 VS(float4 p : POSITION) : POSITION { return p; }
float4 PS() : COLOR { return float4(Columns[1][2] * 10, Rows[1].y * 10, Several[1]._22 * 10, 255) / 255; }
technique Shapes { pass P0 { VertexShader = compile vs_3_0 VS(); PixelShader = compile ps_3_0 PS(); } }
