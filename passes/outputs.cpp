// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/outputs.h"

#include <algorithm>
#include <utility>

namespace clipc::passes {

using namespace ir;

VarId FindOutput(const Program& program, Builtin builtin) {
  const auto found = std::find_if(program.outputs.begin(), program.outputs.end(),
                                  [&](const IoVar& output) { return output.builtin == builtin; });
  return found == program.outputs.end() ? VarId{} : found->var;
}

// Behind the locations of all outputs; doubles of more than two components take two.
static std::uint32_t FreeLocation(const Program& program) {
  std::uint32_t next = 0;
  for (const IoVar& output : program.outputs) {
    if (output.builtin != Builtin::kNone) continue;
    const Type& type = program.types[program.vars[output.var].type];
    next = std::max(next, output.location + (type.scalar == Scalar::kDouble && type.Components() > 2 ? 2 : 1));
  }
  return next;
}

VarId AddOutput(Program& program, Builtin builtin, std::string name, TypeId type) {
  Var var;
  var.name = std::move(name);
  var.type = type;
  var.storage = Storage::kOutput;
  IoVar output;
  output.var = program.vars.Add(std::move(var));
  output.builtin = builtin;
  if (builtin == Builtin::kClipDistance) output.semantic = "SV_ClipDistance";
  if (builtin == Builtin::kNone) output.location = FreeLocation(program);
  program.outputs.push_back(output);
  return output.var;
}

}  // namespace clipc::passes
