// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/known_values.h"

#include <algorithm>
#include <cstddef>

#include "base/not_copied.h"
#include "base/overloaded.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::rules {
namespace {

// The limit on the conditions and loops around an assignment. An assignment under more of them is
// taken for unknown, so that the graph has only so many edges for each.
constexpr std::size_t kMaxRegions = 64;

// A reader of functions, which adds to the graph the conditions that assignments depend on. A
// region is the text that a condition decides about: the arms of an `if`, the body of a loop. Its
// node has the condition as its value.
class RegionReader {
 public:
  RegionReader(const Program& program, ValueGraph& graph)
      : program_(program), graph_(graph), declared_(program.vars.size()) {}

  void Read(FunctionId id) {
    function_ = graph_.NodeOf(id);
    Read(program_.functions[id].body);
  }

  // The nodes that are unknown, whatever their values are.
  const std::vector<std::size_t>& unknown() const { return unknown_; }

 private:
  // A loop or a `switch` around the statement.
  struct Breakable {
    bool is_loop = false;
    bool is_bounded = true;  // a loop with a condition
    std::size_t region = 0;  // the node of its own region
    std::size_t depth = 0;   // the number of regions around its body
    std::size_t skip = 0;    // the node of conditions under which its rest is skipped
    bool may_skip = false;   // whether such a condition was read
  };

  void Read(StmtId id) {
    if (!id) return;
    Visit(Overloaded{
              [&](const If& node) {
                ReadWrites(node.condition);
                const Region region(*this, node.condition);
                Read(node.then);
                Read(node.otherwise);
              },
              [&](const For& node) {
                for (const StmtId stmt : program_.stmt_lists[node.init]) Read(stmt);
                ReadLoop(node.condition, node.body, node.step);
              },
              [&](const While& node) { ReadLoop(node.condition, node.body, {}); },
              [&](const DoWhile& node) { ReadLoop(node.condition, node.body, {}); },
              [&](const Switch& node) { ReadSwitch(node); },
              [&](const Break&) { ReadBreak(); },
              [&](const Continue&) { ReadContinue(); },
              [&](const Return& node) {
                ReadWrites(node.value);
                AddRegions(function_, 0);
              },
              [&](const Declare& node) {
                declared_[node.var.index] = regions_.size();
                ReadWrites(node.init);
              },
              [&](const auto&) {
                ForEachPart(
                    program_, id, [&](ExprId expr) { ReadWrites(expr); },
                    [&](StmtId part) { Read(part); });
              },
          },
          program_.stmts[id].node);
  }

  void ReadLoop(ExprId condition, StmtId body, ExprId step) {
    const Region region(*this, condition);
    ReadWrites(condition);
    breakables_.push_back({true, bool(condition), region.node, regions_.size(), graph_.AddNode()});
    Read(body);
    breakables_.pop_back();
    ReadWrites(step);
  }

  void ReadSwitch(const Switch& node) {
    ReadWrites(node.value);
    const Region region(*this, node.value);
    breakables_.push_back({false, true, region.node, regions_.size(), graph_.AddNode()});
    for (const SwitchCase& arm : program_.switch_cases[node.cases]) {
      for (const StmtId stmt : program_.stmt_lists[arm.body]) Read(stmt);
    }
    breakables_.pop_back();
  }

  // Reads a `break`. A loop without a condition ends by its breaks, so its iterations depend on
  // them. Other loops end by their condition at the latest.
  void ReadBreak() {
    Breakable& inner = breakables_.back();
    if (!inner.is_loop) return Skip(inner);
    if (!inner.is_bounded) AddRegions(inner.region, inner.depth);
  }

  void ReadContinue() {
    const auto loop = std::ranges::find_if(breakables_.rbegin(), breakables_.rend(),
                                           [](const Breakable& of) { return of.is_loop; });
    Skip(*loop);
  }

  void Skip(Breakable& of) {
    of.may_skip = true;
    AddRegions(of.skip, of.depth);
  }

  // Makes the node depend on the regions around the statement, except the outermost `from` of them.
  void AddRegions(std::size_t node, std::size_t from) {
    if (regions_.size() > kMaxRegions) return unknown_.push_back(node);
    for (std::size_t i = from; i < regions_.size(); ++i) graph_.AddSource(node, regions_[i]);
  }

  void ReadWrites(ExprId root) {
    if (!root) return;
    ForEachExpr(program_, root, [&](ExprId part) {
      ForEachWrite(program_, part, [&](ExprId target) {
        if (const VarId var = RootOf(program_, target)) ReadWrite(var, target);
      });
    });
  }

  void ReadWrite(VarId var, ExprId target) {
    const std::size_t node = graph_.NodeOf(var);
    // The callers of a function decide whether it assigns to variables outside of it.
    if (program_.vars[var].storage == Storage::kStatic) unknown_.push_back(node);
    const std::size_t declared = declared_[var.index];
    graph_.AddValue(node, target);  // for its indices
    AddRegions(node, declared);
    if (regions_.size() > kMaxRegions) return;
    for (const Breakable& of : breakables_) {
      if (of.may_skip && declared < of.depth) graph_.AddSource(node, of.skip);
    }
  }

  struct Region : NotCopied {
    Region(RegionReader& of, ExprId condition) : reader(of), node(of.graph_.AddNode()) {
      reader.graph_.AddValue(node, condition);
      reader.regions_.push_back(node);
    }
    ~Region() { reader.regions_.pop_back(); }

    RegionReader& reader;
    std::size_t node;
  };

  const Program& program_;
  ValueGraph& graph_;
  std::size_t function_ = 0;           // the node of the function that is read
  std::vector<std::size_t> regions_;   // around the statement, the outer ones first
  std::vector<std::size_t> declared_;  // by VarId: the number of regions around the declaration
  std::vector<Breakable> breakables_;
  std::vector<std::size_t> unknown_;
};

bool IsUnknown(const Var& var, KnownValues::Kind kind) {
  switch (var.storage) {
    case Storage::kUniform: return kind == KnownValues::Kind::kConstants;
    case Storage::kResource:
    case Storage::kShared:
    case Storage::kInput:
    case Storage::kOutput: return true;
    default: return var.constant_id.has_value();
  }
}

}  // namespace

KnownValues::KnownValues(const Program& program, std::span<const VarId> unknown, Kind kind)
    : program_(program), graph_(program) {
  RegionReader regions(program, graph_);
  for (const FunctionId id : program.functions.ids()) regions.Read(id);
  unknown_.resize(graph_.size());
  for (const std::size_t node : regions.unknown()) unknown_[node] = true;
  for (const VarId id : program.vars.ids()) {
    if (IsUnknown(program.vars[id], kind)) unknown_[graph_.NodeOf(id)] = true;
  }
  for (const VarId id : unknown) unknown_[graph_.NodeOf(id)] = true;
  if (kind == Kind::kConstants) {
    for (const VarId id : program.functions[program.entry].parameters)
      unknown_[graph_.NodeOf(id)] = true;
  }
  for (const ValueGraph::Value& value : graph_.values()) {
    const auto reads = [&](ExprId part) { return As<ObjectCall>(program, part) != nullptr; };
    if (AnyExpr(program, value.expr, reads)) unknown_[value.node] = true;
  }
  graph_.SpreadToUses(unknown_);
}

bool KnownValues::Has(ExprId expr) const {
  return expr && !AnyExpr(program_, expr, [&](ExprId part) {
           if (const auto* ref = As<VarRef>(program_, part))
             return bool(unknown_[graph_.NodeOf(ref->var)]);
           if (const auto* call = As<Call>(program_, part))
             return bool(unknown_[graph_.NodeOf(call->function)]);
           return As<ObjectCall>(program_, part) != nullptr;
         });
}

}  // namespace clipc::rules
