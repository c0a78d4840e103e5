// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/drop_idle_clip_distances.h"

#include <algorithm>
#include <cfloat>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/scalar.h"
#include "passes/outputs.h"

namespace clipc::passes {

using namespace ir;

namespace {

std::optional<std::uint32_t> LiteralIndex(const Program& program, ExprId id) {
  const auto* literal = As<Literal>(program, id);
  return literal ? std::optional(UintOf(literal->bits)) : std::nullopt;
}

// Finds the values that may be negative, infinite or not a number. Components are counted through
// vectors and arrays: element 1 of a float2[3] is components 2 and 3.
class ClipQuestion {
 public:
  explicit ClipQuestion(const Program& program) : program_(program) {}

  bool CanClip(ExprId id, std::uint32_t component) {
    const Expr& expr = program_.exprs[id];
    return std::visit(
        Overloaded{
            [&](const Literal& node) {
              const double value = NumberOf(node.bits, program_.types[expr.type].scalar);
              return !(value >= 0 && value <= FLT_MAX);
            },
            [](const Zero&) { return false; },
            [&](const Splat& node) { return CanClip(node.operand, 0); },
            [&](const Convert& node) {  // to a whole number, only a small value keeps its sign
              const bool is_float = BaseOf(program_.types[expr.type].scalar) == Scalar::kFloat;
              return !is_float || CanClip(node.operand, component);
            },
            [&](const Construct& node) { return PartCanClip(node, component); },
            [&](const Swizzle& node) { return CanClip(node.base, node.components[component]); },
            [&](const Index& node) {
              const std::optional<std::uint32_t> index = LiteralIndex(program_, node.index);
              const std::uint32_t size = SizeOf(program_.exprs[node.base].type);
              const std::uint32_t part = SizeOf(expr.type);
              const bool is_inside = index && size > 0 && *index < size / part;
              return !is_inside || CanClip(node.base, *index * part + component);
            },
            [&](const VarRef& node) { return VariableCanClip(node.var, component); },
            [](const auto&) { return true; },
        },
        expr.node);
  }

 private:
  using Component = std::pair<VarId, std::uint32_t>;

  bool PartCanClip(const Construct& node, std::uint32_t component) {
    for (const ExprId part : program_.expr_lists[node.arguments]) {
      const std::uint32_t size = SizeOf(program_.exprs[part].type);
      if (size == 0) return true;
      if (component < size) return CanClip(part, component);
      component -= size;
    }
    return true;
  }

  // A variable can clip when any value that it is ever given can. Asking about a variable again
  // adds nothing: Run() ends at the first distance that can clip.
  bool VariableCanClip(VarId var, std::uint32_t component) {
    const Var& variable = program_.vars[var];
    if (variable.storage == Storage::kConstant && variable.init)
      return CanClip(variable.init, component);
    if (variable.storage != Storage::kLocal || SizeOf(variable.type) == 0) return true;
    if (!asked_.insert({var, component}).second) return false;
    if (!has_writes_) CollectWrites();
    if (unknown_.contains(var)) return true;
    return std::ranges::any_of(writes_[{var, component}], [&](const auto& write) {
      return CanClip(write.first, write.second);
    });
  }

  // The number of components of a scalar, a vector or an array of these; 0 for any other type.
  std::uint32_t SizeOf(TypeId id) const {
    const Type& type = program_.types[id];
    if (type.kind == TypeKind::kArray) return type.count * SizeOf(type.element);
    return type.IsScalarOrVector() ? type.Components() : 0;
  }

  // The components of a variable that the path `id` names; empty if they are not known.
  std::vector<Component> ComponentsOf(ExprId id) const {
    const std::uint32_t size = SizeOf(program_.exprs[id].type);
    std::vector<Component> components;
    if (const auto* ref = As<VarRef>(program_, id)) {
      for (std::uint32_t i = 0; i < size; ++i) components.emplace_back(ref->var, i);
      return components;
    }
    const auto* index = As<Index>(program_, id);
    const auto* swizzle = As<Swizzle>(program_, id);
    const std::optional<std::uint32_t> number = index ? LiteralIndex(program_, index->index) : 0;
    if ((!index && !swizzle) || !number) return {};
    const std::vector<Component> whole = ComponentsOf(WholeOf(program_, id));
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t at = index ? *number * size + i : swizzle->components[i];
      if (at >= whole.size()) return {};
      components.push_back(whole[at]);
    }
    return components;
  }

  void CollectWrites() {
    has_writes_ = true;
    const StmtId main = program_.functions[OutputFunction(program_)].body;
    ForEachStmt(program_, main, [&](StmtId id) {
      const auto* declare = As<Declare>(program_, id);
      if (!declare || !declare->init) return;
      const std::uint32_t size = SizeOf(program_.vars[declare->var].type);
      for (std::uint32_t i = 0; i < size; ++i)
        writes_[{declare->var, i}].emplace_back(declare->init, i);
    });
    ForEachExpr(program_, main, [&](ExprId id) {
      const auto* assign = As<Assign>(program_, id);
      const std::vector<Component> components =
          assign && !assign->op ? ComponentsOf(assign->target) : std::vector<Component>{};
      for (std::uint32_t i = 0; i < components.size(); ++i)
        writes_[components[i]].emplace_back(assign->value, i);
      if (!components.empty()) return;
      ForEachWrite(program_, id, [&](ExprId target) { unknown_.insert(RootOf(program_, target)); });
    });
  }

  const Program& program_;
  std::set<Component> asked_;
  bool has_writes_ = false;
  // The values that each component is given, each an expression and a component of it.
  std::map<Component, std::vector<std::pair<ExprId, std::uint32_t>>> writes_;
  std::set<VarId> unknown_;  // variables that are written in another way
};

class DistanceDropper {
 public:
  DistanceDropper(Program& program, VarId distances) : program_(program), distances_(distances) {
    const auto body = OutputBody(program);
    body_.assign(body.begin(), body.end());
    values_.resize(program.types[program.vars[distances].type].count);
  }

  void Run() {
    if (!FindDistances()) return;
    auto count = static_cast<std::uint32_t>(values_.size());
    ClipQuestion question(program_);
    while (count > 0 && !question.CanClip(values_[count - 1], 0)) --count;
    if (count == values_.size()) return;
    std::erase_if(body_, [&](StmtId id) {
      const std::optional<std::uint32_t> index = DistanceAt(id);
      return index && *index >= count;
    });
    SetBody(program_, OutputFunction(program_), body_);
    Shorten(count);
  }

 private:
  // The index `i` if the statement is `distances[i] = value;`; otherwise none.
  std::optional<std::uint32_t> DistanceAt(StmtId id) const {
    const Assign* assign = AsAssignment(program_, id);
    const auto* index = assign ? As<Index>(program_, assign->target) : nullptr;
    const auto* base = index ? As<VarRef>(program_, index->base) : nullptr;
    return base && base->var == distances_ ? LiteralIndex(program_, index->index) : std::nullopt;
  }

  // Fills values_. Returns false unless each distance has one statement of its own in `main`.
  bool FindDistances() {
    for (const StmtId id : body_) {
      const std::optional<std::uint32_t> index = DistanceAt(id);
      if (!index) continue;
      if (*index >= values_.size() || values_[*index]) return false;
      values_[*index] = AsAssignment(program_, id)->value;
    }
    return std::ranges::count(values_, ExprId{}) == 0;
  }

  void Shorten(std::uint32_t count) {
    if (count == 0) {
      std::erase_if(program_.outputs,
                    [&](const IoVar& output) { return output.var == distances_; });
      return;
    }
    const TypeId type = program_.types.Array(program_.types.Make(Scalar::kFloat), count);
    program_.vars[distances_].type = type;
    for (const StmtId id : body_) {
      if (!DistanceAt(id)) continue;
      program_.exprs[WholeOf(program_, AsAssignment(program_, id)->target)].type = type;
    }
  }

  Program& program_;
  const VarId distances_;
  std::vector<StmtId> body_;    // of main
  std::vector<ExprId> values_;  // of the distances
};

}  // namespace

void DropIdleClipDistances(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  const VarId distances = FindOutput(program, Builtin::kClipDistance);
  if (distances) DistanceDropper(program, distances).Run();
}

}  // namespace clipc::passes
