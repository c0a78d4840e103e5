// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/outputs.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace clipc::passes {

using namespace ir;

VarId FindOutput(const Program& program, Builtin builtin) {
  const auto found = std::find_if(program.outputs.begin(), program.outputs.end(),
                                  [&](const IoVar& output) { return output.builtin == builtin; });
  return found == program.outputs.end() ? VarId{} : found->var;
}

static bool IsLocalPath(const Program& program, ExprId id) {
  const auto& node = program.exprs[id].node;
  if (const auto* ref = std::get_if<VarRef>(&node))
    return program.vars[ref->var].storage == Storage::kLocal;
  if (const auto* field = std::get_if<FieldRef>(&node)) return IsLocalPath(program, field->base);
  return false;
}

// The `output = value;` directly in the body of main.
static const Assign* WriteOf(const Program& program, StmtId id, VarId output) {
  const auto* evaluate = std::get_if<Evaluate>(&program.stmts[id].node);
  if (!evaluate) return nullptr;
  const auto* assign = std::get_if<Assign>(&program.exprs[evaluate->expr].node);
  if (!assign || assign->op) return nullptr;
  const auto* target = std::get_if<VarRef>(&program.exprs[assign->target].node);
  return target && target->var == output ? assign : nullptr;
}

static List<StmtId> BodyOfMain(const Program& program) {
  return std::get<Block>(program.stmts[program.functions[program.main].body].node).body;
}

ExprId LocalBehind(const Program& program, VarId output) {
  ExprId found;
  int writes = 0;
  for (const StmtId id : program.stmt_lists[BodyOfMain(program)]) {
    const Assign* assign = WriteOf(program, id, output);
    if (!assign) continue;
    ++writes;
    found = assign->value;
  }
  return writes == 1 && IsLocalPath(program, found) ? found : ExprId{};
}

void RemoveWrite(Program& program, VarId output) {
  std::vector<StmtId> body;
  for (const StmtId id : std::as_const(program).stmt_lists[BodyOfMain(program)]) {
    if (!WriteOf(program, id, output)) body.push_back(id);
  }
  std::get<Block>(program.stmts[program.functions[program.main].body].node).body =
      program.stmt_lists.Add(std::span<const StmtId>(body));
}

// Behind the locations of all outputs; doubles of more than two components take two.
static std::uint32_t FreeLocation(const Program& program) {
  std::uint32_t next = 0;
  for (const IoVar& output : program.outputs) {
    if (output.builtin != Builtin::kNone) continue;
    const Type& type = program.types[program.vars[output.var].type];
    next = std::max(
        next, output.location + (type.scalar == Scalar::kDouble && type.Components() > 2 ? 2 : 1));
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
