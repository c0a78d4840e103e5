// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "clip-table/vocabulary.h"
#include "ir/program.h"

namespace clipc::passes {

struct ClipPlaneOptions {
  Lowering lowering = Lowering::kClipDistance;
  PlaneSpace space = PlaneSpace::kClip;
  ir::VarId position_input = {};   // the input with the position; for kObject
  bool write_clip_vertex = false;  // for kLevel9: the target has gl_ClipVertex
};

// Turns the clip planes of the entry point into outputs, at the end of `main`, where every path of
// the shader ends.
//
// Requires Form::kResolved; for kClipDistance that no output is kClipDistance yet; for kNearPlane
// at most one plane; Supports(lowering, space); for PlaneSpace::kObject that position_input
// is a float3 or float4 input. Ensures Form::kNoClipPlanes.
//
//   gl_Position = result.position;            gl_Position = result.position;
//                                       =>    gl_ClipDistance[0] = dot(result.position, plane0);
//                                             gl_ClipDistance[1] = dot(result.position, plane1);
//
// An output is read again only where the position is not a copy of a local variable. kNearPlane
// writes `result.position.z = dot(result.position, plane); gl_Position = result.position;`: the
// plane asks 0 <= z, and interpolates as z does. kDiscard writes the distances as float vectors of
// up to four components whose semantic is ir::kClipPlaneDistance.
//
// With PlaneSpace::kXyw1 the dot product is dot(float4(result.position.xyw, 1), plane), whose first
// operand is a variable `xyw1`; with kObject dot(in_POSITION0, plane). See docs/runtime.md, "Plane
// spaces", for the constants that then mean the same plane.
//
// The position is the one the HLSL shader wrote (Direct3D clip space), so this runs before
// AdjustClipSpace.
void LowerClipPlanes(ir::Program& program, const ClipPlaneOptions& options);

}  // namespace clipc::passes
