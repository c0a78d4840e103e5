// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "backend-glsl/writer/context.h"

// The common parts of declarations of outputs, and the blocks and structs that outputs are in.
namespace clipc::glsl {

// The qualifier "layout(location = 2) "; nothing without a location.
struct LocationText {
  std::optional<std::uint32_t> location;
};
void AppendPart(std::string& text, const LocationText& part);

// The comment "  // uv : TEXCOORD0", which has the name in HLSL unless it is `name`, that in GLSL;
// and the end of the line.
struct SemanticComment {
  const ir::IoVar& io;
  std::string_view name;
};
void AppendPart(std::string& text, const SemanticComment& part);

struct Interpolated {
  ir::Scalar scalar = ir::Scalar::kFloat;
  ir::Interpolation interpolation = ir::Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
};
// The qualifiers "flat " or "noperspective centroid "; numbers that GLSL cannot interpolate are
// flat.
std::string InterpolationText(WriterContext& context, const Interpolated& output);

// The declarations of Program::output_groups.
std::string GroupsText(WriterContext& context);

}  // namespace clipc::glsl
