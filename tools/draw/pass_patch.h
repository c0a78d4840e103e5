// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/draw/pass_on.h"

// Shaders before and after those of patches, without their first lines, the version.
namespace clipc::draw {

// Far more points than the factors of kEdgeFactors make of a patch.
inline constexpr int kMostPoints = 128;

// Statements of a hull shader that give a patch the factors kEdgeFactors and kInsideFactors.
std::string FactorValuesText();

// A vertex shader and a hull shader that pass the random control points and constants on to a
// domain shader, with those factors. Throws DrawError for inputs that no test draws with.
PassedOn PassPatch(const Shader& shader, const RandomInputs& random, PassOnFor api);

// The factors of a hull shader are data in a run: these outputs have them, which lie after all
// others. The tessellator makes a line of segments instead, whose points are the control points.
struct FactorsAsData {
  std::string_view builtin, name;
  std::uint32_t location, count;
};
inline constexpr FactorsAsData kFactors[] = {{"gl_TessLevelOuter", "test_outer", 24, 4},
                                             {"gl_TessLevelInner", "test_inner", 28, 2}};
std::uint32_t SegmentsOf(const ir::Program& hull);
// The declarations of the factors as data, "in" or "out". They have locations where others do.
std::string FactorsText(const Shader& hull, std::string_view direction, PassOnFor api);

// The domain shader that takes some outputs of a hull shader to where they are captured.
struct TakenOut {
  std::string text;
  std::vector<std::string> names;  // of the outputs, and of the number of the control point
};
TakenOut TakeOut(const Shader& hull, const std::vector<std::string>& outputs, PassOnFor api);
// The captured outputs in the order of the control points. The last of `captured` has the numbers.
std::vector<Captured> InOrder(const ir::Program& hull, std::vector<Captured> captured);

}  // namespace clipc::draw
