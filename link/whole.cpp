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

}  // namespace

void KeepMatricesWhole(Program& program) {
  for (std::size_t first = 0; first < program.outputs.size();) {
    std::size_t end = first;
    while (end < program.outputs.size() &&
           IsRowOfSame(program, program.outputs[first], program.outputs[end]))
      ++end;
    const std::size_t rows = end - first;
    for (std::size_t i = first; rows > 1 && i < end; ++i) {
      ir::Reader& reader = program.outputs[i].reader.emplace();
      reader.is_known = false;
      reader.columns = static_cast<std::uint32_t>(rows);
      reader.element = static_cast<std::uint32_t>(i - first);
    }
    first = end > first ? end : first + 1;
  }
}

}  // namespace clipc::link
