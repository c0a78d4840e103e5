// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/drop_unwritten.h"

#include <algorithm>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"

namespace clipc::passes {

using namespace ir;

static bool HasDefault(Builtin builtin) {
  return builtin == Builtin::kLayer || builtin == Builtin::kViewportIndex ||
         builtin == Builtin::kShadingRate;
}

void DropUnwritten(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  const auto has_default = [](const IoVar& output) { return HasDefault(output.builtin); };
  if (std::ranges::none_of(program.outputs, has_default)) return;
  const StmtId body[] = {program.functions[OutputFunction(program)].body};
  const std::vector<bool> assigned = AssignedIn(program, body);
  std::erase_if(program.outputs, [&](const IoVar& output) {
    return has_default(output) && !assigned[output.var.index];
  });
}

}  // namespace clipc::passes
