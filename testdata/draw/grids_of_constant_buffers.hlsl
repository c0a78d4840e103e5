// An array of ConstantBuffer<T> may have several dimensions; a row of it is a value as the whole array is.
// RUN: %draw compare %s -T vs_5_1 --target=glsl450
// RUN: %draw compare %s -T vs_5_1 --target=vulkan
// RUN: %clipc %s -T vs_5_1 --validate -o - | FileCheck %s
struct Part { float4 color; float2 scale[2]; };
ConstantBuffer<Part> grid[2][3];
ConstantBuffer<Part> single[1][1];
cbuffer Choice { uint choice; };

float4 Sum(Part x[3]) { return x[0].color + x[1].color + x[2].scale[1].yyxx; }

// CHECK: Part[3] grid_value(int [[I:i_?[0-9]*]]) {
// CHECK-NEXT: return Part[3](Part(grid{{\[}}[[I]]][0].color, grid{{\[}}[[I]]][0].scale), Part(
// CHECK: Part row[3] = Part[3](Part(grid[1][0].color, grid[1][0].scale)
// CHECK: Sum(grid_value(i))
float4 main(float4 p : POSITION) : SV_Position {
  int i = choice % 2;
  Part row[3] = grid[1];
  return p + grid[i][2].color + grid[0][1].scale[1].xyxy + row[i].color + Sum(grid[i]) + single[0][0].color;
}
