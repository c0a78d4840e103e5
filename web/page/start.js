// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The shaders that the page begins with, for each matrix chain.
const shader = (constants, position) => `// Drag the plane, or change something here.
// clipc -T vs_5_0 --pixel-entry=ps
${constants} float4x4 world; float4 plane; };

struct Varyings { float4 position : SV_Position; float3 normal : NORMAL; };

[clipplanes(plane)]
Varyings main(float3 position : POSITION, float3 normal : NORMAL) {
  Varyings o;
${position}  o.normal = mul(normal, (float3x3)world);
  return o;
}

float4 ps(Varyings v, bool is_outside : SV_IsFrontFace) : SV_Target {
  float3 color = is_outside ? float3(0.95, 0.62, 0.25)
                            : float3(0.35, 0.55, 0.8);
  float3 light = normalize(float3(0.4, 0.8, 0.45));
  float slope = abs(dot(normalize(v.normal), light));
  return float4(color * (0.35 + 0.65 * slope), 1);
}
`;

const IN_STEPS = shader(
  `cbuffer Camera : register(b0) { float4x4 view_projection; };
cbuffer Object : register(b1) {`,
  `  float4 world_position = mul(float4(position, 1), world);
  o.position = mul(world_position, view_projection);
`,
);
const AT_ONCE = shader(
  `cbuffer Object : register(b0) {
  float4x4 world_view_projection;
 `,
  '  o.position = mul(float4(position, 1), world_view_projection);\n',
);

/** The start of the chain `chain`, a key of CHAINS. */
export const startOf = (chain) => (['one', 'float', 'baked'].includes(chain) ? AT_ONCE : IN_STEPS);
export const isStart = (text) => text === IN_STEPS || text === AT_ONCE;
