// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "link/whole.h"

#include <cstddef>

namespace clipc::link {
namespace {

using namespace ir;

// Whether the output is a row of the matrix that `first` is a row of. A matrix of one column is a
// vector in GLSL, and one of doubles takes two locations for each row.
bool IsRowOfSame(const Program& program, const IoVar& first, const IoVar& output) {
  const Type& type = program.types[program.vars[output.var].type];
  return output.builtin == Builtin::kNone && !output.path.empty() && output.path == first.path &&
         type.Components() > 1 && BaseOf(type.scalar) == Scalar::kFloat;
}

// The same for inputs or outputs.
void KeepMatricesWhole(const Program& program, IoVars& list, bool only_square) {
  for (std::size_t first = 0; first < list.size();) {
    std::size_t end = first;
    while (end < list.size() && IsRowOfSame(program, list[first], list[end])) ++end;
    const std::size_t rows = end - first;
    const Type& row = program.types[program.vars[list[first].var].type];
    const bool is_kept = rows > 1 && (!only_square || rows == row.Components());
    for (std::size_t i = first; is_kept && i < end; ++i) {
      ir::Reader& reader = list[i].reader.emplace();
      reader.is_known = false;
      reader.columns = static_cast<std::uint32_t>(rows);
      reader.element = static_cast<std::uint32_t>(i - first);
    }
    first = end > first ? end : first + 1;
  }
}

}  // namespace

void KeepMatricesWhole(Program& program, bool only_square) {
  const StageInfo& stage = clipc::InfoOf(program.stage);
  if (stage.has_stage_before) KeepMatricesWhole(program, program.inputs, only_square);
  if (stage.has_stage_after) KeepMatricesWhole(program, program.outputs, only_square);
}

}  // namespace clipc::link
