// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstddef>
#include <iterator>
#include <string_view>
#include <vector>

#include "frontend/rules/object_call.h"
#include "ir/access.h"

// InterlockedAdd(buffer[i], value, original) and its kin, and the methods of that name of
// RWByteAddressBuffer. Direct3D has them in a vertex shader from 11.1 on.
namespace clipc::rules {
namespace {

using enum ObjectOp;

constexpr struct {
  std::string_view name;
  ObjectOp op;
  bool compares, must_give;  // takes a value to compare with; must return the old value
} kAtomics[] = {
    {"InterlockedAdd", kAtomicAdd, false, false},
    {"InterlockedAnd", kAtomicAnd, false, false},
    {"InterlockedCompareExchange", kAtomicCompareExchange, true, true},
    {"InterlockedCompareStore", kAtomicCompareExchange, true, false},
    {"InterlockedExchange", kAtomicExchange, false, true},
    {"InterlockedMax", kAtomicMax, false, false},
    {"InterlockedMin", kAtomicMin, false, false},
    {"InterlockedOr", kAtomicOr, false, false},
    {"InterlockedXor", kAtomicXor, false, false},
};

// The read of the first argument if it is an element of a writable object and one integer;
// otherwise null.
const ObjectCall* LoadedElement(const IntrinsicCheck& call) {
  const auto* load = As<ObjectCall>(call.program, call.arguments[0]);
  if (!load) return nullptr;
  const bool is_element =
      load->op == kBufferLoad || load->op == kStructuredLoad || load->op == kImageLoad;
  const ExprId object = call.program.expr_lists[load->arguments][0];
  const Type& type = call.ArgumentType(0);
  const bool is_integer =
      type.kind == TypeKind::kScalar && !IsWide(type.scalar) && ir::IsInteger(type.scalar);
  return is_element && is_integer && IsWritable(call.TypeOf(object).object) ? load : nullptr;
}

}  // namespace

ExprId CheckAtomic(const IntrinsicCheck& call, ExprId object) {
  const auto* atomic = std::begin(kAtomics);
  while (atomic->name != call.name) ++atomic;
  const std::size_t least = atomic->compares ? 3 : 2;
  const bool has_no_result = atomic->compares && !atomic->must_give;
  if (!call.HasCount(least + (atomic->must_give ? 1 : 0), least + (has_no_result ? 0 : 1)))
    return call.Error();
  TypeId type = call.program.types.Make(Scalar::kUint);
  std::vector<ExprId> arguments;
  if (object) {
    const auto address = call.Converted(0, type);
    if (!address) return call.Error();
    arguments = {object, *address};
  } else {
    const ObjectCall* load = LoadedElement(call);
    if (!load) {
      return call.Fail(call.SpanOf(call.arguments[0]), diag::IntrinsicAtomicTarget, call.name);
    }
    const auto place = call.program.expr_lists[load->arguments];
    arguments = {place[0], place[1]};
    type = call.ArgumentTypeId(0);
  }
  for (std::size_t i = 1; i < least; ++i) {
    const auto value = call.Converted(i, type);
    if (!value) return call.Error();
    arguments.push_back(*value);
  }
  const ExprId original = MakeObjectCall(call.Make(), call.program, type, atomic->op, arguments);
  if (call.arguments.size() == least) return original;
  if (!call.IsTarget(least)) return call.Error();
  const ExprId target = call.arguments[least];
  return call.Make().AssignTo(target, call.Convert(original, call.TypeIdOf(target)));
}

}  // namespace clipc::rules
