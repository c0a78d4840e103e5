// Scalar replacement: what a variable that carries inputs or outputs is split into, and what keeps it whole.
// RUN: %clipc -T vs_5_0 -E fields --dump-after=adjust-clip-space %s | FileCheck %s --check-prefix=BEFORE
// RUN: %clipc -T vs_5_0 -E fields --dump-after=split-variables %s | FileCheck %s --check-prefix=FIELDS
// RUN: %clipc -T vs_5_0 -E plain --dump-after=split-variables %s | FileCheck %s --check-prefix=PLAIN
// RUN: %clipc -T vs_5_0 -E as_a_whole --dump-after=split-variables %s | FileCheck %s --check-prefix=WHOLE
// RUN: %clipc -T vs_5_0 -E own --dump-after=split-variables %s | FileCheck %s --check-prefix=OWN
// RUN: %draw compare -T vs_5_0 -E fields %s
// RUN: %draw compare -T vs_5_0 -E plain %s
// RUN: %draw compare -T vs_5_0 -E as_a_whole %s
// RUN: %draw compare -T vs_5_0 -E own %s
struct Vertex {
  float4 position : POSITION;
  float2 uv : UV;
  float4 unread : UNREAD;
};
struct Varyings {
  float4 position : SV_Position;
  float2 uv : UV;
  float4 color : COLOR;
};

// A field is the input that it is loaded from, a variable of its own when it is changed, or nothing when nothing reads it; or
// it is the output that takes its last value.
// BEFORE: main void main() {
// BEFORE-NEXT: Vertex v.1
// BEFORE-NEXT: v.1.position = in_POSITION0
// BEFORE: Varyings result = fields(v.1)
// BEFORE-NEXT: vs_SV_POSITION0 = result.position
// FIELDS: main void main() {
// FIELDS-NEXT: float2 uv = in_UV0
// FIELDS-NEXT: uv += splat<float2>(1.0)
// FIELDS-NEXT: vs_SV_POSITION0 = in_POSITION0
// FIELDS-NEXT: vs_UV0 = uv * uv
// FIELDS-NEXT: vs_COLOR0 = splat<float4>(0.0)
// FIELDS-NEXT: }
Varyings fields(Vertex v) {
  Varyings o;
  v.uv += 1;
  o.position = v.position;
  o.uv = v.uv * v.uv;
  o.color = (float4)0;
  return o;
}

// A variable of another type is replaced too.
// PLAIN: main void main() {
// PLAIN-NEXT: vs_SV_POSITION0 = in_POSITION0 + in_OFFSET0
// PLAIN-NEXT: vs_SV_POSITION0.w = 1.0
// PLAIN-NEXT: }
float4 plain(float4 p : POSITION, float4 offset : OFFSET) : SV_Position {
  float4 moved = p + offset;
  moved.w = 1;
  return moved;
}

// A struct that a function takes stays, and gets its inputs in one statement.
// WHOLE: main void main() {
// WHOLE-NEXT: Vertex v.{{[0-9]+}} = Vertex{in_POSITION0, in_UV0, in_UNREAD0}
// WHOLE-NEXT: vs_SV_POSITION0 = place(v.{{[0-9]+}})
// WHOLE-NEXT: }
float4 place(Vertex v) { return v.position + v.uv.xyxy; }
float4 as_a_whole(Vertex v) : SV_Position { return place(v); }

// A struct that carries no input or output is the shader's own, and is left alone.
// OWN: main void main() {
// OWN: Vertex copy
// OWN: copy.position = in_POSITION0
// OWN: vs_SV_POSITION0 = copy.position + copy.uv.xyxy
float4 own(float4 p : POSITION) : SV_Position {
  Vertex copy;
  copy.position = p;
  copy.uv = p.xy;
  return copy.position + copy.uv.xyxy;
}
