// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception

#include "base/not_copied.h"
#include "ir/evaluate_machine.h"

namespace clipc::ir {
namespace {

// The most nested calls, which keep the evaluator's own stack bounded; no shader that a device
// takes nests calls so deeply.
constexpr int kMaxCallDepth = 1000;

// Keeps the number of the flow while a loop runs.
class Iterations : NotCopied {
 public:
  explicit Iterations(std::uint64_t& flow) : flow_(flow), outer_(flow) { Set(); }
  ~Iterations() { flow_ = outer_; }

  void Next() { ++iteration_, Set(); }

 private:
  void Set() { flow_ = FlowIn(outer_, iteration_); }

  std::uint64_t& flow_;
  const std::uint64_t outer_;
  std::uint64_t iteration_ = 0;
};

}  // namespace

bool Machine::Step() {
  if (++steps_ <= options_.step_limit) return error_.empty() && !is_waiting_;
  error_ = "the step limit of " + std::to_string(options_.step_limit) + " is reached";
  return false;
}

bool Machine::Test(ExprId condition) { return EvalScalar(condition) != 0; }

// Calls a function whose arguments are in the parameters' memory. Leaves the result after `base`.
void Machine::CallFunction(FunctionId id, std::size_t base) {
  const Function& function = program_.functions[id];
  const std::uint32_t words = WordsOf(function.return_type);
  if (++depth_ > kMaxCallDepth && error_.empty()) error_ = "calls are nested too deeply";
  if (Step()) Exec(function.body);
  --depth_;
  // The result of a function that ends without `return` is undefined.
  if (words != 0 && stack_.size() < base + words && error_.empty()) {
    stack_.resize(base);
    PushUndefined(function.return_type);
  }
  stack_.resize(base + words, 0);
}

Machine::Flow Machine::ExecList(List<StmtId> list) {
  for (StmtId stmt : program_.stmt_lists[list]) {
    if (const Flow flow = Exec(stmt); flow != Flow::kNext) return flow;
  }
  return Flow::kNext;
}

Machine::Flow Machine::Exec(StmtId id) {
  if (!Step()) return Flow::kStop;
  return std::visit([&](const auto& node) { return Exec(node); }, program_.stmts[id].node);
}

Machine::Flow Machine::Exec(const Evaluate& node) {
  EvalAndDrop(node.expr);
  return Flow::kNext;
}

Machine::Flow Machine::Exec(const If& node) {
  if (Test(node.condition)) return Exec(node.then);
  return node.otherwise ? Exec(node.otherwise) : Flow::kNext;
}

Machine::Flow Machine::Exec(const Return& node) {
  if (node.value) Eval(node.value);
  return Flow::kReturn;
}

Machine::Flow Machine::Exec(const Declare& node) {
  if (node.init) {
    EvalInto(node.init, address_[node.var.index]);
  } else if (!program_.vars[node.var].init) {
    SetUndefined(node.var);
  }
  return Flow::kNext;
}

Machine::Flow Machine::Loop(ExprId condition, ExprId step, StmtId body) {
  Iterations iterations(flow_);
  while (!condition || Test(condition)) {
    if (!Step()) return Flow::kStop;
    const Flow flow = Exec(body);
    if (flow == Flow::kBreak) return Flow::kNext;
    if (flow == Flow::kReturn || flow == Flow::kStop) return flow;
    if (step) EvalAndDrop(step);
    iterations.Next();
  }
  return Flow::kNext;
}

Machine::Flow Machine::Exec(const For& node) {
  if (const Flow flow = ExecList(node.init); flow != Flow::kNext) return flow;
  return Loop(node.condition, node.step, node.body);
}

Machine::Flow Machine::Exec(const DoWhile& node) {
  for (Iterations iterations(flow_);; iterations.Next()) {
    if (!Step()) return Flow::kStop;
    const Flow flow = Exec(node.body);
    if (flow == Flow::kBreak) return Flow::kNext;
    if (flow == Flow::kReturn || flow == Flow::kStop) return flow;
    if (!Test(node.condition)) break;
  }
  return Flow::kNext;
}

Machine::Flow Machine::Exec(const Switch& node) {
  const Word value = EvalScalar(node.value);
  const auto cases = program_.switch_cases[node.cases];
  std::size_t start = cases.size();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].is_default) start = i;
  }
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (ExprId label : program_.expr_lists[cases[i].labels]) {
      if (std::get<Literal>(program_.exprs[label].node).bits == value) start = i;
    }
  }
  for (std::size_t i = start; i < cases.size(); ++i) {
    const Flow flow = ExecList(cases[i].body);
    if (flow == Flow::kBreak) return Flow::kNext;
    if (flow != Flow::kNext) return flow;
  }
  return Flow::kNext;
}

}  // namespace clipc::ir
