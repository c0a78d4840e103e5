// Two inputs of one semantic are two inputs.
// RUN: %draw compare %s -T vs_5_0 -E main --target glsl450,glsl330,essl300,vulkan --lower none
float4 main(float4 a : POSITION, float4 b : POSITION0, uint id : SV_VertexID, uint again : SV_VertexID,
            out float4 sum : TEXCOORD0, out float4 difference : TEXCOORD0) : SV_Position {
  sum = a + b;
  difference = a - b + id * again;
  return a;
}
