// Structured control flow: loops with their merge and continue blocks, a switch that falls through, operators and choices that skip a
// side, early returns.
// RUN: %clipc -T vs_6_0 -spirv -S %s -o - | FileCheck %s
// RUN: %clipc -T vs_6_0 -spirv %s -o %t.spv && spirv-val --target-env vulkan1.1 %t.spv
// RUN: %draw compare %s -T vs_6_0 --target vulkan
float4 limits;
int steps;
static float total = limits.x;

float Sum(int count, inout float last) {
  float sum = 0;
  for (int i = 0; i < count; ++i) {
    if (i == 5) break;
    if ((i & 1) != 0) continue;
    sum += i * limits.y;
    last = sum;
  }
  int left = count;
  do {
    --left;
    if (left < 2) return sum;
  } while (left > 0 && sum + limits[left & 3] < 100);
  while (true) {
    sum -= 1;
    if (sum < 0) break;
  }
  return sum;
}

// CHECK: OpSource HLSL 600
// CHECK: OpSwitch {{%[0-9]+}} [[OTHERWISE:%[0-9]+]] 0 [[FIRST:%[0-9]+]] 1 [[FIRST]] 2 {{%[0-9]+}}
// CHECK: OpPhi %bool
// CHECK: OpFunctionEnd
// CHECK: OpLoopMerge [[MERGE:%[0-9]+]] [[NEXT:%[0-9]+]] None
// CHECK: OpSelectionMerge
// CHECK: OpBranch [[MERGE]]
float4 main(float4 p : POSITION, int kind : KIND) : SV_Position {
  float last = 1;
  float4 color = Sum(steps & 7, last);
  switch (kind & 3) {
    case 0:
    case 1: color.x += 1;
    case 2: color.y += last; break;
    default: color.z = total++;
  }
  if (p.x > 0 && color.y / (p.x + 1) > limits.z) return color;
  color.w = p.y > 0 ? Sum(3, color.z) : p.z;
  return color + total;
}
