// What a vertex writes to buffers and changes in one step, it reads back: each vertex has elements of its own, since nothing says
// which vertex is first.
// RUN: %draw compare %s -T vs_5_0 --target=glsl450,vulkan
// RUN: %draw compare %s -T vs_5_0 --target=essl310 --lower=none
RWStructuredBuffer<uint> counts : register(u0);
RWStructuredBuffer<int> numbers : register(u1);
RWByteAddressBuffer bytes : register(u2);
RWStructuredBuffer<float4> places : register(u3);

struct Output {
  float4 position : SV_Position;
  nointerpolation uint4 before : BEFORE;
  nointerpolation uint4 after : AFTER;
  nointerpolation int4 numbers : NUMBERS;
  nointerpolation uint4 words : WORDS;
  nointerpolation int4 signs : SIGNS;
};

Output main(float4 p : POSITION, int n : NUMBER, uint id : SV_VertexID) {
  Output o;
  const uint i = 2 * id;
  o.position = p;
  InterlockedAdd(counts[i], 3, o.before.x);
  InterlockedOr(counts[i], 0x100, o.before.y);
  InterlockedXor(counts[i + 1], n, o.before.z);
  InterlockedExchange(counts[i + 1], 7, o.before.w);
  InterlockedAnd(counts[i], 0xfe);
  InterlockedCompareStore(counts[i + 1], 7, id);
  o.after = uint4(counts[i], counts[i + 1], 0, 0);
  InterlockedCompareExchange(counts[i + 1], 1000, 1, o.after.z);
  o.after.w = counts[i + 1];
  InterlockedMin(numbers[i], n, o.numbers.x);
  InterlockedMax(numbers[i], -2, o.numbers.y);
  numbers[i + 1] = n * 2;
  o.numbers.zw = int2(numbers[i], numbers[i + 1]);
  bytes.InterlockedMax(16 * id, 5u, o.words.x);
  bytes.InterlockedMin(16 * id + 4, 9u, o.words.y);
  // Of a word of bytes, the value says whether it has a sign (fxc's atomic_imax and atomic_umax in vkd3d's
  // test_atomic_instructions; OpAtomicSMin in DXC's method.rw-byte-address-buffer.atomic).
  bytes.InterlockedMin(16 * id + 4, n - 5, o.signs.x);
  bytes.InterlockedMax(16 * id + 4, n, o.signs.y);
  o.signs.zw = asint(bytes.Load2(16 * id));
  bytes.Store2(16 * id + 8, uint2(id, n));
  o.words.x += bytes.Load(16 * id);
  o.words.zw = bytes.Load2(16 * id + 8);
  places[id] = p.wzyx;
  places[id].yz *= 2;
  o.position += places[id];
  return o;
}
