// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstddef>
#include <iterator>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/typing/object_call.h"
#include "ir/access.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

// InterlockedAdd(buffer[i], value, original) and its kin, and the methods of that name of
// RWByteAddressBuffer. Direct3D has them in a vertex shader from 11.1 on.
namespace clipc::typing {
namespace {

using enum ObjectOp;

// The numbers that an atomic operation changes.
enum class Changes : std::uint8_t { kIntegers, kNumbers, kFloats };
constexpr std::string_view kChanged[] = {"an `int` or `uint`", "an `int`, `uint` or `float`",
                                         "a `float`"};

struct Atomic {
  std::string_view name;
  ObjectOp op;
  Intrinsic of_shared;       // the same of a variable that a group shares
  bool compares, must_give;  // takes a value to compare with; must return the old value
  Changes changes = Changes::kIntegers;
};
constexpr Atomic kAtomics[] = {
    {"InterlockedAdd", kAtomicAdd, Intrinsic::kInterlockedAdd, false, false},
    {"InterlockedAnd", kAtomicAnd, Intrinsic::kInterlockedAnd, false, false},
    {"InterlockedCompareExchange", kAtomicCompareExchange, Intrinsic::kInterlockedCompareExchange,
     true, true},
    {"InterlockedCompareExchangeFloatBitwise", kAtomicCompareExchange,
     Intrinsic::kInterlockedCompareExchange, true, true, Changes::kFloats},
    {"InterlockedCompareStore", kAtomicCompareExchange, Intrinsic::kInterlockedCompareExchange,
     true, false},
    {"InterlockedCompareStoreFloatBitwise", kAtomicCompareExchange,
     Intrinsic::kInterlockedCompareExchange, true, false, Changes::kFloats},
    {"InterlockedExchange", kAtomicExchange, Intrinsic::kInterlockedExchange, false, true,
     Changes::kNumbers},
    {"InterlockedExchangeFloat", kAtomicExchange, Intrinsic::kInterlockedExchange, false, true,
     Changes::kFloats},
    {"InterlockedMax", kAtomicMax, Intrinsic::kInterlockedMax, false, false},
    {"InterlockedMin", kAtomicMin, Intrinsic::kInterlockedMin, false, false},
    {"InterlockedOr", kAtomicOr, Intrinsic::kInterlockedOr, false, false},
    {"InterlockedXor", kAtomicXor, Intrinsic::kInterlockedXor, false, false},
};

// The element, or the component of one, that an atomic operation changes.
struct AtomicPlace {
  const ObjectCall* load = nullptr;  // the read of the element; null: there is no such element
  std::vector<ExprId> steps = {};    // to the component; empty: the element is a scalar
};

// Whether the first argument is a number of 32 bits that the operation changes.
bool ChangesNumber(const IntrinsicCheck& call, Changes changes) {
  const Type& type = call.ArgumentType(0);
  if (type.kind != TypeKind::kScalar || IsWide(type.scalar)) return false;
  return ir::IsInteger(type.scalar)
             ? changes != Changes::kFloats
             : type.scalar == Scalar::kFloat && changes != Changes::kIntegers;
}

// Whether the first argument is a variable that a group shares, or a part of one.
bool ChangesShared(const IntrinsicCheck& call, Changes changes) {
  const VarId root =
      ChangesNumber(call, changes) ? RootOf(call.program, call.arguments[0]) : VarId{};
  return root && call.program.vars[root].storage == ir::Storage::kShared;
}

AtomicPlace PlaceOf(const IntrinsicCheck& call, Changes changes) {
  if (!ChangesNumber(call, changes)) return {};
  ExprId element = call.arguments[0];
  while (const ExprId whole = WholeOf(call.program, element)) element = whole;
  auto steps = StepsTo(call.program, call.arguments[0], element);
  if (!steps) return {};
  const auto* load = As<ObjectCall>(call.program, element);
  if (!load) return {};
  const ExprId object = OperandOf(call.program, *load, OperandKind::kObject);
  const bool may_step = load->op == kStructuredLoad;
  if (!LoadsElement(load->op) || !IsWritable(call.TypeOf(object).object) ||
      (!steps->empty() && !may_step))
    return {};
  return {load, std::move(*steps)};
}

}  // namespace

ExprId CheckAtomic(const IntrinsicCheck& call, ExprId object) {
  const Atomic* atomic = std::begin(kAtomics);
  while (atomic->name != call.name) ++atomic;
  const bool is_bitwise = atomic->changes == Changes::kFloats;
  const std::size_t least = atomic->compares ? 3 : 2;
  const bool has_no_result = atomic->compares && !atomic->must_give;
  if (!call.HasCount(least + (atomic->must_give ? 1 : 0), least + (has_no_result ? 0 : 1)))
    return call.Error();
  TypeId type = call.program.types.Make(Scalar::kUint);
  std::vector<NamedOperand> operands;
  const bool is_shared = !object && ChangesShared(call, atomic->changes);
  if (object) {
    const auto address = call.Converted(0, type);
    if (!address) return call.Error();
    // A byte has no type: that of the value decides (atomic_imax and atomic_umax of fxc in
    // vkd3d's test_atomic_instructions, any_int32 in DXC's gen_intrin_main.txt).
    const bool compares_sizes = atomic->op == kAtomicMin || atomic->op == kAtomicMax;
    if (compares_sizes && BaseOf(call.ArgumentType(1).scalar) == Scalar::kInt)
      type = call.program.types.Make(Scalar::kInt);
    operands = {{OperandKind::kObject, object}, {OperandKind::kPlace, *address}};
  } else if (is_shared) {
    if (!call.IsTarget(0)) return call.Error();
    type = call.ArgumentTypeId(0);
  } else {
    const AtomicPlace changed = PlaceOf(call, atomic->changes);
    if (!changed.load) {
      return call.Fail(call.SpanOf(call.arguments[0]), diag::IntrinsicAtomicTarget, call.name,
                       kChanged[static_cast<std::size_t>(atomic->changes)]);
    }
    if (is_bitwise && atomic->compares && changed.load->op != kStructuredLoad)
      return call.Fail(call.name_span, diag::IntrinsicAtomic, call.name);
    for (const OperandKind kind : {OperandKind::kObject, OperandKind::kPlace})
      operands.push_back({kind, OperandOf(call.program, *changed.load, kind)});
    for (const ExprId step : changed.steps) operands.push_back({OperandKind::kStep, step});
    type = call.ArgumentTypeId(0);
  }
  // The words of a byte address buffer are those of floats.
  const bool is_word = object && is_bitwise;
  const TypeId given = is_word ? call.program.types.Make(Scalar::kFloat) : type;
  std::vector<ExprId> values = {call.arguments[0]};
  for (std::size_t i = 1; i < least; ++i) {
    auto value = call.Converted(i, given);
    if (!value) return call.Error();
    if (is_word) value = call.Make().IntrinsicOf(Intrinsic::kAsUint, type, {*value});
    values.push_back(*value);
    operands.push_back({i + 1 < least ? OperandKind::kComparand : OperandKind::kValue, *value});
  }
  const std::span<const ExprId> list = values;
  ExprId original =
      is_shared ? call.Make().Add(
                      type, ir::IntrinsicCall{atomic->of_shared, call.program.expr_lists.Add(list)})
                : call.Make().ObjectCallOf(atomic->op, type, operands);
  if (call.arguments.size() == least) return original;
  if (!call.IsTarget(least)) return call.Error();
  if (is_word) original = call.Make().IntrinsicOf(Intrinsic::kAsFloat, given, {original});
  const ExprId target = call.arguments[least];
  return call.Make().AssignTo(target, call.Convert(original, call.TypeIdOf(target)));
}

}  // namespace clipc::typing
