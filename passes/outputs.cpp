// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/outputs.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "ir/access.h"

namespace clipc::passes {

using namespace ir;

bool IsPlainInput(const Program& program, VarId var) {
  const auto input = std::ranges::find(program.inputs, var, &IoVar::var);
  if (input == program.inputs.end()) return false;
  return input->builtin == Builtin::kNone || input->builtin == Builtin::kPixelPosition ||
         input->builtin == Builtin::kFrontFacing;
}

VarId FindOutput(const Program& program, Builtin builtin) {
  const auto found = std::ranges::find(program.outputs, builtin, &IoVar::builtin);
  return found == program.outputs.end() ? VarId{} : found->var;
}

// Whether the expression is a local variable or a field of one.
static bool IsLocalPath(const Program& program, ExprId id) {
  if (const auto* field = As<FieldRef>(program, id)) return IsLocalPath(program, field->base);
  const auto* ref = As<VarRef>(program, id);
  if (!ref) return false;
  const Storage storage = program.vars[ref->var].storage;
  return storage == Storage::kLocal || storage == Storage::kIn;
}

// The assignment if `id`, a statement of the function that writes outputs, is `output = value;`;
// otherwise null.
static const Assign* WriteOf(const Program& program, StmtId id, VarId output) {
  const Assign* assign = AsAssignment(program, id);
  const auto* target = assign ? As<VarRef>(program, assign->target) : nullptr;
  return target && target->var == output ? assign : nullptr;
}

ExprId LocalWrittenTo(const Program& program, VarId output) {
  ExprId found;
  int writes = 0;
  for (const StmtId id : OutputBody(program)) {
    const Assign* assign = WriteOf(program, id, output);
    if (!assign) continue;
    ++writes;
    found = assign->value;
  }
  return writes == 1 && IsLocalPath(program, found) ? found : ExprId{};
}

void RemoveWrite(Program& program, VarId output) {
  std::vector<StmtId> body;
  for (const StmtId id : OutputBody(program)) {
    if (!WriteOf(program, id, output)) body.push_back(id);
  }
  SetBody(program, OutputFunction(program), body);
}

// The first location after the locations of all outputs.
static std::uint32_t FreeLocation(const Program& program) {
  std::uint32_t next = 0;
  for (const IoVar& output : program.outputs) {
    if (output.builtin != Builtin::kNone) continue;
    const Type& type = program.types[program.vars[output.var].type];
    next = std::max(next, output.location + LocationCount(type));
  }
  return next;
}

VarId AddOutput(Program& program, Builtin builtin, std::string name, TypeId type) {
  IoVar output;
  output.var =
      program.vars.Add({.name = std::move(name), .type = type, .storage = Storage::kOutput});
  output.builtin = builtin;
  if (builtin == Builtin::kClipDistance) output.semantic = "SV_ClipDistance";
  if (builtin == Builtin::kNone) output.location = FreeLocation(program);
  return program.outputs.emplace_back(std::move(output)).var;
}

}  // namespace clipc::passes
