// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/check_object_indices.h"

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/rules/known_values.h"
#include "frontend/rules/varying_graph.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

using Graph = VaryingGraph;

// The array of objects that the expression is an element of, at an index that is not written as a
// number; none for every other expression.
VarId IndexedArray(const Program& program, ExprId expr) {
  const auto* index = As<Index>(program, expr);
  if (!index || As<Literal>(program, index->index)) return {};
  const VarId root = RootOf(program, index->base);
  if (!root || TypeOf(program, index->base).kind != TypeKind::kArray) return {};
  const Var& var = program.vars[root];
  if (var.storage == Storage::kResource) return root;
  ExprId whole = index->base;
  while (const auto* outer = As<Index>(program, whole)) whole = outer->base;
  const bool is_buffer = var.storage == Storage::kUniform && As<VarRef>(program, whole) &&
                         program.cbuffers[var.cbuffer].kind == CbufferKind::kConstantBuffer;
  return is_buffer ? root : VarId{};
}

bool IsMarked(const Program& program, ExprId index) {
  const auto* call = As<IntrinsicCall>(program, index);
  return call && call->op == CommonIntrinsic::kNonUniform;
}

// A reader of the program that finds which indices may differ between the invocations that run an
// expression at the same time. A region is the text that a condition decides about: what is
// assigned in one differs outside of it, where invocations meet that did not all run it.
class IndexCheck {
 public:
  IndexCheck(const Program& program, Diagnostics& diagnostics)
      : program_(program),
        diagnostics_(diagnostics),
        graph_(program.vars.size() + 2 * program.functions.size()),
        declared_(program.vars.size()) {}

  void Run() {
    for (const IoVar& input : program_.inputs) {
      if (!IsOfDraw(input.builtin)) graph_.Follow(Graph::kVarying, Of(input.var));
    }
    for (const VarId global : program_.globals) {
      if (program_.vars[global].init) graph_.Follow(Value(program_.vars[global].init), Of(global));
    }
    for (const FunctionId function : program_.functions.ids()) {
      function_ = function;
      Statement(program_.functions[function].body);
    }
    Report();
  }

 private:
  using Node = Graph::Node;
  // A loop or a `switch` around the statement.
  struct Breakable {
    bool is_loop;
    Node node;
    std::size_t depth;  // the number of regions around its body
  };

  Node Of(VarId var) const { return 2 + var.index; }
  Node ResultOf(FunctionId function) const {
    return 2 + static_cast<Node>(program_.vars.size()) + 2 * function.index;
  }
  Node FlowInto(FunctionId function) const { return ResultOf(function) + 1; }

  // Whether all invocations of a draw call have the same value.
  static bool IsOfDraw(Builtin builtin) {
    switch (builtin) {
      case Builtin::kDrawIndex:
      case Builtin::kBaseVertex:
      case Builtin::kBaseInstance:
      case Builtin::kViewId:
      case Builtin::kLaneCount:
      case Builtin::kSampleCount: return true;
      default: return false;
    }
  }

  // ---- statements

  // Reads `text` as a region that `condition` decides about.
  template <typename Text>
  void Region(Node condition, const Text& text) {
    regions_.push_back(condition);
    text();
    regions_.pop_back();
  }

  void List(clipc::List<StmtId> list) {
    for (const StmtId id : program_.stmt_lists[list]) Statement(id);
  }

  void Statement(StmtId id) {
    if (!id) return;
    Visit(
        Overloaded{
            [&](const Block& node) { List(node.body); },
            [&](const Declare& node) {
              declared_[node.var.index] = regions_.size();
              if (node.init) graph_.Follow(Value(node.init), Of(node.var));
            },
            [&](const Evaluate& node) { Value(node.expr); },
            [&](const If& node) {
              Region(Value(node.condition), [&] {
                Statement(node.then);
                Statement(node.otherwise);
              });
            },
            [&](const Switch& node) {
              const Node value = Value(node.value);
              Breakables(false, value, [&] {
                for (const SwitchCase& arm : program_.switch_cases[node.cases]) List(arm.body);
              });
            },
            [&](const For& node) {
              List(node.init);
              // The counter is the same for all that run an iteration.
              for (const StmtId stmt : program_.stmt_lists[node.init]) {
                if (const auto* declare = As<Declare>(program_, stmt))
                  declared_[declare->var.index] = regions_.size() + 1;
              }
              Loop(node.condition, node.step, node.body);
            },
            [&](const While& node) { Loop(node.condition, {}, node.body); },
            [&](const DoWhile& node) { Loop(node.condition, {}, node.body); },
            [&](const Return& node) {
              if (node.value) graph_.Follow(Value(node.value), ResultOf(function_));
              FollowRegions(ResultOf(function_), 0);
              for (const Breakable& of : breakables_) FollowRegions(of.node, of.depth);
            },
            [&](const Break&) { FollowRegions(breakables_.back().node, breakables_.back().depth); },
            [&](const Continue&) {
              for (auto of = breakables_.rbegin(); of != breakables_.rend(); ++of) {
                FollowRegions(of->node, of->depth);
                if (of->is_loop) break;
              }
            },
            [](const Discard&) {},
        },
        program_.stmts[id].node);
  }

  template <typename Text>
  void Breakables(bool is_loop, Node value, const Text& text) {
    const Node node = graph_.Add();
    graph_.Follow(value, node);
    Region(node, [&] {
      breakables_.push_back({is_loop, node, regions_.size()});
      text();
      breakables_.pop_back();
    });
  }

  void Loop(ExprId condition, ExprId step, StmtId body) {
    Breakables(true, Graph::kUniform, [&] {
      if (condition) graph_.Follow(Value(condition), breakables_.back().node);
      Statement(body);
      if (step) Value(step);
    });
  }

  // Makes the node follow from the conditions around the place, except the outermost `from`.
  void FollowRegions(Node node, std::size_t from) {
    for (std::size_t i = from; i < regions_.size(); ++i) graph_.Follow(regions_[i], node);
  }

  void Assigned(VarId var, Node value) {
    graph_.Follow(value, Of(var));
    const Storage storage = program_.vars[var].storage;
    const bool is_static = storage == Storage::kStatic || storage == Storage::kShared;
    FollowRegions(Of(var), is_static ? 0 : declared_[var.index]);
    if (is_static) graph_.Follow(FlowInto(function_), Of(var));
  }

  // ---- expressions

  // The node that the value of the expression follows from.
  Node Value(ExprId id) {
    if (const auto* ref = As<VarRef>(program_, id)) return Of(ref->var);
    if (const auto* call = As<Call>(program_, id)) return CallOf(*call);
    Node value = Graph::kUniform;
    ForEachOperand(program_, id,
                   [&](ExprId operand) { value = graph_.Join(value, Value(operand)); });
    if (const auto* object = As<ObjectCall>(program_, id); object && IsAtomic(object->op))
      value = Graph::kVarying;
    if (const auto* call = As<IntrinsicCall>(program_, id)) value = Asked(call->op, value);
    ForEachWrite(program_, id, [&](ExprId target) {
      if (const VarId root = RootOf(program_, target)) Assigned(root, value);
    });
    if (const VarId array = IndexedArray(program_, id)) {
      const ExprId index = std::get<Index>(program_.exprs[id].node).index;
      if (!IsMarked(program_, index)) indices_.push_back({index, array, Value(index)});
    }
    return value;
  }

  // What a function of the wave gives where its arguments follow from `value`.
  static Node Asked(Intrinsic op, Node value) {
    if (CategoryOf(op) != IntrinsicCategory::kWave) return value;
    const std::string_view name = NameOf(op);
    if (name.starts_with("WaveActive") || name == "WaveReadLaneFirst") return Graph::kUniform;
    return name == "WaveReadLaneAt" ? value : Graph::kVarying;
  }

  Node CallOf(const Call& call) {
    const Function& function = program_.functions[call.function];
    FollowRegions(FlowInto(call.function), 0);
    graph_.Follow(FlowInto(function_), FlowInto(call.function));
    for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
      const ExprId argument = program_.expr_lists[call.arguments][i];
      const VarId parameter = function.parameters[i];
      graph_.Follow(Value(argument), Of(parameter));
      if (program_.vars[parameter].storage == Storage::kIn) continue;
      if (const VarId root = RootOf(program_, argument)) Assigned(root, Of(parameter));
    }
    return ResultOf(call.function);
  }

  void Report() {
    const std::vector<bool> varies = graph_.Varying();
    std::set<VarId> reported;
    for (const auto& [index, array, node] : indices_) {
      const VarId written = Written(array);
      if (!varies[node] || !reported.insert(written).second) continue;
      diagnostics_.Report(program_.exprs[index].span, diag::ObjectIndexVaries,
                          program_.vars[written].name, InfoOf(program_.stage).runs);
    }
  }

  // The array that the text names: of hidden counters, the buffers that have them.
  VarId Written(VarId array) const {
    for (const ir::Resource& resource : program_.resources) {
      if (resource.var == array && resource.counter_of) return resource.counter_of;
    }
    return array;
  }

  struct Found {
    ExprId index;
    VarId array;
    Node node;
  };

  const Program& program_;
  Diagnostics& diagnostics_;
  Graph graph_;
  FunctionId function_;
  std::vector<Node> regions_;          // around the place, the outer ones first
  std::vector<std::size_t> declared_;  // by VarId: the number of regions around the declaration
  std::vector<Breakable> breakables_;
  std::vector<Found> indices_;
};

// Reports the indices that an instruction of shader model 5.0 cannot have: it names a resource by a
// number ("The index must be constant for SM5.0 and below", DXC's docs/DXIL.rst). fxc unrolls loops
// for it.
void CheckLiteral(const Program& program, const std::vector<ExprId>& elements,
                  Diagnostics& diagnostics) {
  const KnownValues known(program);
  for (const ExprId element : elements) {
    const ExprId index = std::get<Index>(program.exprs[element].node).index;
    if (known.Has(index)) continue;
    diagnostics.Report(program.exprs[index].span, diag::ObjectIndexNotLiteral,
                       program.vars[IndexedArray(program, element)].name,
                       std::string(InfoOf(program.stage).prefix) + "_5_1");
  }
}

}  // namespace

void CheckObjectIndices(const Program& program, Diagnostics& diagnostics) {
  bool has_buffers = false;
  for (const CbufferId id : program.cbuffers.ids())
    has_buffers |= program.cbuffers[id].kind == CbufferKind::kConstantBuffer;
  if (program.is_interface_only || (!program.calls_objects && !has_buffers)) return;
  const auto may_vary = [&](const Index& index) {
    if (!index.base || As<Literal>(program, index.index)) return false;
    const TypeId base = TypeIdOf(program, index.base);
    const bool has_objects = program.types[program.types.Innermost(base)].kind == TypeKind::kObject;
    return program.types[base].kind == TypeKind::kArray && (has_buffers || has_objects);
  };
  if (!MayHaveExpr<Index>(program, may_vary)) return;
  std::vector<ExprId> elements;
  ForEachLiveExpr(program, [&](ExprId expr) {
    if (IndexedArray(program, expr)) elements.push_back(expr);
  });
  if (elements.empty()) return;
  if (program.profile.IsAtLeast(5, 1)) return IndexCheck(program, diagnostics).Run();
  if (InfoOf(program.stage).orders_memory) CheckLiteral(program, elements, diagnostics);
}

}  // namespace clipc::rules
