// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/position_input.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/spelling.h"
#include "frontend/rules/build_main.h"
#include "frontend/rules/position_trial.h"
#include "ir/walk.h"

namespace clipc {
namespace {

using namespace ir;

// A variable or a part of one: the fields and elements on the way down. Vectors are not taken
// apart.
struct Place {
  static constexpr std::uint32_t kAnyElement = ~std::uint32_t{0};

  VarId var;
  std::vector<std::uint32_t> path;
};

bool Overlap(const Place& a, const Place& b) {
  if (a.var != b.var) return false;
  const std::size_t common = std::min(a.path.size(), b.path.size());
  for (std::size_t i = 0; i < common; ++i) {
    const bool is_any = a.path[i] == Place::kAnyElement || b.path[i] == Place::kAnyElement;
    if (!is_any && a.path[i] != b.path[i]) return false;
  }
  return true;
}

// The place that an assignment target names; no variable for what is none.
Place PlaceOf(const Program& program, ExprId id) {
  const auto& node = program.exprs[id].node;
  if (const auto* ref = std::get_if<VarRef>(&node)) return {ref->var, {}};
  if (const auto* swizzle = std::get_if<Swizzle>(&node)) return PlaceOf(program, swizzle->base);
  if (const auto* field = std::get_if<FieldRef>(&node)) {
    Place place = PlaceOf(program, field->base);
    place.path.push_back(field->field);
    return place;
  }
  if (const auto* index = std::get_if<Index>(&node)) {
    Place place = PlaceOf(program, index->base);
    if (program.types[program.exprs[index->base].type].kind != TypeKind::kArray) return place;
    const auto* literal = std::get_if<Literal>(&program.exprs[index->index].node);
    place.path.push_back(literal ? static_cast<std::uint32_t>(literal->bits) : Place::kAnyElement);
    return place;
  }
  return {};
}

bool Mentions(const Program& program, ExprId expr, VarId var) {
  const auto* ref = std::get_if<VarRef>(&program.exprs[expr].node);
  bool found = ref && ref->var == var;
  ForEachOperand(program, expr,
                 [&](ExprId operand) { found = found || Mentions(program, operand, var); });
  return found;
}

// Calls visit(ExprId) for every expression under `stmt`, the outer ones first.
template <typename Visit>
void ForEachExpr(const Program& program, ExprId expr, Visit& visit) {
  visit(expr);
  ForEachOperand(program, expr, [&](ExprId operand) { ForEachExpr(program, operand, visit); });
}
template <typename Visit>
void ForEachExprOf(const Program& program, StmtId stmt, Visit& visit) {
  ForEachPart(
      program, stmt, [&](ExprId expr) { ForEachExpr(program, expr, visit); },
      [&](StmtId inner) { ForEachExprOf(program, inner, visit); });
}

// What the entry function calls the value of `input`. The generated main passes an input as an
// argument, or stores it in a local and passes that.
Place InEntry(const Program& program, VarId input) {
  Place stored, found;
  const auto visit = [&](ExprId id) {
    const auto& node = program.exprs[id].node;
    if (const auto* assign = std::get_if<Assign>(&node)) {
      if (Mentions(program, assign->value, input)) stored = PlaceOf(program, assign->target);
    } else if (const auto* call = std::get_if<Call>(&node);
               call && call->function == program.entry) {
      const std::vector<VarId>& parameters = program.functions[program.entry].parameters;
      for (std::uint32_t i = 0; i < call->arguments.size; ++i) {
        const ExprId argument = program.expr_lists[call->arguments][i];
        if (Mentions(program, argument, input)) found = {parameters[i], {}};
        if (stored.var && Mentions(program, argument, stored.var))
          found = {parameters[i], stored.path};
      }
    }
  };
  ForEachExprOf(program, program.functions[program.main].body, visit);
  return found;
}

// The targets that `expr` itself writes.
std::vector<ExprId> TargetsOf(const Program& program, ExprId id) {
  const auto& node = program.exprs[id].node;
  std::vector<ExprId> targets;
  if (const auto* assign = std::get_if<Assign>(&node)) targets.push_back(assign->target);
  if (const auto* unary = std::get_if<Unary>(&node); unary && unary->op >= UnaryOp::kPreIncrement) {
    targets.push_back(unary->operand);
  }
  if (const auto* call = std::get_if<Call>(&node)) {
    const std::vector<VarId>& parameters = program.functions[call->function].parameters;
    for (std::uint32_t i = 0; i < call->arguments.size; ++i) {
      const Storage storage = program.vars[parameters[i]].storage;
      const bool writes = storage == Storage::kOut || storage == Storage::kInOut;
      if (writes) targets.push_back(program.expr_lists[call->arguments][i]);
    }
  }
  if (const auto* call = std::get_if<IntrinsicCall>(&node)) {
    for (std::uint32_t i = 0; i < call->arguments.size; ++i) {
      if (WritesArgument(call->op, i)) targets.push_back(program.expr_lists[call->arguments][i]);
    }
  }
  return targets;
}

// Where the entry function first writes that place.
std::optional<Span> FirstWrite(const Program& program, const Place& place) {
  std::optional<Span> first;
  const auto visit = [&](ExprId id) {
    for (const ExprId target : TargetsOf(program, id)) {
      if (!first && Overlap(PlaceOf(program, target), place)) first = program.exprs[target].span;
    }
  };
  ForEachExprOf(program, program.functions[program.entry].body, visit);
  return first;
}

// "; did you mean `POSITION1`?"
std::string NearInputs(const Program& program, std::string_view semantic) {
  std::vector<std::string> names;
  for (const IoVar& input : program.inputs) {
    if (input.builtin == Builtin::kNone)
      names.push_back(fmt::format("{}{}", input.semantic, input.index));
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::vector<std::string_view> near = NearNames(semantic, views);
  return near.empty() ? "" : fmt::format("; did you mean `{}`?", near.front());
}

}  // namespace

VarId CheckPositionInput(const Program& program, std::string_view semantic,
                         Diagnostics& diagnostics) {
  const SemanticName wanted = SplitSemantic(semantic);
  const auto input =
      std::find_if(program.inputs.begin(), program.inputs.end(), [&](const IoVar& io) {
        return io.builtin == Builtin::kNone && io.index == wanted.index &&
               EqualIgnoringCase(io.semantic, wanted.name);
      });
  if (input == program.inputs.end()) {
    diagnostics.Report(program.functions[program.entry].span, diag::PositionInputMissing, semantic,
                       NearInputs(program, semantic));
    return {};
  }
  const Var& var = program.vars[input->var];
  const Type& type = program.types[var.type];
  const bool is_float = type.kind == TypeKind::kVector && type.scalar == Scalar::kFloat;
  if (!is_float || type.columns < 3) {
    diagnostics.Report(var.span, diag::PositionInputType, semantic, program.types.Name(var.type));
    return {};
  }
  if (const std::optional<Span> write = FirstWrite(program, InEntry(program, input->var))) {
    diagnostics.Report(*write, diag::PositionInputChanged, semantic)
        .Note(var.span, diag::PositionInputHere, semantic);
    return {};
  }
  if (const std::string why = WhyNotTimesMatrices(program, input->var); !why.empty()) {
    diagnostics.Report(var.span, diag::PositionInputMoved, semantic, why);
  }
  return input->var;
}

}  // namespace clipc
