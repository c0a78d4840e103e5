// Loops, switches, early returns, arrays and structs by value.
// RUN: %draw compare %s -T vs_6_0 -E main --ints 0..3 --lower none
// RUN: %draw compare %s -T vs_6_0 -E main --ints 0..3 --lower none --target glsl130,essl310,glsl410 --seed 7 --random 200

struct Light {
  float4 color;
  float3 direction;
};
Light lights[4];
int count;
uint mode;
static const float kWeights[4] = {0.5, 0.25, 0.125, 0.0625};
static float4 sum = float4(1, 2, 3, 4);

struct Output {
  float4 position : SV_Position;
  float4 color : COLOR;
};

float4 Shade(Light light, float3 normal) {
  float amount = light.direction.x * normal.x + light.direction.y * normal.y;
  if (amount < 0) return 0;
  return light.color * amount;
}

float Walk(float x) {
  float steps = 0;
  [loop] while (true) {
    if (x > 3) break;
    x += 0.75;
    if (steps == 2) {
      steps += 10;
      continue;
    }
    steps++;
  }
  do {
    --steps;
  } while (steps > 4);
  return steps;
}

Output main(float4 position : POSITION, float3 normal : NORMAL, uint which : BLENDINDICES) {
  Output result = (Output)0;
  float4 kept[4];
  [unroll] for (int i = 0; i < 4; ++i) kept[i] = position * kWeights[i];
  for (int j = 0; j < count; j++) result.color += Shade(lights[j], normal);
  sum += kept[which];
  switch (mode) {
    case 0: result.color.x = 1; break;
    case 1:
    case 2: result.color.yz = position.xy;
    default: result.color.w = Walk(position.x); break;
  }
  result.position = sum;
  return result;
}
