// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/count_matrices.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
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

// A product of matrices and a vertex, by its number in Products.
using ProductId = int;
constexpr ProductId kPlainVertex = 0, kNoProduct = -1;

// The products that values are, each once.
class Products {
 public:
  ProductId Named(const std::string& name) {
    const auto [found, is_new] = names_.try_emplace(name, static_cast<ProductId>(all_.size()));
    if (is_new) all_.push_back({name, kNoProduct, kNoProduct, false});
    return found->second;
  }
  // mul(left, right). A vertex is multiplied by matrices alone, so that none is nested deeper than
  // there are matrices in it.
  ProductId Of(ProductId left, ProductId right) {
    if (left == kNoProduct || right == kNoProduct) return kNoProduct;
    if (HasVertex(left) && HasVertex(right)) return kNoProduct;
    const auto [found, is_new] =
        pairs_.try_emplace({left, right}, static_cast<ProductId>(all_.size()));
    if (is_new) all_.push_back({"", left, right, HasVertex(left) || HasVertex(right)});
    return found->second;
  }
  bool HasVertex(ProductId id) const { return id != kNoProduct && At(id).has_vertex; }
  std::string TextOf(ProductId id) const {
    const Product& product = At(id);
    if (product.left == kNoProduct) return product.name;
    return "mul(" + TextOf(product.left) + ", " + TextOf(product.right) + ")";
  }

 private:
  struct Product {
    std::string name;  // where it is one thing
    ProductId left, right;
    bool has_vertex;
  };
  const Product& At(ProductId id) const { return all_[static_cast<std::size_t>(id)]; }

  std::vector<Product> all_ = {{"v", kNoProduct, kNoProduct, true}};
  std::map<std::string, ProductId> names_;
  std::map<std::pair<ProductId, ProductId>, ProductId> pairs_;
};

// The number of matrices that a value has been multiplied by, and the product that it is; a matrix
// itself counts one. Each field of a struct has its own number; all elements of an array share one.
struct MatrixCount {
  int count = 0;
  ProductId product = kPlainVertex;
  List<MatrixCount> fields = {};  // in FieldCounts; those that are not there are as the whole

  MatrixCount WithoutFields() const { return {count, product}; }
  // The value of an operation on both: what is not multiplied by a matrix leaves the product as it
  // is, as an offset does.
  static MatrixCount Mixed(const MatrixCount& a, const MatrixCount& b) {
    const ProductId product = a.count == 0             ? b.product
                              : b.count == 0           ? a.product
                              : a.product == b.product ? a.product
                                                       : kNoProduct;
    return {std::max(a.count, b.count), product};
  }
};

// A value of that number, of which no product is known.
MatrixCount Counted(int count) { return {count, count == 0 ? kPlainVertex : kNoProduct}; }

// The fields of values. They do not change, so that copies of a value share them.
class FieldCounts {
 public:
  MatrixCount Struct(const MatrixCount& whole, const std::vector<MatrixCount>& fields) {
    size_ += fields.size();
    return {whole.count, whole.product, fields_.Add(std::span(fields))};
  }
  std::size_t size() const { return size_; }
  std::span<const MatrixCount> Of(const MatrixCount& value) const { return fields_[value.fields]; }

  // All of it, as one value.
  MatrixCount Whole(const MatrixCount& value) const {
    MatrixCount whole = value.WithoutFields();
    for (const MatrixCount& field : Of(value)) whole = MatrixCount::Mixed(whole, Whole(field));
    return whole;
  }
  bool AreEqual(const MatrixCount& a, const MatrixCount& b) const {
    if (a.count != b.count || a.product != b.product || a.fields.size != b.fields.size)
      return false;
    return a.fields.begin == b.fields.begin ||
           std::ranges::equal(Of(a), Of(b),
                              [&](const auto& x, const auto& y) { return AreEqual(x, y); });
  }
  // The value of a variable that has one of the two.
  MatrixCount Joined(const MatrixCount& a, const MatrixCount& b) {
    if (AreEqual(a, b)) return a;
    const MatrixCount whole = {std::max(a.count, b.count),
                               a.product == b.product ? a.product : kNoProduct};
    std::vector<MatrixCount> fields;
    for (std::uint32_t i = 0; i < std::max(a.fields.size, b.fields.size); ++i)
      fields.push_back(Joined(FieldOf(a, i), FieldOf(b, i)));
    return fields.empty() ? whole : Struct(whole, fields);
  }
  // The value, after change(part) of the part at the end of the path, whose last field comes first.
  MatrixCount With(const MatrixCount& value, std::span<const std::uint32_t> path, auto change) {
    if (path.empty()) return change(value);
    std::vector<MatrixCount> fields(Of(value).begin(), Of(value).end());
    if (fields.size() <= path.back()) fields.resize(path.back() + 1, value.WithoutFields());
    MatrixCount& field = fields[path.back()];
    field = With(field, path.first(path.size() - 1), change);
    return Struct(value, fields);
  }

 private:
  MatrixCount FieldOf(const MatrixCount& value, std::uint32_t index) const {
    return index < value.fields.size ? Of(value)[index] : value.WithoutFields();
  }

  Pool<MatrixCount> fields_;
  std::size_t size_ = 0;  // of all lists
};

// The values of the variables at a place of the program; none where control does not come.
struct State {
  std::vector<MatrixCount> values;  // by VarId
  bool is_reached = true;
};

// Follows the program from main, with a number in the place of every value.
class Follower {
 public:
  explicit Follower(const Program& program) : program_(program) {
    state_.values.resize(program.vars.size());
    for (const VarId id : program.vars.ids()) {
      const Var& var = program.vars[id];
      // A matrix input is put together from its registers.
      if (var.storage == Storage::kUniform || var.init) At(id) = Given(var.type, var.name);
    }
  }

  PositionMatrices Run() {
    Exits exits;
    Follow(program_.functions[program_.main].body, exits);
    for (const IoVar& output : program_.outputs) {
      if (output.builtin != Builtin::kPosition || IsTooMuch(0)) continue;
      const MatrixCount position = counts_.Whole(At(output.var));
      if (position.count > kMostMatrices) break;
      if (!products_.HasVertex(position.product)) return {position.count, std::nullopt};
      return {position.count, products_.TextOf(position.product)};
    }
    return {};
  }

 private:
  // The states with which control leaves a loop, a switch or a function.
  struct Exits {
    State broken{{}, false}, continued{{}, false}, returned{{}, false};
    std::optional<MatrixCount> result;  // of the returns so far
  };

  void Join(State& into, const State& other) {
    if (!other.is_reached) return;
    if (!into.is_reached) {
      into = other;
      return;
    }
    for (std::size_t i = 0; i < into.values.size(); ++i)
      into.values[i] = counts_.Joined(into.values[i], other.values[i]);
  }
  void JoinResult(Exits& exits, const MatrixCount& value) {
    exits.result = exits.result ? counts_.Joined(*exits.result, value) : value;
  }

  MatrixCount& At(VarId var) { return state_.values[var.index]; }

  // A value of that type which the application gives.
  MatrixCount Given(TypeId type, const std::string& name) {
    if (IsTooMuch(1 + name.size() / 64)) return {};
    const TypeTable& types = program_.types;
    const TypeId innermost = types.Innermost(type);
    const TypeKind kind = types[innermost].kind;
    if (kind != TypeKind::kMatrix && kind != TypeKind::kStruct) return {};
    const std::string element = name.empty() || innermost == type ? name : name + "[]";
    if (kind == TypeKind::kMatrix) return {1, name.empty() ? kNoProduct : products_.Named(element)};
    std::vector<MatrixCount> fields;
    for (const Field& field : types.StructOf(innermost).fields)
      fields.push_back(Given(field.type, name.empty() ? "" : element + "." + field.name));
    const MatrixCount value = counts_.Struct({}, fields);
    return innermost == type ? value : counts_.Whole(value);
  }

  bool IsTooMuch(std::size_t work) {
    work_ += static_cast<std::int64_t>(work);
    return work_ + static_cast<std::int64_t>(counts_.size() / 8) > kMostWork;
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
  // The value of a variable or of a field of one, where it stands; null for all else, and for a
  // struct whose fields have no values of their own yet.
  const MatrixCount* Standing(ExprId expr) const {
    if (const auto* ref = As<VarRef>(program_, expr)) return &state_.values[ref->var.index];
    const auto* field = As<FieldRef>(program_, expr);
    const MatrixCount* base = field ? Standing(field->base) : nullptr;
    return base && field->field < base->fields.size ? &counts_.Of(*base)[field->field] : nullptr;
  }
  MatrixCount AsWhole(ExprId expr) {
    const MatrixCount* standing = expr ? Standing(expr) : nullptr;
    return counts_.Whole(standing && !IsTooMuch(1) ? *standing : Of(expr));
  }
  std::vector<MatrixCount> OfAll(List<ExprId> list) {
    std::vector<MatrixCount> values;
    for (const ExprId expr : program_.expr_lists[list]) values.push_back(Of(expr));
    return values;
  }
  // The value of an operation that mixes its operands.
  MatrixCount MixOf(ExprId expr) {
    MatrixCount mixed;
    ForEachOperand(program_, expr,
                   [&](ExprId operand) { mixed = MatrixCount::Mixed(mixed, AsWhole(operand)); });
    return mixed;
  }
  template <typename Node>
  MatrixCount OfNode(ExprId expr, const Node&) {
    return MixOf(expr);
  }
  MatrixCount OfNode(ExprId, const OneOf<Literal, Zero> auto&) { return {}; }
  // The component by component product: of a number and a position it is the position, of a number
  // and a matrix's row a part of a product by hand.
  MatrixCount Times(const MatrixCount& left, const MatrixCount& right) {
    const int count = Limited(left.count + right.count);
    if (left.count == 0 && products_.HasVertex(right.product)) return right;
    if (right.count == 0 && products_.HasVertex(left.product)) return left;
    return Counted(count);
  }
  MatrixCount Combined(BinaryOp op, const MatrixCount& left, const MatrixCount& right) {
    return op == BinaryOp::kMul ? Times(left, right) : MatrixCount::Mixed(left, right);
  }
  MatrixCount OfNode(ExprId, const VarRef& node) { return At(node.var); }
  MatrixCount OfNode(ExprId expr, const FieldRef& node) {
    if (const MatrixCount* standing = Standing(expr)) return *standing;
    const MatrixCount base = Of(node.base);
    return node.field < base.fields.size ? counts_.Of(base)[node.field] : counts_.Whole(base);
  }
  // The index does not become a part of the element.
  MatrixCount OfNode(ExprId, const Index& node) {
    Of(node.index);
    return AsWhole(node.base);
  }
  MatrixCount OfNode(ExprId, const Binary& node) {
    const MatrixCount left = AsWhole(node.left);
    return Combined(node.op, left, AsWhole(node.right));
  }
  MatrixCount OfNode(ExprId, const Unary& node) { return Of(node.operand); }
  MatrixCount OfNode(ExprId, const Assign& node) {
    MatrixCount value = Of(node.value);
    if (node.op) {
      value = Combined(*node.op, AsWhole(node.target), counts_.Whole(value));
    }
    Write(node.target, value);
    return value;
  }
  MatrixCount OfNode(ExprId, const Conditional& node) {
    Of(node.condition);
    const State before = Kept();
    const MatrixCount value = Of(node.when_true);
    State after = std::exchange(state_, before);
    const MatrixCount joined = counts_.Joined(value, Of(node.when_false));
    Join(state_, after);
    return joined;
  }
  MatrixCount OfNode(ExprId, const Select& node) {
    Of(node.condition);
    const MatrixCount value = Of(node.when_true);
    return counts_.Joined(value, Of(node.when_false));
  }
  MatrixCount OfNode(ExprId expr, const Construct& node) {
    const TypeKind kind = TypeOf(program_, expr).kind;
    if (kind == TypeKind::kStruct) return counts_.Struct({}, OfAll(node.arguments));
    const MatrixCount mixed = MixOf(expr);
    return kind == TypeKind::kMatrix && mixed.count == 0 ? Counted(1) : mixed;
  }
  MatrixCount OfNode(ExprId, const Comma& node) {
    Of(node.first);
    return Of(node.second);
  }
  MatrixCount OfNode(ExprId expr, const IntrinsicCall& node) {
    MatrixCount mixed;
    std::array<MatrixCount, IntrinsicSignature::kMaxArguments> values;
    for (std::uint32_t i = 0; i < node.arguments.size; ++i) {
      values[i] = AsWhole(program_.expr_lists[node.arguments][i]);
      mixed = MatrixCount::Mixed(mixed, values[i]);
    }
    ForEachWrite(program_, expr, [&](ExprId target) { Write(target, mixed); });
    if (node.op == CommonIntrinsic::kMul) {
      const int count = Limited(values[0].count + values[1].count);
      if (count == 0) return {};
      if (count > kMostMatrices) return Counted(count);
      return {count, products_.Of(values[0].product, values[1].product)};
    }
    if (node.op == CommonIntrinsic::kMad)
      return MatrixCount::Mixed(Times(values[0], values[1]), values[2]);
    if (node.op == CommonIntrinsic::kDot) {
      const Type& type = TypeOf(program_, program_.expr_lists[node.arguments][0]);
      // One of the two may be a row of a matrix, multiplied by hand.
      if (mixed.count == 0 && type.columns == 4) return Counted(kUnknown);
      return Counted(Limited(values[0].count + values[1].count));
    }
    return mixed;
  }
  // The value that a texture or buffer holds begins anew; matrices that it holds count.
  MatrixCount OfNode(ExprId expr, const ObjectCall&) {
    MixOf(expr);
    return Given(TypeIdOf(program_, expr), "");
  }
  MatrixCount OfNode(ExprId expr, const Call& node) {
    if (calls_ == kMostCalls) work_ = kMostWork;
    if (IsTooMuch(1)) return {};
    const Function& function = program_.functions[node.function];
    const std::vector<MatrixCount> arguments = OfAll(node.arguments);
    for (std::size_t i = 0; i < function.parameters.size() && i < arguments.size(); ++i)
      At(function.parameters[i]) = arguments[i];
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
    return exits.result.value_or(MatrixCount{});
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
    MatrixCount& place = At(root);
    place = counts_.With(place, path, [&](const MatrixCount& part) {
      return is_whole ? value : MatrixCount::Mixed(counts_.Whole(part), counts_.Whole(value));
    });
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
    JoinResult(exits, Of(node.value));
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
    if (inner.result) JoinResult(exits, *inner.result);
  }

  // The condition of a `do` is followed before the first iteration too, which only adds what it
  // writes.
  void FollowLoop(ExprId condition, StmtId body, ExprId step, Exits& exits) {
    Exits inner;
    Of(condition);
    for (int round = 0;; ++round) {
      const State before = Kept();
      Follow(body, inner);
      Join(state_, inner.continued);
      if (state_.is_reached) Of(step), Of(condition);
      Join(state_, before);
      bool is_settled = true;
      for (std::size_t i = 0; i < state_.values.size(); ++i) {
        if (counts_.AreEqual(state_.values[i], before.values[i])) continue;
        is_settled = false;
        if (round >= kRounds) state_.values[i] = Counted(kUnknown);
      }
      if (is_settled || IsTooMuch(1)) break;
    }
    Join(state_, inner.broken);
    Leave(inner, exits);
  }

  const Program& program_;
  Products products_;
  FieldCounts counts_;
  State state_;
  std::int64_t work_ = 0;
  int calls_ = 0;  // the calls that are being followed
};

}  // namespace

PositionMatrices FollowPosition(const ir::Program& program) { return Follower(program).Run(); }

}  // namespace clipc
