// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/byte_access.h"

#include <algorithm>
#include <initializer_list>
#include <span>
#include <utility>

#include "frontend/check/type.h"
#include "frontend/check/type_names.h"
#include "frontend/check/value.h"
#include "frontend/typing/intrinsics.h"
#include "frontend/typing/objects.h"
#include "ir/packing.h"

namespace clipc::check {
namespace {

bool IsMadeOfWords(Scalar scalar) {
  const Scalar base = BaseOf(scalar);
  return IsWide(scalar) || base == Scalar::kFloat || base == Scalar::kInt ||
         base == Scalar::kUint || base == Scalar::kBool;
}

// Whether a value of the type consists of words of 32 bits alone, or of pairs of them.
bool ConsistsOfWords(const Context& context, TypeId id) {
  const Type& type = context[id];
  if (type.kind == TypeKind::kArray)
    return type.count != 0 && ConsistsOfWords(context, type.element);
  if (type.kind != TypeKind::kStruct) return type.IsNumeric() && IsMadeOfWords(type.scalar);
  const std::vector<Field>& fields = context.types.StructOf(id).fields;
  return !fields.empty() && std::ranges::all_of(fields, [&](const Field& field) {
    return ConsistsOfWords(context, field.type);
  });
}

bool HoldsRowMajorMatrix(const Context& context, TypeId id, bool row_major) {
  const Type& type = context[id];
  if (type.kind == TypeKind::kArray) return HoldsRowMajorMatrix(context, type.element, row_major);
  if (type.kind != TypeKind::kStruct) return type.kind == TypeKind::kMatrix && row_major;
  return std::ranges::any_of(context.types.StructOf(id).fields, [&](const Field& field) {
    return HoldsRowMajorMatrix(context, field.type, field.row_major);
  });
}

// One call of Load or Store for a value of `type`, as loads and stores of words.
class Access {
 public:
  Access(Context& context, const UseSpans& spans, ExprId object, ExprId address, TypeId type)
      : context_(context),
        method_span_(spans.name),
        object_(object),
        type_(type),
        span_(spans.whole),
        is_single_(!IsWide(context[type].scalar) && context[type].IsScalarOrVector()) {
    HoldIndex();
    address = Implicit(context, address, context.types.Make(Scalar::kUint));
    if (const auto* literal = context.GetIf<Literal>(address)) {
      start_ = static_cast<std::uint32_t>(literal->bits);
    } else {
      address_ = Held(address);
    }
  }

  ExprId Load() { return WithPrologue(context_, prologue_, Value(type_)); }

  ExprId Store(ExprId value) {
    StoreParts(Held(value));
    const ExprId last = stores_.back();
    stores_.pop_back();
    prologue_.insert(prologue_.end(), stores_.begin(), stores_.end());
    return WithPrologue(context_, prologue_, last);
  }

 private:
  // The value itself if it is used once, otherwise an expression that may be cloned.
  ExprId Held(ExprId value) { return is_single_ ? value : Repeatable(context_, value, prologue_); }
  ExprId CopyOf(ExprId held) { return is_single_ ? held : Clone(context_.program, held); }

  // Holds the index into an array of buffers in a temporary if evaluating it has effects.
  void HoldIndex() {
    auto* index = std::get_if<Index>(&context_[object_].node);
    if (!index || is_single_ || IsPure(context_.program, object_)) return;
    const ExprId held = Hoist(context_, index->index, prologue_);
    std::get<Index>(context_[object_].node).index = held;
  }

  // The address of the next word.
  ExprId Address() {
    Builder at = context_.At(span_);
    if (!address_) return at.Uint(start_ + next_);
    const ExprId start = CopyOf(address_);
    return next_ == 0 ? start : at.BinaryOf(BinaryOp::kAdd, start, at.Uint(next_));
  }

  ExprId CallMethod(std::string_view name, std::span<const ExprId> arguments) {
    return CheckMethodCall(
        {context_.program, name, method_span_, arguments, span_, context_, context_.diagnostics},
        CopyOf(object_));
  }
  ExprId CallIntrinsic(std::string_view name, std::initializer_list<ExprId> arguments) {
    return CheckIntrinsicCall({context_.program, name, method_span_,
                               std::span(arguments.begin(), arguments.size()), span_, context_,
                               context_.diagnostics});
  }

  ExprId Word() {
    const ExprId arguments[] = {Address()};
    next_ += 4;
    return CallMethod("Load", arguments);
  }

  // The scalar or vector of 64 bits a component that lies at the next words, the low one first.
  ExprId Pairs(TypeId id) {
    const Type type = context_[id];
    Exprs components;
    for (int i = 0; i < type.columns; ++i) {
      const ExprId low = Word(), high = Word();
      if (context_.IsError(low, high)) return low;
      if (type.scalar == Scalar::kDouble) {
        components.push_back(CallIntrinsic("asdouble", {low, high}));
        continue;
      }
      Builder at = context_.At(span_);
      const ExprId upper = at.BinaryOf(BinaryOp::kShiftLeft, at.ConvertTo(Scalar::kUint64, high),
                                       at.Add(context_.types.Make(Scalar::kUint64), Literal{32}));
      const ExprId whole = at.BinaryOf(BinaryOp::kBitOr, at.ConvertTo(Scalar::kUint64, low), upper);
      components.push_back(at.ConvertTo(type.scalar, whole));
    }
    return type.kind == TypeKind::kScalar ? components[0]
                                          : context_.At(span_).ConstructOf(id, components);
  }

  // The scalar or vector that lies at the next words.
  ExprId Words(TypeId id) {
    constexpr std::string_view kMethods[] = {"Load", "Load2", "Load3", "Load4"};
    const Type type = context_[id];
    if (IsWide(type.scalar)) return Pairs(id);
    const ExprId arguments[] = {Address()};
    const ExprId words = CallMethod(kMethods[type.columns - 1], arguments);
    next_ += 4 * type.columns;
    if (context_.IsError(words)) return words;
    switch (BaseOf(type.scalar)) {
      case Scalar::kFloat: return ConvertSilently(context_, CallIntrinsic("asfloat", {words}), id);
      case Scalar::kInt: return ConvertSilently(context_, CallIntrinsic("asint", {words}), id);
      default: return ConvertSilently(context_, words, id);
    }
  }

  // Goes on to the next multiple of the size of the type's widest number: dxc pads structs to it,
  // as a structured buffer does (RawBufferMethods.cpp of its SPIR-V back end, "natural" layout).
  void Align(TypeId id) {
    next_ = static_cast<std::uint32_t>(
        ir::RoundUp(next_, ir::Structured(context_.types, id).alignment));
  }

  // The value that lies at the next words.
  ExprId Value(TypeId id) {
    const Type type = context_[id];
    Align(id);
    if (type.kind == TypeKind::kScalar || type.kind == TypeKind::kVector) return Words(id);
    Exprs parts;
    if (type.kind == TypeKind::kMatrix) {
      const bool by_row = context_.options.byte_matrices_by_row;
      const TypeId part = VectorOf(type.scalar, by_row ? type.columns : type.rows);
      for (std::uint32_t i = 0; i < (by_row ? type.rows : type.columns); ++i)
        parts.push_back(Words(part));
      if (context_.IsError(parts[0])) return parts[0];
      if (by_row) return context_.At(span_).ConstructOf(id, parts);
      const TypeId transposed = context_.types.Matrix(type.scalar, type.columns, type.rows);
      return CallIntrinsic("transpose", {context_.At(span_).ConstructOf(transposed, parts)});
    }
    const std::uint32_t count = context_.types.PartCount(id);
    for (std::uint32_t i = 0; i < count; ++i) {
      parts.push_back(Value(context_.types.PartType(id, i)));
      if (context_.IsError(parts.back())) return parts.back();
    }
    Align(id);
    return context_.At(span_).ConstructOf(id, parts);
  }

  void StoreWord(ExprId word) {
    const ExprId arguments[] = {Address(), word};
    stores_.push_back(CallMethod("Store", arguments));
    next_ += 4;
  }

  // Adds the stores of a scalar or vector of 64 bits a component, whose low words come first.
  void StorePairs(ExprId value) {
    Builder at = context_.At(span_);
    const Type type = context_.TypeOf(value);
    const TypeId component = context_.types.Make(type.scalar);
    const TypeId word = context_.types.Make(Scalar::kUint);
    for (int i = 0; i < type.columns; ++i) {
      const ExprId one =
          type.kind == TypeKind::kScalar ? CopyOf(value) : at.Swizzled(CopyOf(value), {i});
      if (type.scalar == Scalar::kDouble) {
        const ExprId low = Hoist(context_, at.ZeroOf(word), prologue_);
        const ExprId high = Hoist(context_, at.ZeroOf(word), prologue_);
        stores_.push_back(CallIntrinsic("asuint", {one, low, high}));
        StoreWord(Clone(context_.program, low));
        StoreWord(Clone(context_.program, high));
      } else {
        StoreWord(at.ConvertTo(Scalar::kUint, one));
        const ExprId upper = at.BinaryOf(BinaryOp::kShiftRight, Clone(context_.program, one),
                                         at.Add(component, Literal{32}));
        StoreWord(at.ConvertTo(Scalar::kUint, upper));
      }
    }
  }

  // Adds the store of a scalar or vector.
  void StoreWords(ExprId value) {
    constexpr std::string_view kMethods[] = {"Store", "Store2", "Store3", "Store4"};
    const Type type = context_.TypeOf(value);
    if (IsWide(type.scalar)) return StorePairs(value);
    if (BaseOf(type.scalar) == Scalar::kFloat) value = CallIntrinsic("asuint", {value});
    const ExprId arguments[] = {Address(), value};
    stores_.push_back(CallMethod(kMethods[type.columns - 1], arguments));
    next_ += 4 * type.columns;
  }

  // Adds the stores of a value.
  void StoreParts(ExprId value) {
    const TypeId id = context_.TypeIdOf(value);
    const Type type = context_[id];
    Align(id);
    if (type.kind == TypeKind::kScalar || type.kind == TypeKind::kVector) return StoreWords(value);
    Builder at = context_.At(span_);
    if (type.kind == TypeKind::kMatrix && context_.options.byte_matrices_by_row) {
      for (std::uint32_t row = 0; row < type.rows; ++row) StoreWords(at.At(CopyOf(value), row));
      return;
    }
    if (type.kind == TypeKind::kMatrix) {
      for (std::uint32_t column = 0; column < type.columns; ++column) {
        Exprs rows;
        for (std::uint32_t row = 0; row < type.rows; ++row)
          rows.push_back(at.At(at.At(CopyOf(value), row), column));
        StoreWords(rows.size() == 1 ? rows[0]
                                    : at.ConstructOf(VectorOf(type.scalar, type.rows), rows));
      }
      return;
    }
    const std::uint32_t count = context_.types.PartCount(id);
    for (std::uint32_t i = 0; i < count; ++i) StoreParts(at.Part(CopyOf(value), i));
    Align(id);
  }

  TypeId VectorOf(Scalar scalar, int count) {
    return count == 1 ? context_.types.Make(scalar) : context_.types.Vector(scalar, count);
  }

  Context& context_;
  Span method_span_;
  ExprId object_;
  TypeId type_;
  Span span_;
  bool is_single_;  // whether the value is one load or store
  ExprId address_;  // none if it is a literal, `start_`
  std::uint32_t start_ = 0;
  std::uint32_t next_ = 0;  // bytes from the address to the next word
  Exprs prologue_, stores_;
};

bool IsByteBuffer(const Context& context, ExprId object) {
  const Type& type = context.TypeOf(object);
  return type.kind == TypeKind::kObject && IsByteAddress(type.object);
}

}  // namespace

bool IsTypedAccess(const Context& context, const ast::MemberExpr& member, ExprId object) {
  if (!member.arguments.empty()) return true;
  return context.options.stores_any_type && context[member.name] == "Store" &&
         IsByteBuffer(context, object);
}

ExprId CheckTypedAccess(Context& context, const ast::MemberExpr& member, ExprId object,
                        ExprSpan arguments, Span span) {
  const std::string_view method = context[member.name];
  const bool loads = method == "Load", stores = method == "Store";
  TypeId type;
  if (!member.arguments.empty()) type = TypeArgument(context, context[member.arguments][0]);
  const bool is_known = IsByteBuffer(context, object) && (loads || stores);
  const bool is_writable = is_known && IsWritable(context.TypeOf(object).object);
  if (is_known && (arguments.size() != (loads ? 1 : 2) || (stores && !is_writable))) {
    return CheckMethodCall(
        {context.program, method, member.name_span, arguments, span, context, context.diagnostics},
        object);
  }
  if (!type) type = context.TypeIdOf(arguments[1]);
  if (context.IsError(type)) return context.ErrorExpr(span);
  if (!is_known || !ConsistsOfWords(context, type)) {
    return context.Fail(
        member.name_span, diag::Unsupported,
        fmt::format("`{}` with the type argument `{}`", method, context.TypeName(type)));
  }
  // DXC's two backends do not agree about where its elements are.
  if (HoldsRowMajorMatrix(context, type, IsRowMajor(context, {}))) {
    return context.Fail(member.name_span, diag::Unsupported,
                        fmt::format("`{}` of a row-major matrix", method));
  }
  const auto access = [&] {
    return Access(context, {member.name_span, span}, object, arguments[0], type);
  };
  if (loads) return access().Load();
  const ExprId value = Implicit(context, arguments[1], type);
  return context.IsError(value) ? value : access().Store(value);
}

}  // namespace clipc::check
