// glslang 12 ends the process where it follows `precise` to a field of an array's element; --validate does not show it the word.
// RUN: %clipc -T vs_5_0 --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_0 -Gis --validate %s -o %t.vert
struct Vertex {
  float4 position : POSITION;
  float t : T;
  float3 direction : D;
};

// CHECK: {{^}}precise gl_Position;
precise float4 main(Vertex vertex) : SV_Position {
  Vertex both[2] = {vertex, vertex};
  return both[0].position + float4(both[0].t, both[0].direction);
}
