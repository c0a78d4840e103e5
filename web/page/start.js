// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The shader that the page begins with, for each matrix chain.
const shader = (constants, position) => `// Turn the plane below, or change something here.
// clipc -T vs_5_0
${constants}  float4x4 world;
  float4 plane;
};

struct Vertex {
  float3 position : POSITION;
  float3 normal : NORMAL;
};
struct Varyings {
  float4 position : SV_Position;
  float3 normal : NORMAL;
};

[clipplanes(plane)]
Varyings main(Vertex v) {
  Varyings o;
${position}  o.normal = mul(v.normal, (float3x3)world);
  return o;
}
`;

const IN_STEPS = shader(
  `cbuffer Camera : register(b0) {
  float4x4 view_projection;
};
cbuffer Object : register(b1) {
`,
  `  float4 world_position = mul(float4(v.position, 1), world);
  o.position = mul(world_position, view_projection);
`,
);
const AT_ONCE = shader(
  `cbuffer Object : register(b0) {
  float4x4 world_view_projection;
`,
  `  o.position = mul(float4(v.position, 1), world_view_projection);
`,
);

/** The start of the chain `chain`, a key of CHAINS. */
export const startOf = (chain) => (chain === 'one' || chain === 'float' ? AT_ONCE : IN_STEPS);
export const isStart = (text) => text === IN_STEPS || text === AT_ONCE;
