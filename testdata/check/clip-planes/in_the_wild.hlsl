// Forms seen in real programs: an attribute made by a macro, on a member of a ConstantBuffer; entry and cbuffer in a namespace.
// RUN: %clipc -T vs_5_1 -E NS::main --validate %s -o - | FileCheck %s
// RUN: %clipc -T vs_5_1 -E viaMacro --validate %s -o - | FileCheck %s --check-prefix=MACRO
#define PLANES [clipplanes(state.plane0, state.plane1)]
struct State { float4 plane0, plane1; };
ConstantBuffer<State> state : register(b0, space1);

namespace NS {
  cbuffer Clip { float4 leftPlane, topPlane; };
  [clipplanes(leftPlane,
              topPlane)]
  void main(float4 v : POSITION, out float4 position : SV_Position) { position = v; }
}
// CHECK: gl_ClipDistance[0] = dot(position, clip.leftPlane);
// CHECK: gl_ClipDistance[1] = dot(position, clip.topPlane);

[loop] PLANES float4 viaMacro(float4 v : POSITION) : SV_Position { return v; }
// MACRO: gl_ClipDistance[1] = dot(in_POSITION0, state.plane1);
