// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/counters.h"

#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "frontend/typing/object_call.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::resolve {
namespace {

class CounterMaker {
 public:
  CounterMaker(Program& program, Diagnostics& diagnostics)
      : program_(program), diagnostics_(diagnostics) {}

  void Run() {
    std::vector<ExprId> changes;
    const auto is_change = [](const ObjectCall& call) { return IsCounter(call.op); };
    if (program_.calls_objects && MayHaveExpr<ObjectCall>(program_, is_change)) {
      ForEachLiveExpr(program_, [&](ExprId expr) {
        const auto* call = As<ObjectCall>(program_, expr);
        if (call && IsCounter(call->op)) changes.push_back(expr);
      });
    }
    for (const ExprId change : changes) Note(change);
    for (std::size_t i = 0, count = program_.resources.size(); i < count; ++i) Add(i);
    for (const ExprId change : changes) Replace(change);
  }

 private:
  // The counter of a buffer, or the counters of an array of them, and how the shader changes it.
  struct Counter {
    ObjectOp op{};
    VarId var = {};
  };

  const ObjectCall& CallAt(ExprId change) const {
    return std::get<ObjectCall>(program_.exprs[change].node);
  }
  ExprId ObjectAt(ExprId change) const {
    return OperandOf(program_, CallAt(change), OperandKind::kObject);
  }

  void Note(ExprId change) {
    const VarId buffer = RootOf(program_, ObjectAt(change));
    const ObjectOp op = CallAt(change).op;
    if (counters_.try_emplace(buffer, Counter{op}).first->second.op != op) {
      diagnostics_.Report(program_.exprs[change].span, diag::CounterBothWays,
                          program_.vars[buffer].name);
    }
  }

  // Adds the counter of a resource that has one.
  void Add(std::size_t i) {
    const Resource counted = program_.resources[i];
    const auto found = counters_.find(counted.var);
    if (found == counters_.end()) {
      if (counted.counter_binding) {
        const Var& var = program_.vars[counted.var];
        diagnostics_.Report(var.span, diag::CounterBindingUnused, var.name);
      }
      return;
    }
    const Var& var = program_.vars[counted.var];
    Var hidden = {.name = "counter_var_" + var.name,
                  .type = CounterType(var.type),
                  .storage = Storage::kResource,
                  .span = var.span};
    found->second.var = program_.vars.Add(std::move(hidden));
    Resource resource{.var = found->second.var,
                      .reg = {.letter = 'u', .space = counted.reg.space},
                      .counter_of = counted.var};
    if (counted.counter_binding) {
      const auto& own = counted.reg.descriptor;
      resource.reg.descriptor =
          Descriptor{*counted.counter_binding, own ? own->set : counted.reg.space};
    }
    program_.resources.push_back(std::move(resource));
  }

  TypeId CounterType(TypeId buffer) {
    TypeTable& types = program_.types;
    const auto [kind, element, count] =
        std::tuple(types[buffer].kind, types[buffer].element, types[buffer].count);
    return kind == TypeKind::kArray
               ? types.Array(CounterType(element), count)
               : types.Object(ObjectKind::kRWStructuredBuffer, types.Make(Scalar::kUint));
  }

  void Replace(ExprId change) {
    const ExprId object = ObjectAt(change);
    Rename(object, counters_.at(RootOf(program_, object)).var);
    const bool is_up = CallAt(change).op == ObjectOp::kIncrementCounter;
    Builder at(program_, program_.exprs[change].span);
    const ExprId before = at.ObjectCallOf(ObjectOp::kAtomicAdd, program_.exprs[change].type,
                                          {{OperandKind::kObject, object},
                                           {OperandKind::kPlace, at.Uint(0)},
                                           {OperandKind::kValue, at.Uint(is_up ? 1 : ~0u)}});
    const ExprId value = is_up ? before : at.BinaryOf(BinaryOp::kSub, before, at.Uint(1));
    program_.exprs[change].node = program_.exprs[value].node;
  }

  // Lets a path to an element of an array begin at `root`. Returns its type.
  TypeId Rename(ExprId path, VarId root) {
    TypeId type = program_.vars[root].type;
    if (const auto* index = As<Index>(program_, path)) {
      type = program_.types[Rename(index->base, root)].element;
    } else {
      program_.exprs[path].node = VarRef{root};
    }
    return program_.exprs[path].type = type;
  }

  Program& program_;
  Diagnostics& diagnostics_;
  std::map<VarId, Counter> counters_;  // by the buffer
};

}  // namespace

void MakeCounters(Program& program, Diagnostics& diagnostics) {
  CounterMaker(program, diagnostics).Run();
}

}  // namespace clipc::resolve
