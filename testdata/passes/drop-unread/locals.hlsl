// A local variable that nothing reads is removed, with the variables that only it needed; what changes something else stays.
// RUN: %clipc -T vs_5_0 --dump-after=drop-unread %s | FileCheck %s
// RUN: %draw compare -T vs_5_0 %s
float4 tint;
bool is_on;
static int calls;

float4 counted(float4 x) {
  ++calls;
  return x * 2;
}
struct Pair {
  float4 first, second;
};

// CHECK: main void main.1() {
// CHECK-NOT: chain
// CHECK-NOT: pair
// CHECK-NOT: array
// CHECK: float4 kept = counted(tint)
// CHECK: float4 in_branch
// CHECK: if (is_on)
// CHECK-NOT: unset
// CHECK: vs_SV_POSITION0 =
void main(float4 p : POSITION, float3 n : NORMAL, out float4 position : SV_Position, out float4 color : COLOR) {
  float4 chain = float4(n, 1);
  float4 chained = chain * tint;
  chained.x = chained.y;
  Pair pair;
  pair.first = p;
  pair.second = p + 1;
  float array[2];
  array[0] = p.x;
  float4 kept = counted(tint);
  float4 in_branch = p;
  if (is_on) in_branch = tint;
  float4 unset;
  position = p;
  color = float4(tint.xyz, calls);
}
