// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "frontend/check/entry_point.h"
#include "rewrite/distances.h"

namespace clipc::rewrite {

// The pixel shader of a pair, which discards what is outside of the vertex shader's planes.
struct PixelForm {
  PlaneForm planes;
  // Parameters for the outputs of the vertex shader that the pixel shader does not read: they keep
  // the distances at one location in both.
  std::vector<std::string> unread;
  // The discard comes before the call, so that a pixel that is outside writes no memory. Otherwise
  // it comes after it, so that all pixels have their derivatives: compilers for Vulkan and OpenGL
  // end a pixel where Direct3D only stops drawing it.
  bool discards_first = false;
};

// The outputs of the vertex shader that the pixel shader does not read, as parameters. With
// `has_locations` each has its [[vk::location]].
std::vector<std::string> UnreadOutputs(const EntryPoint& vertex, const EntryPoint& pixel,
                                       bool has_locations);

// The location after those of the vertex shader's outputs.
std::uint32_t LocationAfterOutputs(const ir::Program& vertex);

// Returns a function `name` that calls the pixel shader's entry function, which is called `inner`
// by now, and discards for the first `planes` planes:
//
//   float4 name(VsOut i, float2 clipc_distances0 : CLIP_PLANE_DISTANCE0) : SV_Target
//   {
//       float4 clipc_result = inner(i);
//       if (!all(clipc_distances0 >= 0.0)) discard;
//       return clipc_result;
//   }
//
// A distance that is not a number is outside, as for the device's clipping; clip() would keep it.
std::string WritePixelWrapper(const EntryPoint& entry, const PixelForm& form,
                              const std::string& name, const std::string& inner,
                              std::size_t planes);

}  // namespace clipc::rewrite
