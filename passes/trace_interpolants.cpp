// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/trace_interpolants.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/intrinsic_list.h"
#include "ir/walk.h"

namespace clipc::passes {

using namespace ir;

namespace {

// The numbers of the fields and elements on the way from a whole to its part, the outermost first.
using Path = std::vector<std::uint32_t>;

bool BeginsWith(std::span<const std::uint32_t> path, std::span<const std::uint32_t> begin) {
  return path.size() >= begin.size() && std::ranges::equal(path.first(begin.size()), begin);
}

class Tracer {
 public:
  explicit Tracer(Program& program) : program_(program), is_input_(program.vars.size()) {
    for (const IoVar& input : program.inputs) is_input_[input.var.index] = true;
    for (const FunctionId id : program.functions.ids()) {
      const Function& function = program.functions[id];
      for (std::uint32_t i = 0; i < function.parameters.size(); ++i)
        parameters_[function.parameters[i]] = {id, i};
      ForEachStmt(program, function.body, [&](StmtId stmt) {
        const auto* declare = As<Declare>(program, stmt);
        if (declare && declare->init) writes_[declare->var].push_back({{}, declare->init});
      });
      ForEachExpr(program, function.body, [&](ExprId expr) { Note(expr); });
    }
  }

  void Run() {
    for (const ExprId call : interpolants_) {
      ExprId place = program_.expr_lists[As<IntrinsicCall>(program_, call)->arguments][0];
      if (const auto* swizzle = As<Swizzle>(program_, place)) place = swizzle->base;
      const VarId input = InputOf(place, {}, 0);
      if (input && program_.vars[input].type == program_.exprs[place].type)
        program_.exprs[place].node = VarRef{input};
    }
  }

 private:
  static constexpr int kMostSteps = 64;

  struct Parameter {
    FunctionId function;
    std::uint32_t number;
  };
  struct Write {
    Path path;
    ExprId value;  // none: not known
  };

  void Note(ExprId expr) {
    if (const auto* call = As<IntrinsicCall>(program_, expr);
        call && CategoryOf(call->op) == IntrinsicCategory::kInterpolants)
      interpolants_.push_back(expr);
    if (const auto* call = As<Call>(program_, expr))
      calls_[call->function].push_back(call->arguments);
    const auto* assign = As<Assign>(program_, expr);
    ForEachWrite(program_, expr, [&](ExprId target) {
      const VarId root = RootOf(program_, target);
      if (!root) return;
      Write write{{}, assign && !assign->op ? assign->value : ExprId{}};
      for (ExprId at = target; at; at = WholeOf(program_, at)) {
        if (As<VarRef>(program_, at)) break;
        if (const auto part = PartOf(at)) {
          write.path.insert(write.path.begin(), *part);
        } else {
          write = {{}, {}};
        }
      }
      writes_[root].push_back(std::move(write));
    });
  }

  // The number of the field, or of the element by a literal, that the expression takes.
  std::optional<std::uint32_t> PartOf(ExprId expr) const {
    if (const auto* field = As<FieldRef>(program_, expr)) return field->field;
    const auto* index = As<Index>(program_, expr);
    const auto* number = index ? As<Literal>(program_, index->index) : nullptr;
    if (number == nullptr || TypeOf(program_, index->base).kind != TypeKind::kArray) return {};
    return static_cast<std::uint32_t>(number->bits);
  }

  // The input that the part of the expression at the path is; none if it is not one.
  VarId InputOf(ExprId expr, Path path, int steps) {
    if (!expr || steps > kMostSteps) return {};
    if (const auto* ref = As<VarRef>(program_, expr)) return InputOf(ref->var, path, steps + 1);
    if (const auto part = PartOf(expr)) {
      path.insert(path.begin(), *part);
      return InputOf(WholeOf(program_, expr), std::move(path), steps + 1);
    }
    const auto* construct = As<Construct>(program_, expr);
    if (!construct || path.empty() || path.front() >= construct->arguments.size) return {};
    const TypeKind kind = TypeOf(program_, expr).kind;
    if (kind != TypeKind::kStruct && kind != TypeKind::kArray) return {};
    const ExprId part = program_.expr_lists[construct->arguments][path.front()];
    path.erase(path.begin());
    return InputOf(part, std::move(path), steps + 1);
  }

  VarId InputOf(VarId var, const Path& path, int steps) {
    if (is_input_[var.index]) return path.empty() ? var : VarId{};
    const auto [known, is_new] = known_.try_emplace({var, path});
    if (is_new) known_[{var, path}] = Find(var, path, steps);
    return known_[{var, path}];
  }

  VarId Find(VarId var, const Path& path, int steps) {
    std::vector<const Write*> writes;
    if (const auto found = writes_.find(var); found != writes_.end()) {
      for (const Write& write : found->second) {
        if (BeginsWith(path, write.path) || BeginsWith(write.path, path)) writes.push_back(&write);
      }
    }
    const auto parameter = parameters_.find(var);
    if (parameter != parameters_.end())
      return writes.empty() ? InputOf(parameter->second, path, steps) : VarId{};
    if (writes.size() != 1 || !BeginsWith(path, writes[0]->path)) return {};
    const auto rest = path.begin() + static_cast<std::ptrdiff_t>(writes[0]->path.size());
    return InputOf(writes[0]->value, Path(rest, path.end()), steps + 1);
  }

  VarId InputOf(const Parameter& parameter, const Path& path, int steps) {
    const auto calls = calls_.find(parameter.function);
    if (calls == calls_.end()) return {};
    VarId input;
    for (const List<ExprId> arguments : calls->second) {
      const VarId given =
          InputOf(program_.expr_lists[arguments][parameter.number], path, steps + 1);
      if (!given || (input && input != given)) return {};
      input = given;
    }
    return input;
  }

  Program& program_;
  std::vector<bool> is_input_;  // by VarId
  std::map<VarId, Parameter> parameters_;
  std::map<FunctionId, std::vector<List<ExprId>>> calls_;  // the arguments of each
  std::map<VarId, std::vector<Write>> writes_;
  std::map<std::pair<VarId, Path>, VarId> known_;
  std::vector<ExprId> interpolants_;
};

}  // namespace

void TraceInterpolants(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  if (!clipc::InfoOf(program.stage).draws_pixels) return;
  const auto evaluates = [](const IntrinsicCall& call) {
    return CategoryOf(call.op) == IntrinsicCategory::kInterpolants;
  };
  if (MayHaveExpr<IntrinsicCall>(program, evaluates)) Tracer(program).Run();
}

}  // namespace clipc::passes
