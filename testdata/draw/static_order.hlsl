// Every static variable outside of functions gets its value in the order of the text, one that nothing names too: DXC's
// emitEntryFunctionWrapper, "Initialize all global variables at the beginning of the wrapper". One without an effect is left out.
// RUN: %clipc -T vs_5_0 -E main --validate %s -o - | FileCheck %s
// RUN: %draw compare %s -T vs_5_0 -E main
// RUN: %draw compare %s -T vs_6_0 -E main --target=vulkan
struct Random { uint state; uint Next() { state = state * 5 + 1; return state; } };
uint Pure(uint x) { uint seed = x; seed += 2; return seed; }
uint Broken(uint x) { return x.missing; }

static uint seed = 7;
uint Next() { seed = seed * 1664525 + 1013904223; return seed; }
static uint before = seed ^ 3;
static uint first = Next();
static uint unnamed = Next();
static const uint third = Next();
static uint unused = Pure(4);
static uint broken = Broken(4);
static uint after = seed ^ 1;
static uint assigned = seed += 2;
void Swap(inout uint a, uint b) { a ^= b; }
uint Swapped() { Swap(seed, 9); return 1; }
static float2 swapped = { Swapped(), 2 };
// The variable of the function gets its value once, and its function is called twice.
uint Kept() { static uint kept = seed; return kept++; }
static uint kept[2] = { Kept(), Kept() };
static Random random;
static uint dropped = random.Next();
static uint of_random = random.state;
// CHECK: uint before = seed ^ 3u;
// CHECK-NOT: Pure
// CHECK: void main() {
// CHECK-NEXT: first = Next();
// CHECK-NEXT: unnamed = Next();
// CHECK-NEXT: third = Next();
// CHECK-NEXT: after = seed ^ 1u;
// CHECK-NEXT: assigned = seed += 2u;
// CHECK-NEXT: swapped = vec2(float(Swapped()), 2.0);
// CHECK-NEXT: kept = uint[2](Kept(), Kept());
// CHECK-NEXT: dropped = Next(random);
// CHECK-NEXT: of_random = random.state;
// CHECK-NEXT: gl_Position
float4 main(float4 p : P) : SV_Position { return float4(first % 100 + before % 10, third % 100, after % 100 + of_random, seed % 100 + (kept[1] - kept[0])); }
