// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/out_element.h"

#include <cstddef>
#include <utility>

#include "frontend/check/element.h"
#include "frontend/check/value.h"
#include "frontend/typing/intrinsics.h"

namespace clipc::check {
namespace {

// Whether the call writes its argument `i` of `count`, and not the memory that it names.
bool WritesArgument(std::string_view name, std::size_t i, std::size_t count) {
  if (name == "GetDimensions") return i > 0 || count < 4;
  if (name.starts_with("Interlocked"))
    return i + 1 == count && i >= (name.starts_with("InterlockedCompare") ? 3u : 2u);
  return i > 0 && IsWritingIntrinsic(name);
}

}  // namespace

ExprId EvaluateNow(Context& context, ExprId argument, bool is_place, Exprs& before) {
  if (is_place) {
    FixIndices(context, argument, true, before);
    return argument;
  }
  const bool stays = StaysTheSame(context, argument) || IsConstantExpr(context, argument) ||
                     IsOrHoldsObject(context, context.TypeIdOf(argument));
  return stays ? argument : Hoist(context, argument, before);
}

OutElements TakeOutElements(Context& context, std::string_view name, Exprs& arguments) {
  OutElements taken;
  const std::size_t count = arguments.size();
  bool writes = false, acts = false;
  for (std::size_t i = 0; i < count; ++i) writes = writes || WritesArgument(name, i, count);
  if (!writes) return taken;
  for (const ExprId argument : arguments) acts = acts || !IsPure(context.program, argument);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_written = WritesArgument(name, i, count);
    const bool is_memory = i == 0 && name.starts_with("Interlocked");
    const ExprId element = is_written ? ElementIn(context, arguments[i]) : ExprId{};
    if (element) {
      const Exprs stores = ChangeElement(context, element, arguments[i], true, taken.before);
      taken.after.insert(taken.after.end(), stores.begin(), stores.end());
    } else if (acts) {
      arguments[i] = EvaluateNow(context, arguments[i], is_written || is_memory, taken.before);
    }
  }
  return taken;
}

ExprId WithOutElements(Context& context, OutElements elements, ExprId call) {
  auto& [before, after] = elements;
  if (context.IsError(call)) return call;
  if (after.empty()) return WithPrologue(context, before, call);
  const bool has_value = context.TypeOf(call).kind != TypeKind::kVoid && !context.Is<Assign>(call);
  ExprId value;
  if (has_value) {
    value = Hoist(context, call, before);
  } else {
    before.push_back(call);
    value = after.back();
    after.pop_back();
  }
  before.insert(before.end(), after.begin(), after.end());
  return WithPrologue(context, before, value);
}

}  // namespace clipc::check
