// clipc water.hlsl
float4 main(float4 p : POSITION) : SV_Position {
  float2 xy = p;
  return xy.xyxy;
}
