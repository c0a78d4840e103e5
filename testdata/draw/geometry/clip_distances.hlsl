// Clip distances that a geometry shader reads and writes, and clip planes of its own.
// RUN: %draw compare %s -T gs_4_0 --target=glsl150,glsl410,glsl450
// RUN: %draw compare %s -T gs_4_0 -E planes
struct V {
  float4 p : SV_Position;
  float3 clip : SV_ClipDistance;
};
struct O {
  float4 p : SV_Position;
  nointerpolation int2 number : NUMBER;
};
cbuffer Planes {
  float4 first, second;
};
[maxvertexcount(2)]
void main(line V v[2], inout LineStream<V> stream) {
  V mid = v[0];
  mid.clip = (v[0].clip + v[1].clip) / 2;
  mid.p = (v[0].p + v[1].p) / 2;
  stream.Append(mid);
  stream.Append(v[1]);
}
[clipplanes(first, second)]
[maxvertexcount(6)]
void planes(triangleadj float4 v[6] : SV_Position, uint id : SV_PrimitiveID, inout PointStream<O> stream) {
  for (int i = 0; i < 6; ++i) {
    if (v[i].x < 0) continue;
    O o = {v[i] * 2, int2(i, id)};
    stream.Append(o);
  }
}
