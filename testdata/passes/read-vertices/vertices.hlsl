// Elements of the array of vertices are read as inputs of the vertex; where one is read as a whole or written, the
// array stays.
// RUN: %clipc %s -T gs_5_0 -E parts --dump-after=read-vertices | FileCheck %s --check-prefix=PARTS
// RUN: %clipc %s -T gs_5_0 -E parts --validate -o - | FileCheck %s --check-prefix=GLSL
// RUN: %clipc %s -T gs_5_0 -E whole --validate -o - | FileCheck %s --check-prefix=WHOLE
// RUN: %clipc %s -T gs_5_0 -E written --validate -o - | FileCheck %s --check-prefix=WRITTEN
// RUN: %draw compare %s -T gs_5_0 -E parts
// RUN: %draw compare %s -T gs_5_0 -E whole
// RUN: %draw compare %s -T gs_5_0 -E written
struct V {
  float4 p : SV_Position;
  float2 uv[2] : TEXCOORD;
  float4 unread : COLOR;
  bool is_on : FLAG;
};
struct O {
  float4 p : SV_Position;
  float2 uv : TEXCOORD;
};

// PARTS-NOT: local V
// PARTS: input of vertex
// GLSL-NOT: COLOR
// GLSL: in vec2 vs_TEXCOORD1[];
// GLSL-NOT: V v[3]
// GLSL: O(gl_in[i].gl_Position, bool(vs_FLAG0[i]) ? vs_TEXCOORD1[i] : vec2(0.0, 1.0))
[maxvertexcount(3)]
void parts(triangle V v[3], inout TriangleStream<O> stream) {
  for (uint i = 0; i < 3; ++i) {
    O o = {v[i].p, v[i].is_on ? v[i].uv[1] : float2(0, 1)};
    stream.Append(o);
  }
}

float4 Sum(V v) { return v.p + v.uv[0].xyxy; }

// WHOLE: V v[3]
[maxvertexcount(3)]
void whole(triangle V v[3], inout TriangleStream<O> stream) {
  for (uint i = 0; i < 3; ++i) {
    O o = {Sum(v[i]), v[i].uv[1]};
    stream.Append(o);
  }
}

// WRITTEN: V v[3]
[maxvertexcount(3)]
void written(triangle V v[3], inout TriangleStream<O> stream) {
  for (uint i = 0; i < 3; ++i) {
    v[i].p.x += 1;
    O o = {v[i].p, v[i].uv[0]};
    stream.Append(o);
  }
}
