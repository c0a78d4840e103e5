// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A step of particles: a thread moves one particle, and lists its number if the particle lives on.
// clipc -T cs_5_0
struct Particle {
  float3 position;
  float age;
  float3 velocity;
  float lifetime;
};

cbuffer Step : register(b0) {
  float3 gravity;
  float seconds;  // since the last step
  float ground;   // the height at which particles bounce
  float bounce;   // the part of the speed that they keep
};

StructuredBuffer<Particle> before : register(t0);
RWStructuredBuffer<Particle> after : register(u0);
// The particles to draw. The counter of this buffer, 0 before the dispatch, becomes their number.
AppendStructuredBuffer<uint> alive : register(u1);

[numthreads(64, 1, 1)]
void main(uint id : SV_DispatchThreadID) {
  // The last group may have more threads than there are particles.
  uint count, stride;
  before.GetDimensions(count, stride);
  if (id >= count) return;

  Particle p = before[id];
  p.age += seconds;
  p.velocity += gravity * seconds;
  p.position += p.velocity * seconds;
  if (p.position.y < ground) {
    p.position.y = ground;
    p.velocity.y *= -bounce;
  }
  after[id] = p;

  // Any thread may be first, so the list has no particular order.
  if (p.age < p.lifetime) alive.Append(id);
}
