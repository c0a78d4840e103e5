// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/fold_clip_distances.h"

#include <algorithm>
#include <cfloat>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"
#include "ir/scalar.h"
#include "passes/outputs.h"

namespace clipc::passes {

using namespace ir;

namespace {

// Components are counted through vectors and arrays: element 1 of a float2[3] is components 2 and
// 3.
class Folder {
 public:
  Folder(Program& program, VarId distances) : program_(program), distances_(distances) {}

  void Run() {
    if (!FindDistances()) return;
    std::uint32_t count = static_cast<std::uint32_t>(values_.size());
    while (count > 0 && values_[count - 1] && !CanClip(values_[count - 1], 0)) --count;
    if (count == values_.size()) return;
    std::erase_if(body_, [&](StmtId id) {
      const std::optional<std::uint32_t> index = DistanceAt(id);
      return index && *index >= count;
    });
    std::get<Block>(program_.stmts[program_.functions[program_.main].body].node).body =
        program_.stmt_lists.Add(std::span<const StmtId>(body_));
    Shorten(count);
  }

 private:
  // ---- what is written

  // `distances[i] = value;`
  std::optional<std::uint32_t> DistanceAt(StmtId id) const {
    const Assign* assign = AssignmentAt(id);
    const auto* index = assign ? std::get_if<Index>(&program_.exprs[assign->target].node) : nullptr;
    const auto* base = index ? std::get_if<VarRef>(&program_.exprs[index->base].node) : nullptr;
    return base && base->var == distances_ ? LiteralIndex(index->index) : std::nullopt;
  }

  const Assign* AssignmentAt(StmtId id) const {
    const auto* evaluate = std::get_if<Evaluate>(&program_.stmts[id].node);
    const auto* assign =
        evaluate ? std::get_if<Assign>(&program_.exprs[evaluate->expr].node) : nullptr;
    return assign && !assign->op ? assign : nullptr;
  }

  std::optional<std::uint32_t> LiteralIndex(ExprId id) const {
    const auto* literal = std::get_if<Literal>(&program_.exprs[id].node);
    return literal ? std::optional(static_cast<std::uint32_t>(literal->bits)) : std::nullopt;
  }

  // Each distance has one statement of its own in `main`, or nothing is done.
  bool FindDistances() {
    const List<StmtId> list =
        std::get<Block>(program_.stmts[program_.functions[program_.main].body].node).body;
    const auto stmts = std::as_const(program_).stmt_lists[list];
    body_.assign(stmts.begin(), stmts.end());
    values_.resize(program_.types[program_.vars[distances_].type].count);
    for (const StmtId id : body_) {
      const std::optional<std::uint32_t> index = DistanceAt(id);
      if (!index) continue;
      if (*index >= values_.size() || values_[*index]) return false;
      values_[*index] = AssignmentAt(id)->value;
    }
    return std::ranges::count(values_, ExprId{}) == 0;
  }

  // ---- whether it may be negative

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
            [&](const Convert& node) {  // to a whole number, only a small one keeps its sign
              const bool is_float = BaseOf(program_.types[expr.type].scalar) == Scalar::kFloat;
              return !is_float || CanClip(node.operand, component);
            },
            [&](const Construct& node) { return PartCanClip(node, component); },
            [&](const Swizzle& node) { return CanClip(node.base, node.components[component]); },
            [&](const Index& node) {
              const std::optional<std::uint32_t> index = LiteralIndex(node.index);
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

  bool PartCanClip(const Construct& node, std::uint32_t component) {
    for (const ExprId part : std::as_const(program_).expr_lists[node.arguments]) {
      const std::uint32_t size = SizeOf(program_.exprs[part].type);
      if (size == 0) return true;
      if (component < size) return CanClip(part, component);
      component -= size;
    }
    return true;
  }

  // None of the values that it is ever given. What was asked before in the same question has its
  // answer there.
  bool VariableCanClip(VarId var, std::uint32_t component) {
    const Var& variable = program_.vars[var];
    if (variable.storage == Storage::kConstant && variable.init)
      return CanClip(variable.init, component);
    if (variable.storage != Storage::kLocal || SizeOf(variable.type) == 0) return true;
    if (!asked_.insert({var, component}).second) return false;
    if (!has_writes_) CollectWrites();
    if (unknown_.contains(var)) return true;
    const auto found = writes_.find({var, component});
    if (found == writes_.end()) return false;
    // A list of its own: answers add no writes.
    return std::ranges::any_of(
        found->second, [&](const auto& write) { return CanClip(write.first, write.second); });
  }

  // Components of a scalar, a vector or an array of these; 0: of anything else.
  std::uint32_t SizeOf(TypeId id) const {
    const Type& type = program_.types[id];
    if (type.kind == TypeKind::kArray) return type.count * SizeOf(type.element);
    return type.kind == TypeKind::kScalar || type.kind == TypeKind::kVector ? type.Components() : 0;
  }

  // ---- what local variables are given

  struct Place {
    VarId var;
    std::vector<std::uint32_t> components;
  };
  std::optional<Place> PlaceOf(ExprId id) const {
    const Expr& expr = program_.exprs[id];
    const std::uint32_t size = SizeOf(expr.type);
    Place place;
    if (const auto* ref = std::get_if<VarRef>(&expr.node)) {
      place.var = ref->var;
      for (std::uint32_t i = 0; i < size; ++i) place.components.push_back(i);
      return size > 0 ? std::optional(place) : std::nullopt;
    }
    const auto* index = std::get_if<Index>(&expr.node);
    const auto* swizzle = std::get_if<Swizzle>(&expr.node);
    if (!index && !swizzle) return std::nullopt;
    const std::optional<Place> base = PlaceOf(index ? index->base : swizzle->base);
    const std::optional<std::uint32_t> number = index ? LiteralIndex(index->index) : 0;
    if (!base || !number || size == 0) return std::nullopt;
    place.var = base->var;
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t at = index ? *number * size + i : swizzle->components[i];
      if (at >= base->components.size()) return std::nullopt;
      place.components.push_back(base->components[at]);
    }
    return place;
  }

  VarId RootOf(ExprId id) const {
    const auto& node = program_.exprs[id].node;
    if (const auto* ref = std::get_if<VarRef>(&node)) return ref->var;
    if (const auto* index = std::get_if<Index>(&node)) return RootOf(index->base);
    if (const auto* swizzle = std::get_if<Swizzle>(&node)) return RootOf(swizzle->base);
    if (const auto* field = std::get_if<FieldRef>(&node)) return RootOf(field->base);
    return {};
  }

  void CollectWrites() {
    has_writes_ = true;
    for (const StmtId id : body_) CollectWrites(id);
  }
  void CollectWrites(StmtId id) {
    const auto* declare = std::get_if<Declare>(&program_.stmts[id].node);
    if (declare && declare->init) {
      const std::uint32_t size = SizeOf(program_.vars[declare->var].type);
      for (std::uint32_t i = 0; i < size; ++i)
        writes_[{declare->var, i}].emplace_back(declare->init, i);
    }
    ForEachPart(
        program_, id, [&](ExprId expr) { CollectWrites(expr); },
        [&](StmtId part) { CollectWrites(part); });
  }
  void CollectWrites(ExprId id) {
    const auto& node = program_.exprs[id].node;
    if (const auto* assign = std::get_if<Assign>(&node)) {
      const std::optional<Place> place = assign->op ? std::nullopt : PlaceOf(assign->target);
      if (!place) unknown_.insert(RootOf(assign->target));
      for (std::uint32_t i = 0; place && i < place->components.size(); ++i) {
        writes_[{place->var, place->components[i]}].emplace_back(assign->value, i);
      }
    } else if (const auto* unary = std::get_if<Unary>(&node);
               unary && unary->op >= UnaryOp::kPreIncrement) {
      unknown_.insert(RootOf(unary->operand));
    } else if (const auto* call = std::get_if<Call>(&node)) {
      for (std::uint32_t i = 0; i < call->arguments.size; ++i) {
        const Var& parameter = program_.vars[program_.functions[call->function].parameters[i]];
        if (parameter.storage != Storage::kIn)
          unknown_.insert(RootOf(program_.expr_lists[call->arguments][i]));
      }
    } else if (const auto* intrinsic = std::get_if<IntrinsicCall>(&node)) {
      for (std::uint32_t i = 0; i < intrinsic->arguments.size; ++i) {
        if (WritesArgument(intrinsic->op, i))
          unknown_.insert(RootOf(program_.expr_lists[intrinsic->arguments][i]));
      }
    }
    ForEachOperand(program_, id, [&](ExprId operand) { CollectWrites(operand); });
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
      const Index& index = std::get<Index>(program_.exprs[AssignmentAt(id)->target].node);
      program_.exprs[index.base].type = type;
    }
  }

  Program& program_;
  const VarId distances_;
  std::vector<StmtId> body_;    // of main
  std::vector<ExprId> values_;  // of the distances
  std::set<std::pair<VarId, std::uint32_t>> asked_;
  bool has_writes_ = false;
  std::map<std::pair<VarId, std::uint32_t>, std::vector<std::pair<ExprId, std::uint32_t>>>
      writes_;               // values and their components
  std::set<VarId> unknown_;  // written in another way
};

}  // namespace

void FoldClipDistances(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  const VarId distances = FindOutput(program, Builtin::kClipDistance);
  if (distances) Folder(program, distances).Run();
}

}  // namespace clipc::passes
