// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/varying_flow.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "frontend/rules/varying_graph.h"
#include "ir/access.h"
#include "ir/evaluate.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

using Graph = VaryingGraph;

class FlowReader {
 public:
  FlowReader(const Program& program, const FlowQuestion& question)
      : program_(program),
        question_(question),
        graph_(program.vars.size() + 2 * program.functions.size()) {}

  std::vector<AskedNode> Run() {
    for (const IoVar& input : program_.inputs) {
      if (question_.differs(program_, input)) graph_.Follow(Graph::kVarying, Of(input.var));
    }
    for (const FunctionId function : program_.functions.ids()) {
      function_ = function;
      loop_ = returned_ = left_ = Graph::kUniform;
      is_once_ = false;
      Statement(program_.functions[function].body, FlowInto(function));
    }
    return Asked();
  }

 private:
  using Node = Graph::Node;
  // A node that is asked about, the flow in which it is, the loop around it, and its operands.
  struct Found {
    ExprId expr;
    Node flow, loop, value;
  };

  Node Of(VarId var) const { return 2 + var.index; }
  Node ResultOf(FunctionId function) const {
    return 2 + static_cast<Node>(program_.vars.size()) + 2 * function.index;
  }
  Node FlowInto(FunctionId function) const { return ResultOf(function) + 1; }

  // ---- statements

  void List(clipc::List<StmtId> list, Node flow) {
    for (const StmtId id : program_.stmt_lists[list]) Statement(id, flow);
  }

  void Statement(StmtId id, Node flow) {
    if (!id) return;
    Visit(Overloaded{
              [&](const Block& node) { List(node.body, flow); },
              [&](const Declare& node) {
                // Only invocations that are here see the variable.
                if (node.init) graph_.Follow(Value(node.init, flow), Of(node.var));
              },
              [&](const Evaluate& node) { Value(node.expr, flow); },
              [&](const If& node) {
                const Node inside = graph_.Join(flow, Value(node.condition, flow));
                Statement(node.then, inside);
                Statement(node.otherwise, inside);
              },
              [&](const Switch& node) {
                const Node inside = graph_.Join(flow, Value(node.value, flow));
                const bool outer = std::exchange(is_once_, false);  // its breaks leave the switch
                for (const SwitchCase& arm : program_.switch_cases[node.cases])
                  List(arm.body, inside);
                is_once_ = outer;
              },
              [&](const For& node) {
                List(node.init, flow);
                Loop(node.condition, node.step, node.body, flow);
              },
              [&](const While& node) { Loop(node.condition, {}, node.body, flow); },
              [&](const DoWhile& node) {
                if (IsFalse(node.condition))
                  Once(node.body, flow);
                else
                  Loop(node.condition, {}, node.body, flow);
              },
              [&](const Return& node) { Returned(node.value, flow); },
              [&](const OneOf<Break, Continue> auto&) {
                if (is_once_)
                  left_ = graph_.Join(left_, Flow(flow));
                else
                  graph_.Follow(Flow(flow), loop_);
              },
              [](const Discard&) {},
          },
          program_.stmts[id].node);
  }

  // A break, a continue or a return in the loop makes its further iterations follow from it.
  void Loop(ExprId condition, ExprId step, StmtId body, Node flow) {
    const Node inside = graph_.Add(), outer = std::exchange(loop_, inside);
    const bool was_once = std::exchange(is_once_, false);
    graph_.Follow(Flow(flow), inside);
    if (condition) graph_.Follow(Value(condition, inside), inside);
    Statement(body, inside);
    if (step) Value(step, inside);
    loop_ = outer;
    is_once_ = was_once;
  }

  bool IsFalse(ExprId condition) const {
    const auto value = ConstantBits(program_, condition);
    return value && value->front() == 0;
  }

  // `do { ... } while (false);`, which SPIRV-Cross writes, has no further iterations: a break makes
  // only what comes after it in the body follow from it.
  void Once(StmtId body, Node flow) {
    const bool was_once = std::exchange(is_once_, true);
    const Node left = left_;
    Statement(body, flow);
    left_ = left;
    is_once_ = was_once;
  }

  void Returned(ExprId value, Node flow) {
    if (value) graph_.Follow(Value(value, flow), ResultOf(function_));
    // Where this is the only way out, all that called the function come along it.
    if (Flow(flow) != FlowInto(function_)) graph_.Follow(Flow(flow), ResultOf(function_));
    graph_.Follow(Flow(flow), loop_);
    returned_ = graph_.Join(returned_, flow);
  }

  // The flow at a place in `flow`: invocations that have returned, or left a loop that runs once,
  // are not there.
  Node Flow(Node flow) { return graph_.Join(graph_.Join(flow, returned_), left_); }

  void Assigned(VarId var, Node value, Node flow) {
    if (program_.vars[var].storage == Storage::kShared) return;
    graph_.Follow(value, Of(var));
    graph_.Follow(Flow(flow), Of(var));
  }

  // ---- expressions

  // The node that the value of the expression follows from.
  Node Value(ExprId id, Node flow) {
    if (const auto* ref = As<VarRef>(program_, id)) return Of(ref->var);
    if (const auto* call = As<Call>(program_, id)) return CallOf(*call, flow);
    if (const auto* choice = As<Conditional>(program_, id)) return ChoiceOf(*choice, flow);
    Node value = Graph::kUniform;
    ForEachOperand(program_, id,
                   [&](ExprId operand) { value = graph_.Join(value, Value(operand, flow)); });
    if (As<ObjectCall>(program_, id) || As<IntrinsicCall>(program_, id)) {
      if (question_.may_give_several(program_, id)) value = Graph::kVarying;
      if (question_.is_asked(program_, id)) found_.push_back({id, Flow(flow), loop_, value});
    }
    ForEachWrite(program_, id, [&](ExprId target) {
      if (const VarId root = RootOf(program_, target)) Assigned(root, value, flow);
    });
    return value;
  }

  // From 6.0 on a `?:` is a branch; before, what asks neighbours is computed before the choice.
  Node ChoiceOf(const Conditional& choice, Node flow) {
    const Node condition = Value(choice.condition, flow);
    const Node inside = graph_.Join(flow, condition);
    const Node sides =
        graph_.Join(Value(choice.when_true, inside), Value(choice.when_false, inside));
    return graph_.Join(condition, sides);
  }

  Node CallOf(const Call& call, Node flow) {
    const Function& function = program_.functions[call.function];
    graph_.Follow(Flow(flow), FlowInto(call.function));
    for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
      const ExprId argument = program_.expr_lists[call.arguments][i];
      const VarId parameter = function.parameters[i];
      graph_.Follow(Value(argument, flow), Of(parameter));
      if (program_.vars[parameter].storage == Storage::kIn) continue;
      if (const VarId root = RootOf(program_, argument)) Assigned(root, Of(parameter), flow);
    }
    return ResultOf(call.function);
  }

  std::vector<AskedNode> Asked() const {
    const std::vector<bool> varies = graph_.Varying();
    std::vector<AskedNode> asked;
    for (const auto& [expr, flow, loop, value] : found_)
      asked.push_back({expr, varies[flow], varies[loop], varies[value]});
    return asked;
  }

  const Program& program_;
  const FlowQuestion& question_;
  Graph graph_;
  FunctionId function_;
  Node loop_ = Graph::kUniform;      // the loop around the place
  bool is_once_ = false;             // whether that loop runs once, and is not loop_
  Node left_ = Graph::kUniform;      // of the breaks of such loops before the place
  Node returned_ = Graph::kUniform;  // of the returns of the function before the place
  std::vector<Found> found_;
};

}  // namespace

std::vector<AskedNode> FollowFlow(const Program& program, const FlowQuestion& question) {
  return FlowReader(program, question).Run();
}

}  // namespace clipc::rules
