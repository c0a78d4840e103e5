// What a pixel shader reads and the geometry shader before it does not write for it: an output of a stream that is not
// drawn, and the number of the primitive, which is what the geometry shader writes.
// RUN: not %clipc %s -E vs --geometry-entry=two --pixel-entry=color -o %t.vert --geometry-output=%t.geom --pixel-output=%t.frag 2>&1 | FileCheck %s
// RUN: not %clipc %s -E vs --geometry-entry=one --pixel-entry=number -o %t.vert --geometry-output=%t.geom --pixel-output=%t.frag 2>&1 | FileCheck %s --check-prefix=NUMBER
// RUN: %clipc %s -E vs --geometry-entry=numbered --pixel-entry=number -o %t.vert --geometry-output=%t.geom --pixel-output=%t.frag --validate 2>&1 | count 0
struct Position { float4 p : SV_Position; };
struct Color { float4 c : COLOR; };
struct Numbered { float4 p : SV_Position; uint id : SV_PrimitiveID; };
Position vs(float4 p : POSITION) { Position o = {p}; return o; }
[maxvertexcount(2)]
// CHECK: [[#@LINE+1]]:6: error: {{.*}} writes nothing that matches the pixel shader's input `COLOR0`; {{.*}} [pixel-input-unwritten]
void two(point Position v[1], inout PointStream<Position> s, inout PointStream<Color> t) {
  Color color = {1, 1, 1, 1};
  s.Append(v[0]);
  t.Append(color);
}
// NUMBER: [[#@LINE+1]]:26: error: the geometry shader does not write `SV_PrimitiveID`, which the pixel shader reads [builtin-unwritten]
[maxvertexcount(1)] void one(point Position v[1], inout PointStream<Position> s) { s.Append(v[0]); }
[maxvertexcount(1)] void numbered(point Position v[1], uint id : SV_PrimitiveID, inout PointStream<Numbered> s) {
  Numbered n = {v[0].p, id};
  s.Append(n);
}
float4 color(Color c) : SV_Target { return c.c; }
float4 number(uint id : SV_PrimitiveID) : SV_Target { return id; }
