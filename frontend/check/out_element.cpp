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

OutElements TakeOutElements(Context& context, std::string_view name, Exprs& arguments) {
  OutElements taken;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const ExprId element = ElementIn(context, arguments[i]);
    if (!element || !WritesArgument(name, i, arguments.size())) continue;
    const Exprs stores = ChangeElement(context, element, arguments[i], true, taken.before);
    taken.after.insert(taken.after.end(), stores.begin(), stores.end());
  }
  return taken;
}

ExprId WithOutElements(Context& context, OutElements elements, ExprId call) {
  auto& [before, after] = elements;
  if (after.empty() || context.IsError(call)) return call;
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
