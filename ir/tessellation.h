// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "ir/ids.h"

// What hull and domain shaders say of a patch. The names are HLSL's.
namespace clipc::ir {

// [domain("tri")]: the shape in which the tessellator makes points.
enum class Domain : std::uint8_t { kTriangle, kQuad, kIsoline };
struct DomainInfo {
  std::string_view name;
  std::uint32_t factors = 0;         // SV_TessFactor's elements
  std::uint32_t inside_factors = 0;  // SV_InsideTessFactor's
  int coordinates = 0;               // SV_DomainLocation's components
};
inline constexpr DomainInfo kDomains[] = {
    {"tri", 3, 1, 3}, {"quad", 4, 2, 2}, {"isoline", 2, 0, 2}};
constexpr const DomainInfo& InfoOf(Domain domain) {
  return kDomains[static_cast<std::size_t>(domain)];
}

// [partitioning("integer")]: how the edges are cut.
enum class Partitioning : std::uint8_t { kInteger, kPow2, kFractionalEven, kFractionalOdd };
inline constexpr std::string_view kPartitionings[] = {"integer", "pow2", "fractional_even",
                                                      "fractional_odd"};

// [outputtopology("triangle_cw")]: what the tessellator makes of the points.
enum class OutputTopology : std::uint8_t { kPoint, kLine, kTriangleCw, kTriangleCcw };
inline constexpr std::string_view kOutputTopologies[] = {"point", "line", "triangle_cw",
                                                         "triangle_ccw"};

inline constexpr std::uint32_t kMostControlPoints = 32;

struct Tessellation {
  std::optional<Domain> domain;
  // The control points that a hull shader reads, InputPatch<T, n>.
  std::uint32_t input_points = 0;
  // [outputcontrolpoints] of a hull shader; in a domain shader those of OutputPatch<T, n>.
  std::uint32_t output_points = 0;
  // A hull shader has them. GLSL needs them in the domain shader, which the program or the request
  // gives them.
  std::optional<Partitioning> partitioning;
  std::optional<OutputTopology> topology;
  std::optional<float> max_factor;  // [maxtessfactor]
  FunctionId patch_function;        // [patchconstantfunc] of a hull shader
};

}  // namespace clipc::ir
