// What the planes are dotted with: the position without z, or the vertex as it comes in.
// RUN: %clipc --validate --plane-space=clip %s | FileCheck %s --check-prefix=CLIP
// RUN: %clipc --validate --plane-space=xyw1 --flip-y --depth-range=negative-one-to-one %s | FileCheck %s --check-prefix=XYW1
// RUN: %clipc --validate --plane-space=object %s | FileCheck %s --check-prefix=OBJECT
// RUN: %clipc --validate --plane-space=object --position-input=base1 %s | FileCheck %s --check-prefix=OTHER
// RUN: %clipc --validate --plane-space xyw1 --lower=discard %s -o %t.vert && FileCheck %s --check-prefix=DISCARD < %t.vert
// RUN: %clipc --validate --plane-space object --lower=near-plane -DONE %s | FileCheck %s --check-prefix=NEAR
// RUN: mkdir -p %t && %clipc --plane-space=object --variants %s -o %t/v.vert && FileCheck %s --check-prefix=ONLY < %t/v.1.vert

cbuffer Frame {
  float4x4 world_view_projection;
  float4 water, portal;
};
struct Input {
  float2 uv : TEXCOORD;
  float3 position : position;
  float4 base : BASE1;
};
struct Output {
  float2 uv : TEXCOORD;
  float4 position : SV_Position;
};

#ifdef ONE
[clipplanes(portal)]
#else
[clipplanes(water, portal)]
#endif
Output main(Input input) {
  input.uv = input.uv * 2;
  Output output;
  float3 moved = input.position;
  moved.x += input.base.x;
  output.position = mul(float4(moved, 1), world_view_projection);
  output.uv = input.uv;
  return output;
}

// CLIP: gl_ClipDistance[0] = dot(position, frame.water);
// CLIP-NEXT: gl_ClipDistance[1] = dot(position, frame.portal);
// XYW1: vec4 xyw1 = position.xyww;
// XYW1-NEXT: xyw1.w = 1.0;
// XYW1-NEXT: gl_ClipDistance[0] = dot(xyw1, frame.water);
// XYW1-NEXT: gl_ClipDistance[1] = dot(xyw1, frame.portal);
// XYW1-NEXT: gl_Position.y = -gl_Position.y;
// OBJECT: gl_ClipDistance[0] = dot(vec4(in_POSITION0, 1.0), frame.water);
// OBJECT-NEXT: gl_ClipDistance[1] = dot(vec4(in_POSITION0, 1.0), frame.portal);
// OTHER: gl_ClipDistance[0] = dot(in_BASE1, frame.water);
// DISCARD: xyw1.w = 1.0;
// DISCARD-NEXT: vs_SV_CLIPPLANEDISTANCE0 = vec2(dot(xyw1, frame.water), dot(xyw1, frame.portal));
// NEAR: position.z = dot(vec4(in_POSITION0, 1.0), frame.portal);
// NEAR-NEXT: gl_Position = position;
// ONLY: gl_ClipDistance[0] = dot(vec4(in_POSITION0, 1.0), frame.water);
// ONLY-NOT: gl_ClipDistance[1]
