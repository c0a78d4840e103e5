// Direct3D 9's framework with a shader of 4.0, whose planes are clip distances: the loader enables those of the pass.
// PLANES Water Above = 0:Plane
// PLANES Water Two = 0:Plane 1:Sides[1]
// PLANES Water All =
// SET Plane = 1 0 0 0
// SET Sides = 0 0 0 1  0 1 0 0
// DRAW Water Above
// PIXEL 12 3 = 255 255 255 255
// PIXEL 3 3 = 0 0 0 0
// CLEAR
// DRAW Water Two
// PIXEL 12 3 = 255 255 255 255
// PIXEL 12 12 = 0 0 0 0
// DRAW Water All
// PIXEL 3 12 = 255 255 255 255
float4 Plane;
float4 Sides[2];
[clipplanes(Plane)] float4 One(float4 p : POSITION) : SV_Position { return p; }
[clipplanes(Plane, Sides[1])] float4 Two(float4 p : POSITION) : SV_Position { return p; }
float4 None(float4 p : POSITION) : SV_Position { return p; }
float4 PS() : SV_Target { return 1; }
technique Water {
  pass Above { VertexShader = compile vs_4_0 One(); PixelShader = compile ps_4_0 PS(); }
  pass Two { VertexShader = compile vs_4_0 Two(); PixelShader = compile ps_4_0 PS(); }
  pass All { VertexShader = compile vs_4_0 None(); PixelShader = compile ps_4_0 PS(); }
}
