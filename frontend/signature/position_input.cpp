// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/position_input.h"

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "base/spelling.h"
#include "frontend/signature/position_trial.h"
#include "frontend/signature/semantics.h"
#include "ir/access.h"

namespace clipc::signature {
namespace {

// A variable or a part of one: the fields and elements on the way down. Vectors are not taken
// apart.
struct VarPart {
  static constexpr std::uint32_t kAnyElement = ~std::uint32_t{0};

  VarId var;
  std::vector<std::uint32_t> path;
};

bool Overlap(const VarPart& a, const VarPart& b) {
  if (a.var != b.var) return false;
  const std::size_t common = std::min(a.path.size(), b.path.size());
  for (std::size_t i = 0; i < common; ++i) {
    const bool is_any = a.path[i] == VarPart::kAnyElement || b.path[i] == VarPart::kAnyElement;
    if (!is_any && a.path[i] != b.path[i]) return false;
  }
  return true;
}

// The place that a path names; its variable is none if the expression is not a path.
VarPart PartOf(const Program& program, ExprId id) {
  const ExprId whole = WholeOf(program, id);
  if (!whole) return {RootOf(program, id), {}};
  VarPart place = PartOf(program, whole);
  if (const auto* field = As<FieldRef>(program, id)) {
    place.path.push_back(field->field);
  } else if (TypeOf(program, whole).kind == TypeKind::kArray) {
    const auto* literal = As<Literal>(program, As<Index>(program, id)->index);
    place.path.push_back(literal ? static_cast<std::uint32_t>(literal->bits)
                                 : VarPart::kAnyElement);
  }
  return place;
}

bool Mentions(const Program& program, ExprId expr, VarId var) {
  return AnyExpr(program, expr, [&](ExprId part) {
    const auto* ref = As<VarRef>(program, part);
    return ref && ref->var == var;
  });
}

// The place in the entry function that holds the value of `input`. The generated main passes an
// input as an argument, or stores it in a local and passes that.
VarPart InEntry(const Program& program, VarId input) {
  VarPart stored, found;
  ForEachExpr(program, program.functions[program.main].body, [&](ExprId id) {
    if (const auto* assign = As<Assign>(program, id)) {
      if (Mentions(program, assign->value, input)) stored = PartOf(program, assign->target);
    } else if (const auto* call = As<Call>(program, id); call && call->function == program.entry) {
      const std::vector<VarId>& parameters = program.functions[program.entry].parameters;
      for (std::uint32_t i = 0; i < call->arguments.size; ++i) {
        const ExprId argument = program.expr_lists[call->arguments][i];
        if (Mentions(program, argument, input)) found = {parameters[i], {}};
        if (stored.var && Mentions(program, argument, stored.var))
          found = {parameters[i], stored.path};
      }
    }
  });
  return found;
}

// The span where the entry function first writes `place`; nullopt if it does not.
std::optional<Span> FirstWrite(const Program& program, const VarPart& place) {
  std::optional<Span> first;
  ForEachExpr(program, program.functions[program.entry].body, [&](ExprId id) {
    ForEachWrite(program, id, [&](ExprId target) {
      if (!first && Overlap(PartOf(program, target), place)) first = program.exprs[target].span;
    });
  });
  return first;
}

// The end of a message about an unknown semantic: "; did you mean `POSITION1`?", or empty.
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
  const auto input = std::ranges::find_if(program.inputs, [&](const IoVar& io) {
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

}  // namespace clipc::signature
