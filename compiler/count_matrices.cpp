// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/count_matrices.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc {
namespace {

using namespace ir;

constexpr int kMostMatrices = 16;            // more is unknown
constexpr std::int64_t kMostWork = 2000000;  // nodes, and values copied
constexpr int kRounds = 4;                   // of a loop, before what still grows is unknown
constexpr int kMostCalls = 100;              // of a function by another, within each other
constexpr int kUnknown = kMostMatrices + 1;

// A number that may be unknown, the largest.
int Limited(int count) { return std::min(count, kUnknown); }

// The number of matrices that a value has been multiplied by; a matrix itself counts one. Each
// field of a struct has its own number; all elements of an array share one.
struct MatrixCount {
  int count = 0;
  std::vector<MatrixCount> fields;

  bool operator==(const MatrixCount&) const = default;
  int Most() const {
    int most = count;
    for (const MatrixCount& field : fields) most = std::max(most, field.Most());
    return most;
  }
};

void Join(MatrixCount& into, const MatrixCount& other) {
  into.count = std::max(into.count, other.count);
  // One of the two values may not have its fields yet.
  if (into.fields.size() < other.fields.size())
    into.fields.resize(other.fields.size(), MatrixCount{into.count, {}});
  for (std::size_t i = 0; i < into.fields.size(); ++i)
    Join(into.fields[i], i < other.fields.size() ? other.fields[i] : MatrixCount{other.count, {}});
}

// The values of the variables at a place of the program; none where control does not come.
struct State {
  std::vector<MatrixCount> values;  // by VarId
  bool is_reached = true;
};

void Join(State& into, const State& other) {
  if (!other.is_reached) return;
  if (!into.is_reached) {
    into = other;
    return;
  }
  for (std::size_t i = 0; i < into.values.size(); ++i) Join(into.values[i], other.values[i]);
}

// Follows the program from main, with a number in the place of every value.
class Follower {
 public:
  explicit Follower(const Program& program) : program_(program) {
    state_.values.resize(program.vars.size());
    for (const VarId id : program.vars.ids()) {
      const Var& var = program.vars[id];
      // A matrix input is put together from its registers.
      if (var.storage == Storage::kUniform || var.init) At(id) = Given(var.type);
    }
  }

  std::optional<int> Run() {
    Exits exits;
    Follow(program_.functions[program_.main].body, exits);
    for (const IoVar& output : program_.outputs) {
      if (output.builtin != Builtin::kPosition || work_ > kMostWork) continue;
      const int count = At(output.var).Most();
      if (count <= kMostMatrices) return count;
    }
    return std::nullopt;
  }

 private:
  // The states with which control leaves a loop, a switch or a function.
  struct Exits {
    State broken{{}, false}, continued{{}, false}, returned{{}, false};
    MatrixCount result;
  };

  MatrixCount& At(VarId var) { return state_.values[var.index]; }

  MatrixCount Given(TypeId type) {
    if (IsTooMuch(1)) return {};
    const TypeTable& types = program_.types;
    const TypeId innermost = types.Innermost(type);
    if (types[innermost].kind != TypeKind::kStruct)
      return {types[innermost].kind == TypeKind::kMatrix ? 1 : 0, {}};
    MatrixCount value;
    for (const Field& field : types.StructOf(innermost).fields)
      value.fields.push_back(Given(field.type));
    if (innermost != type) return {value.Most(), {}};
    return value;
  }

  bool IsTooMuch(std::size_t work) {
    work_ += static_cast<std::int64_t>(work);
    return work_ > kMostWork;
  }
  State Kept() {
    IsTooMuch(state_.values.size() / 8 + 1);
    return state_;
  }

  // ---- expressions

  MatrixCount Of(ExprId expr) {
    if (!expr || IsTooMuch(1)) return {};
    return Visit([&](const auto& node) { return OfNode(expr, node); }, program_.exprs[expr].node);
  }
  std::vector<MatrixCount> OfAll(List<ExprId> list) {
    std::vector<MatrixCount> values;
    for (const ExprId expr : program_.expr_lists[list]) values.push_back(Of(expr));
    return values;
  }
  // The largest number of the operands, for an operation that mixes them.
  int MostOf(ExprId expr) {
    int most = 0;
    ForEachOperand(program_, expr,
                   [&](ExprId operand) { most = std::max(most, Of(operand).Most()); });
    return most;
  }
  template <typename Node>
  MatrixCount OfNode(ExprId expr, const Node&) {
    return {MostOf(expr), {}};
  }
  MatrixCount OfNode(ExprId, const VarRef& node) { return At(node.var); }
  MatrixCount OfNode(ExprId, const FieldRef& node) {
    MatrixCount base = Of(node.base);
    if (node.field < base.fields.size()) return std::move(base.fields[node.field]);
    return {base.Most(), {}};
  }
  // The index does not become a part of the element.
  MatrixCount OfNode(ExprId, const Index& node) {
    Of(node.index);
    return {Of(node.base).Most(), {}};
  }
  MatrixCount OfNode(ExprId, const Binary& node) {
    const int left = Of(node.left).Most(), right = Of(node.right).Most();
    return {node.op == BinaryOp::kMul ? Limited(left + right) : std::max(left, right), {}};
  }
  MatrixCount OfNode(ExprId, const Unary& node) { return Of(node.operand); }
  MatrixCount OfNode(ExprId, const Assign& node) {
    MatrixCount value = Of(node.value);
    if (node.op) {
      const int before = Of(node.target).Most();
      value = {*node.op == BinaryOp::kMul ? Limited(value.Most() + before)
                                          : std::max(value.Most(), before),
               {}};
    }
    Write(node.target, value);
    return value;
  }
  MatrixCount OfNode(ExprId, const Conditional& node) {
    Of(node.condition);
    const State before = Kept();
    MatrixCount value = Of(node.when_true);
    State after = std::exchange(state_, before);
    Join(value, Of(node.when_false));
    Join(state_, after);
    return value;
  }
  MatrixCount OfNode(ExprId, const Select& node) {
    Of(node.condition);
    MatrixCount value = Of(node.when_true);
    Join(value, Of(node.when_false));
    return value;
  }
  MatrixCount OfNode(ExprId expr, const Construct& node) {
    const TypeKind kind = TypeOf(program_, expr).kind;
    if (kind == TypeKind::kMatrix) return {std::max(MostOf(expr), 1), {}};
    if (kind != TypeKind::kStruct) return {MostOf(expr), {}};
    return {0, OfAll(node.arguments)};
  }
  MatrixCount OfNode(ExprId, const Comma& node) {
    Of(node.first);
    return Of(node.second);
  }
  MatrixCount OfNode(ExprId expr, const IntrinsicCall& node) {
    std::vector<int> counts;
    for (const MatrixCount& value : OfAll(node.arguments)) counts.push_back(value.Most());
    const int most = counts.empty() ? 0 : *std::ranges::max_element(counts);
    ForEachWrite(program_, expr, [&](ExprId target) { Write(target, {most, {}}); });
    switch (node.op) {
      case Intrinsic::kMul: return {Limited(counts[0] + counts[1]), {}};
      case Intrinsic::kMad: return {std::max(Limited(counts[0] + counts[1]), counts[2]), {}};
      case Intrinsic::kDot: {
        const Type& type = TypeOf(program_, program_.expr_lists[node.arguments][0]);
        // One of the two may be a row of a matrix, multiplied by hand.
        if (most == 0 && type.columns == 4) return {kUnknown, {}};
        return {Limited(counts[0] + counts[1]), {}};
      }
      default: return {most, {}};
    }
  }
  // The value that a texture or buffer holds begins anew; matrices that it holds count.
  MatrixCount OfNode(ExprId expr, const ObjectCall&) {
    MostOf(expr);
    return Given(TypeIdOf(program_, expr));
  }
  MatrixCount OfNode(ExprId expr, const Call& node) {
    if (calls_ == kMostCalls) work_ = kMostWork;
    if (IsTooMuch(1)) return {};
    const Function& function = program_.functions[node.function];
    std::vector<MatrixCount> arguments = OfAll(node.arguments);
    for (std::size_t i = 0; i < function.parameters.size() && i < arguments.size(); ++i)
      At(function.parameters[i]) = std::move(arguments[i]);
    Exits exits;
    ++calls_;
    Follow(function.body, exits);
    --calls_;
    Join(state_, exits.returned);
    state_.is_reached = true;
    for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
      if (WritesOperand(program_, expr, i))
        Write(program_.expr_lists[node.arguments][i], At(function.parameters[i]));
    }
    return std::move(exits.result);
  }

  // A place that is written wholly has the value; one that is written in part has the most of both.
  void Write(ExprId target, const MatrixCount& value) {
    std::vector<std::uint32_t> path;
    bool is_whole = true;
    for (ExprId at = target; at; at = WholeOf(program_, at)) {
      if (const FieldRef* field = As<FieldRef>(program_, at)) {
        path.push_back(field->field);
      } else if (As<VarRef>(program_, at) == nullptr) {
        is_whole = false;
        path.clear();
      }
    }
    const VarId root = RootOf(program_, target);
    if (!root) return;
    MatrixCount* place = &At(root);
    for (; !path.empty(); path.pop_back()) {
      if (place->fields.size() <= path.back())
        place->fields.resize(path.back() + 1, MatrixCount{place->count, {}});
      place = &place->fields[path.back()];
    }
    if (is_whole) {
      *place = value;
    } else {
      Join(*place, MatrixCount{value.Most(), {}});
    }
  }

  // ---- statements

  void Follow(StmtId stmt, Exits& exits) {
    if (!stmt || !state_.is_reached || IsTooMuch(1)) return;
    Visit([&](const auto& node) { FollowNode(node, exits); }, program_.stmts[stmt].node);
  }
  void FollowNode(const Block& node, Exits& exits) { FollowAll(node.body, exits); }
  void FollowAll(List<StmtId> list, Exits& exits) {
    for (const StmtId stmt : program_.stmt_lists[list]) Follow(stmt, exits);
  }
  void FollowNode(const Declare& node, Exits&) { At(node.var) = Of(node.init); }
  void FollowNode(const Evaluate& node, Exits&) { Of(node.expr); }
  void FollowNode(const If& node, Exits& exits) {
    Of(node.condition);
    const State before = Kept();
    Follow(node.then, exits);
    State after = std::exchange(state_, before);
    Follow(node.otherwise, exits);
    Join(state_, after);
  }
  void FollowNode(const For& node, Exits& exits) {
    FollowAll(node.init, exits);
    FollowLoop(node.condition, node.body, node.step, exits);
  }
  void FollowNode(const While& node, Exits& exits) {
    FollowLoop(node.condition, node.body, {}, exits);
  }
  void FollowNode(const DoWhile& node, Exits& exits) {
    FollowLoop(node.condition, node.body, {}, exits);
  }
  void FollowNode(const Switch& node, Exits& exits) {
    Of(node.value);
    const State before = Kept();
    Exits inner;
    state_.is_reached = false;
    for (const SwitchCase& each : program_.switch_cases[node.cases]) {
      Join(state_, before);
      FollowAll(each.body, inner);
    }
    Join(state_, inner.broken);
    Join(state_, before);
    Join(exits.continued, inner.continued);
    Leave(inner, exits);
  }
  void FollowNode(const Return& node, Exits& exits) {
    Join(exits.result, Of(node.value));
    Leave(exits.returned);
  }
  void FollowNode(const Break&, Exits& exits) { Leave(exits.broken); }
  void FollowNode(const Continue&, Exits& exits) { Leave(exits.continued); }
  void FollowNode(const Discard&, Exits&) {}

  void Leave(State& to) {
    IsTooMuch(state_.values.size() / 8 + 1);
    Join(to, state_);
    state_.is_reached = false;
  }
  void Leave(const Exits& inner, Exits& exits) {
    Join(exits.returned, inner.returned);
    Join(exits.result, inner.result);
  }

  // The condition of a `do` is followed before the first turn too, which only adds what it writes.
  void FollowLoop(ExprId condition, StmtId body, ExprId step, Exits& exits) {
    Exits inner;
    Of(condition);
    for (int round = 0;; ++round) {
      const State before = Kept();
      Follow(body, inner);
      Join(state_, inner.continued);
      if (state_.is_reached) Of(step), Of(condition);
      Join(state_, before);
      if (state_.values == before.values || IsTooMuch(1)) break;
      if (round < kRounds) continue;
      for (std::size_t i = 0; i < state_.values.size(); ++i) {
        if (state_.values[i] != before.values[i]) state_.values[i] = {kUnknown, {}};
      }
    }
    Join(state_, inner.broken);
    Leave(inner, exits);
  }

  const Program& program_;
  State state_;
  std::int64_t work_ = 0;
  int calls_ = 0;  // the calls that are being followed
};

}  // namespace

std::optional<int> CountPositionMatrices(const ir::Program& program) {
  return Follower(program).Run();
}

}  // namespace clipc
