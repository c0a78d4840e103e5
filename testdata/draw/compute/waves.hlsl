// The lanes of a wave: what they give each other, in all of them and under conditions, is on lavapipe what the reference evaluator says
// of waves with as many lanes. Lane i of wave w is thread 8w + i of the group where a wave has eight.
// RUN: %draw compare %s -T cs_6_0 -E sums --target=vulkan --quarters
// RUN: %draw compare %s -T cs_6_0 -E bits --target=vulkan
// RUN: %draw compare %s -T cs_6_0 -E reads --target=vulkan
// RUN: %draw compare %s -T cs_6_0 -E some --target=vulkan
// RUN: %draw compare %s -T cs_6_0 -E loops --target=vulkan
// RUN: %draw compare %s -T cs_6_0 -E leaves --target=vulkan
// RUN: %draw compare %s -T cs_6_0 -E quads --target=vulkan
// RUN: %draw compare %s -T cs_6_0 -E lists --target=vulkan
StructuredBuffer<float4> values;
StructuredBuffer<int2> numbers;
RWStructuredBuffer<float4> floats;
RWStructuredBuffer<int4> ints;
RWStructuredBuffer<uint4> uints;

float4 ValueOf(uint i) { return values[i % 7]; }
int2 NumberOf(uint i) { return numbers[i % 7] + int(i % 5); }

[numthreads(8, 2, 1)]
void sums(uint i : SV_GroupIndex, uint3 group : SV_GroupID) {
  const uint at = i + 16 * (group.x + 3 * group.y);
  const float4 value = ValueOf(at);
  const int2 number = NumberOf(at);
  floats[3 * at] = WaveActiveSum(value) + WavePrefixSum(value.wzyx);
  floats[3 * at + 1] = float4(WaveActiveMin(value.xy), WaveActiveMax(value.zw));
  // Products of powers of two are exact.
  const float2 power = float2(i % 2 ? 2 : 0.5, i % 3 ? -2 : 0.25);
  floats[3 * at + 2] = float4(WaveActiveProduct(power), WavePrefixProduct(power));
  ints[at] = int4(WaveActiveSum(number), WavePrefixSum(number)) + WaveActiveProduct(number.x) * WavePrefixProduct(number.y);
  uints[at] = uint4(WaveActiveMin(at), WaveActiveMax(at), uint(WaveActiveMin(number.x)), uint(WaveActiveMax(number.y)));
}

[numthreads(16, 1, 1)]
void bits(uint i : SV_GroupIndex, uint3 group : SV_GroupID) {
  const uint at = i + 16 * (group.x + 3 * group.y);
  const int2 number = NumberOf(at);
  const uint mask = uint(number.x);
  uints[3 * at] = uint4(WaveActiveBitAnd(mask), WaveActiveBitOr(mask), WaveActiveBitXor(uint2(mask, at)));
  uints[3 * at + 1] = WaveActiveBallot(number.y > 2);
  uints[3 * at + 2] = uint4(WaveActiveCountBits(number.x > 1), WavePrefixCountBits(number.y > 1), WaveGetLaneIndex(), WaveGetLaneCount());
  ints[at] = int4(WaveActiveAllTrue(number.x > -5), WaveActiveAnyTrue(number.y > 7), WaveActiveAllTrue(number.x > 2), WaveIsFirstLane());
}

[numthreads(24, 1, 1)]
void reads(uint i : SV_GroupIndex, uint3 group : SV_GroupID) {
  const uint at = i + 24 * (group.x + 3 * group.y);
  floats[at] = WaveReadLaneAt(ValueOf(at), 3) + WaveReadLaneFirst(ValueOf(at + 1));
  ints[at].xy = WaveReadLaneAt(NumberOf(at), (i * 5 + 2) % 8);
  ints[at].zw = int2(WaveActiveAllEqual(int2(at / 8, at / 4)));
  uints[at] = uint4(WaveActiveAllEqual(ValueOf(at / 8)));
}

// Lanes that are not there do not count, and the first lane is the first of those that are.
[numthreads(16, 1, 1)]
void some(uint i : SV_GroupIndex, uint3 group : SV_GroupID) {
  const uint at = i + 16 * (group.x + 3 * group.y);
  uint4 result = 0;
  if (i % 3 == 1) {
    result.x = WaveActiveSum(at) + WavePrefixSum(i);
    result.y = WaveReadLaneFirst(at) + (WaveIsFirstLane() ? 1000 : 0);
    result.z = WaveActiveBallot(true).x;
  } else {
    result.x = WavePrefixCountBits(i % 2 == 0);
    switch (i % 4) {
      case 0: result.y = WaveActiveMax(i); break;
      case 1: result.y = WaveActiveMin(i); break;
      default: result.y = WaveActiveSum(i); break;
    }
    result.z = WaveActiveBallot(i > 5).x;
  }
  result.w = WaveActiveCountBits(result.x > 4);
  uints[at] = result;
}

uint Step(uint n) { return WaveActiveSum(n) + 1; }

// Lanes leave a loop one after another; a result decides who stays. No wave operation is after the second loop: then Mesa 22.3.6 takes
// for the last iteration of each lane what the others give after it left.
[numthreads(8, 1, 1)]
void loops(uint i : SV_GroupIndex, uint3 group : SV_GroupID) {
  const uint at = i + 8 * (group.x + 3 * group.y);
  uint4 result = 0;
  for (uint k = 0; k < i + 1; ++k) result.x = result.x * 3 + Step(k + i);
  result.z = WaveActiveMax(result.x);
  uints[at] = result;
}
[numthreads(8, 1, 1)]
void leaves(uint i : SV_GroupIndex, uint3 group : SV_GroupID) {
  const uint at = i + 8 * (group.x + 3 * group.y);
  uint4 result = 0;
  uint left = i;
  [loop] while (true) {
    const uint least = WaveReadLaneFirst(left);
    result.y += WaveActiveSum(left);
    if (left == least) break;
  }
  uints[at] = result;
}

[numthreads(8, 2, 1)]
void quads(uint i : SV_GroupIndex, uint3 group : SV_GroupID) {
  const uint at = i + 16 * (group.x + 3 * group.y);
  const float4 value = ValueOf(at);
  floats[2 * at] = QuadReadAcrossX(value) - QuadReadAcrossY(value);
  floats[2 * at + 1] = QuadReadAcrossDiagonal(value) - QuadReadLaneAt(value, 2);
  ints[at].xy = QuadReadLaneAt(NumberOf(at), i & 3);
}

groupshared uint sums_of_waves[4];

// One atomic operation for a wave; sums of waves by shared memory, over a barrier.
[numthreads(32, 1, 1)]
void lists(uint i : SV_GroupIndex, uint3 group : SV_GroupID) {
  const uint at = i + 32 * (group.x + 3 * group.y);
  const bool is_in = NumberOf(at).x > 1;
  const uint count = WaveActiveCountBits(is_in), before = WavePrefixCountBits(is_in);
  uint first = 0;
  if (WaveIsFirstLane()) {
    InterlockedAdd(uints[at].w, count, first);
    sums_of_waves[i / 8] = count;
  }
  first = WaveReadLaneFirst(first);
  GroupMemoryBarrierWithGroupSync();
  uint sum = before;
  for (uint wave = 0; wave < i / 8; ++wave) sum += sums_of_waves[wave];
  uints[at].xyz = uint3(sum, first, WaveActiveSum(sum));
}
