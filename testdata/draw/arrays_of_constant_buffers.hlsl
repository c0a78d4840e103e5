// An array of ConstantBuffer<T> is a value: an argument, an initial value and what is assigned.
// RUN: %draw compare %s -T vs_5_1
struct Part { float4 color; float2 scale[2]; };
ConstantBuffer<Part> parts[2];

float4 Pick(ConstantBuffer<Part> from[2], int i) { return from[i].color + from[1 - i].scale[1].xyxy; }

float4 main(float4 p : POSITION, uint id : SV_VertexID) : SV_Position {
  int i = id % 2;
  Part local[2] = parts;
  local[i].color += p;
  Part again[2];
  again = parts;
  return Pick(parts, i) + local[1].color + again[i].scale[0].xyxy;
}
