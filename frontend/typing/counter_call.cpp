// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <vector>

#include "frontend/typing/object_call.h"
#include "ir/access.h"

// The methods that change the counter of a structured buffer. Append and Consume are an access to
// the element that the counter names; MakeCounters makes the counter a buffer.
namespace clipc::typing {
namespace {

using enum ObjectOp;

// The change of the counter: the index of the element that was free, or that was the last.
ExprId Change(const IntrinsicCheck& call, ExprId object, ObjectOp op) {
  return call.Make().ObjectCallOf(op, call.program.types.Make(Scalar::kUint),
                                  {{OperandKind::kObject, object}});
}

// Makes the indices of the object variables where they have effects, so that it may be written
// twice. Returns the assignments to them, the first one first; none if there are none.
ExprId NameOnce(const IntrinsicCheck& call, ExprId object) {
  ExprId steps;
  for (ExprId part = object; part; part = WholeOf(call.program, part)) {
    const auto* index = As<Index>(call.program, part);
    if (!index || IsPure(call.program, index->index)) continue;
    const auto number = call.temporaries.Make(index->index);
    const ExprId named = call.Make().Ref(number.var);
    std::get<Index>(call.program.exprs[part].node).index = named;
    steps = steps ? call.Make().CommaOf(number.prologue, steps) : number.prologue;
  }
  return steps;
}

}  // namespace

ExprId CheckCounter(const IntrinsicCheck& call, ExprId object) {
  const bool appends = call.name == "Append";
  if (!call.HasCount(appends ? 1 : 0, appends ? 1 : 0)) return call.Error();
  if (call.name == "IncrementCounter") return Change(call, object, kIncrementCounter);
  if (call.name == "DecrementCounter") return Change(call, object, kDecrementCounter);
  if (!RootOf(call.program, object))
    return call.Fail(call.name_span, diag::Unsupported, "`Append` or `Consume` of a call's result");
  const ExprId step = NameOnce(call, object);
  const ExprId same = Clone(call.program, object);
  const ExprId place = Change(call, same, appends ? kIncrementCounter : kDecrementCounter);
  std::vector<NamedOperand> operands = {{OperandKind::kObject, object},
                                        {OperandKind::kPlace, place}};
  const TypeId element = ElementOf(call.program.types, call.TypeOf(object));
  TypeId result = element;
  if (appends) {
    const auto value = call.Converted(0, element);
    if (!value) return call.Error();
    operands.push_back({OperandKind::kValue, *value});
    result = call.program.types.Void();
  }
  return After(call, {&step, 1},
               call.Make().ObjectCallOf(appends ? kStore : kStructuredLoad, result, operands));
}

}  // namespace clipc::typing
