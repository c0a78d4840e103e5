//a0
struct V { float4 p : SV_Position; float2 uv[2] : TEXCOORD; };
struct P { float4 p : SV_Position; uint layer : SV_RenderTargetArrayIndex; float clip : SV_ClipDistance; float2 uv : TEXCOORD; };
float4 plane;
void Give(V v, inout TriangleStream<P> stream, uint layer) {
  P p = {v.p, layer, dot(v.p, plane), v.uv[1]};
  stream.Append(p);
}
[instance(2)] [maxvertexcount(4)]
void main(triangleadj V v[6], uint i : SV_GSInstanceID, uint id : SV_PrimitiveID, inout TriangleStream<P> stream) {
  for (uint k = 0; k < 6; k += 2) {
    if (id == 3) return;
    Give(v[k], stream, i);
  }
  stream.RestartStrip();
}
