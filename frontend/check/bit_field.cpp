// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/bit_field.h"

#include <algorithm>
#include <ranges>

#include "base/spelling.h"
#include "frontend/check/assign.h"
#include "frontend/check/element.h"
#include "frontend/check/enum_class.h"
#include "frontend/check/operator.h"
#include "frontend/check/struct.h"
#include "frontend/check/value.h"
#include "frontend/typing/constant.h"

namespace clipc::check {
namespace {

constexpr int kBits = 32;

ExprId Number(Context& context, TypeId type, std::uint32_t bits, Span span) {
  return context.At(span).Add(type, Literal{bits});
}

std::uint32_t LowBits(int width) { return width == kBits ? ~0u : (1u << width) - 1; }

// The width that is written; nullopt after an error, which was reported.
std::optional<int> WidthOf(Context& context, const ast::VarDecl& var, TypeId type) {
  const Span span = context[var.bit_width].span;
  const std::string_view name = var.name ? context[var.name] : "a bit-field without a name";
  const bool is_word = var.dimensions.empty() && (type == context.types.Make(Scalar::kInt) ||
                                                  type == context.types.Make(Scalar::kUint));
  if (!is_word) {
    context.Report(span, diag::BitFieldType, name, context.TypeName(type));
    return std::nullopt;
  }
  // DXC's "bitfields are not allowed with HLSL annotations".
  if (var.semantic.name || !var.registers.empty() || var.packoffset) {
    context.Report(var.semantic.name ? var.semantic.span : span, diag::BitFieldAnnotated, name);
    return std::nullopt;
  }
  const auto width = ConstantInteger(context, var.bit_width);
  if (!width) return std::nullopt;
  if (*width < (var.name ? 1 : 0) || *width > kBits) {
    context.Report(span, diag::BitFieldWidth, name, *width, kBits);
    return std::nullopt;
  }
  return static_cast<int>(*width);
}

// The number of fields that are those of base structs.
std::size_t InheritedFields(const Context& context, const StructInfo& info) {
  std::size_t count = 0;
  for (const TypeId base : info.bases) count += context.types.StructOf(base).fields.size();
  return count;
}

// The value of the bit-field in a number of its type.
ExprId Extract(Context& context, ExprId word, const BitField& bits, Span span) {
  Builder at = context.At(span);
  const auto shift = [&](BinaryOp op, ExprId value, int count) {
    return count == 0 ? value : at.BinaryOf(op, value, at.Int(count));
  };
  if (IsUnsigned(context[bits.type].scalar)) {
    const ExprId low = shift(BinaryOp::kShiftRight, word, bits.first);
    if (bits.first + bits.width == kBits) return low;
    return at.BinaryOf(BinaryOp::kBitAnd, low,
                       Number(context, bits.type, LowBits(bits.width), span));
  }
  const ExprId high = shift(BinaryOp::kShiftLeft, word, kBits - bits.first - bits.width);
  return shift(BinaryOp::kShiftRight, high, kBits - bits.width);
}

// The number in which the bit-field is `value` and every other bit is that of `word`.
ExprId Insert(Context& context, ExprId word, ExprId value, const BitField& bits, Span span) {
  const ExprId placed = PlaceBits(context, value, bits);
  if (bits.width == kBits) return placed;
  const ExprId others = Number(context, bits.type, ~(LowBits(bits.width) << bits.first), span);
  Builder at = context.At(span);
  return at.BinaryOf(BinaryOp::kBitOr, at.BinaryOf(BinaryOp::kBitAnd, word, others), placed);
}

ExprId Noted(Context& context, ExprId word, const BitField& bits, Span span) {
  const ExprId value = Extract(context, word, bits, span);
  context.bits.insert_or_assign(value.index, BitAccess{word, bits});
  return value;
}

}  // namespace

bool AddBitField(Context& context, const ast::VarDecl& var, TypeId structure, SymbolId symbol,
                 Field field) {
  const auto width = WidthOf(context, var, field.type);
  if (!width) return false;
  auto& fields = context[context[structure].structure].fields;
  StructInfo& info = context.structs.infos[context[structure].structure.index];
  BitField bits{var.name, static_cast<std::uint32_t>(fields.size()), field.type, 0, *width};
  const BitField* last = info.bits.empty() ? nullptr : &info.bits.back();
  if (last && last->field >= InheritedFields(context, info) && last->field + 1 == fields.size() &&
      (bits.width == 0 || last->first + last->width + bits.width <= kBits)) {
    if (last->type != bits.type && bits.width != 0) {
      context.Report(context[var.bit_width].span, diag::BitFieldsMixed,
                     context.TypeName(last->type), context.TypeName(bits.type),
                     context.TypeName(last->type));
      return false;
    }
    bits.field = last->field;
    bits.first = last->first + last->width;
    if (bits.width == 0) bits.width = kBits - bits.first;  // `uint : 0` ends the number
    if (bits.width == 0) return true;
    if (var.name) fields.back().name += fmt::format("_{}", context[var.name]);
  } else {
    if (bits.width == 0) return true;
    if (!var.name) field.name = "room";
    fields.push_back(std::move(field));
    info.fields.push_back(var.name);
  }
  context[symbol].Resolve(bits.field);
  info.bits.push_back(bits);
  return true;
}

ExprId FieldNamed(Context& context, ExprId object, TypeId owner, Name name, Span span) {
  const auto field = FindField(context, context.TypeIdOf(object), owner, name);
  if (!field) return {};
  const SymbolId member = FindMember(context, owner, name);
  const auto all = InfoOf(context, owner)->bits | std::views::reverse;
  const auto bits = std::ranges::find_if(all, [&](const BitField& candidate) {
    return candidate.name == name && candidate.field == context[member].value;
  });
  if (bits == all.end()) {
    const ExprId value = context.At(span).Field(object, *field);
    NoteValue(context, value, member);
    return value;
  }
  BitField found = *bits;
  found.field = *field;
  return ReadBits(context, object, found, span);
}

ExprId ReadBits(Context& context, ExprId object, const BitField& bits, Span span) {
  return Noted(context, context.At(span).Field(object, bits.field), bits, span);
}

ExprId PlaceBits(Context& context, ExprId value, const BitField& bits) {
  const Span span = context[value].span;
  if (const auto number = EvaluateInteger(context.program, value)) {
    const std::uint32_t low = static_cast<std::uint32_t>(*number) & LowBits(bits.width);
    return Number(context, bits.type, low << bits.first, span);
  }
  Builder at = context.At(span);
  if (bits.first + bits.width != kBits)
    value = at.BinaryOf(BinaryOp::kBitAnd, value,
                        Number(context, bits.type, LowBits(bits.width), span));
  if (bits.first != 0) value = at.BinaryOf(BinaryOp::kShiftLeft, value, at.Int(bits.first));
  return value;
}

bool IsBitField(const Context& context, ExprId value) { return context.bits.contains(value.index); }

ExprId AssignToBits(Context& context, std::optional<BinaryOp> op, ExprId bits, ExprId value,
                    Span span) {
  auto [word, field] = context.bits.at(bits.index);
  if (context.IsError(value)) return context.ErrorExpr(span);
  Exprs steps;
  const ExprId element = ElementIn(context, word);
  const Exprs stores =
      element ? ChangeElement(context, element, word, !IsPure(context.program, value), steps)
              : Exprs{};
  if (!element && !CheckTarget(context, word)) return context.ErrorExpr(span);
  word = Stabilize(context, word, steps);
  const auto read = [&] { return Clone(context.program, word); };
  if (op) {
    const ExprId old = Extract(context, read(), field, span);
    value = CombineOperands(context, *op, old, value, {span, span});
    if (context.IsError(value)) return value;
  }
  value = Implicit(context, value, field.type);
  if (context.IsError(value)) return value;
  if (!IsPure(context.program, value)) value = Hoist(context, value, steps);
  steps.push_back(context.At(span).AssignTo(word, Insert(context, read(), value, field, span)));
  const ExprId result = Noted(context, read(), field, span);
  steps.insert(steps.end(), stores.begin(), stores.end());
  return WithPrologue(context, steps, result);
}

ExprId IncrementBits(Context& context, UnaryOp op, ExprId bits, Span span) {
  const BinaryOp change = IsIncrement(op) ? BinaryOp::kAdd : BinaryOp::kSub;
  const ExprId one = context.At(span).Int(1);
  if (!IsPostfix(op)) return AssignToBits(context, change, bits, one, span);
  Exprs steps;
  Stabilize(context, context.bits.at(bits.index).word, steps);
  const ExprId old = Hoist(context, Clone(context.program, bits), steps);
  const ExprId changed = AssignToBits(context, change, bits, one, span);
  if (context.IsError(changed)) return changed;
  steps.push_back(changed);
  return WithPrologue(context, steps, old);
}

bool HoldsBits(const Context& context, TypeId type) {
  const StructInfo* info = InfoOf(context, context.types.Innermost(type));
  return info && info->holds_bits;
}

bool RefusesBits(Context& context, TypeId from, TypeId to, Span span) {
  const bool has_bits = HoldsBits(context, from) || HoldsBits(context, to);
  if (from == to || !has_bits || DerivesFrom(context, from, to)) return false;
  context.Report(span, diag::Unsupported,
                 fmt::format("a conversion between `{}` and `{}`, of which one has bit-fields,",
                             context.TypeName(from), context.TypeName(to)));
  return true;
}

}  // namespace clipc::check
