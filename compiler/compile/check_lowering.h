// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>

#include "backend-glsl/target.h"
#include "base/diagnostics.h"
#include "clip-table/vocabulary.h"
#include "frontend/check/check_options.h"
#include "ir/profile.h"
#include "ir/program.h"

// The rules about what a user may ask of a shader's clip planes: which lowering is allowed with
// which plane space, and with which shader.
namespace clipc {

// The lowering that the user asks for.
struct LoweringRequest {
  Lowering lowering = Lowering::kClipDistance;
  PlaneSpace plane_space = PlaneSpace::kClip;
  // The semantic of the vertex's position, for plane space kObject; empty: POSITION0.
  std::string position_input;
  std::uint32_t distances = 0;  // the least number of clip distances, for kClipDistance
};

// Direct3D's and Vulkan's limit, with cull distances.
inline constexpr std::uint32_t kMaxClipDistances = 8;

// The lowering of a shader that is compiled for `profile` when the user names none: kLevel9 for the
// level_9_x profiles, kClipDistance for the others.
Lowering DefaultLowering(const ir::Profile& profile);

// Reports a lowering and a plane space that do not go together, whatever the shader.
void CheckRequest(const LoweringRequest& request, Diagnostics& diagnostics);

// Reports a lowering that HLSL cannot have.
void CheckHlslRequest(const LoweringRequest& request, Diagnostics& diagnostics);

// Reports where the shader's clip planes and the request do not fit each other. Returns the input
// that carries the position for kObject; none for the other spaces, for a shader without planes,
// and after an error. Requires Form::kResolved.
ir::VarId FindPositionInput(const ir::Program& program, const LoweringRequest& request,
                            Diagnostics& diagnostics);

// Reports the clip planes of a shader that another one follows before the rasteriser, `last`,
// unless they are moved to that. They cannot be moved to a hull shader, whose positions are not
// drawn.
void CheckPlanesMoved(const ir::Program& program, const CheckOptions& last, bool are_moved,
                      Diagnostics& diagnostics);

// Reports clip planes that only the clip table has: the device clips with them, not the GLSL.
void CheckPlanesAreKept(const ir::Program& program, const LoweringRequest& request,
                        const glsl::Target& target, Diagnostics& diagnostics);

// Reports more scalars than a shader may emit, with the clip distances that the lowering adds, and
// more vertices than every driver takes: gl_MaxGeometryOutputVertices of OpenGL and OpenGL ES,
// maxGeometryOutputVertices of Vulkan.
void CheckEmission(const ir::Program& lowered, Diagnostics& diagnostics);

// Reports a pixel shader that discards for clip planes after it has written depth and stencil.
void CheckDiscards(const ir::Program& pixel, Diagnostics& diagnostics);

// The output that carries the clip distances, and the number of its elements; none and 0 for a
// program without it.
struct ClipDistances {
  ir::VarId output;
  std::uint32_t count = 0;
};
ClipDistances ClipDistancesOf(const ir::Program& program);

// Reports the clip distances that the HLSL shader writes (`before`, taken from the program in
// Form::kResolved) and the lowered program does not.
void ReportLeftOut(const ClipDistances& before, const ir::Program& lowered,
                   Diagnostics& diagnostics);

}  // namespace clipc
