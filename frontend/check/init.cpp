// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/init.h"

#include <algorithm>

#include "base/spelling.h"
#include "frontend/check/bit_field.h"
#include "frontend/check/construct.h"
#include "frontend/check/expr.h"
#include "frontend/check/struct.h"
#include "frontend/check/type.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

// A reader of an initialiser list, which deals its elements out to the components of a type. The
// elements that are not lists are checked in order, when they are needed.
class ListReader {
 public:
  ListReader(Context& context, ast::ExprId list) : context_(context) { Collect(list); }

  ExprId Read(TypeId type, Span span) {
    const ExprId value = Take(type);
    if (failed_) return context_.ErrorExpr(span);
    if (ran_out_ || next_ < sources_.size() || next_scalar_ < scalars_.size() || current_) {
      return context_.Fail(span, diag::InitialiserCount, ran_out_ ? "too few" : "too many",
                           context_.TypeName(type), ComponentsOf(context_, type));
    }
    return WithPrologue(context_, prologue_, value);
  }

 private:
  void Collect(ast::ExprId init) {
    const auto* list = context_.GetIf<ast::InitListExpr>(init);
    if (!list) return sources_.push_back(init);
    for (ast::ExprId element : context_[list->elements]) Collect(element);
  }

  bool Stopped() const { return ran_out_ || failed_; }

  // Makes current_ the next element, if there is one and none is being dealt out.
  bool Peek() {
    if (next_scalar_ < scalars_.size()) return false;
    if (current_) return true;
    if (next_ == sources_.size() || failed_) return false;
    current_ = CheckExpr(context_, sources_[next_++]);
    failed_ = context_.IsError(current_);
    return !failed_;
  }

  // Starts to deal current_ out component by component.
  void Open() {
    const ExprId value = std::exchange(current_, {});
    scalars_.clear();
    next_scalar_ = 0;
    if (context_.TypeOf(value).IsNumeric()) return TakeApart(context_, value, scalars_, prologue_);
    if (Flatten(context_.types, context_.TypeIdOf(value)))
      return OpenPart(Repeatable(context_, value, prologue_));
    context_.Report(context_[value].span, diag::CannotTakeApart, context_.TypeName(value));
    failed_ = true;
  }

  // The bit-fields that the part of the struct is made of.
  std::span<const BitField> BitsOf(TypeId type, std::uint32_t part) const {
    const StructInfo* info = InfoOf(context_, type);
    if (!info) return {};
    return std::span(std::ranges::equal_range(info->bits, part, {}, &BitField::field));
  }

  void OpenPart(ExprId value) {
    const Span at_span = context_[value].span;
    Builder at = context_.At(at_span);
    const Type type = context_.TypeOf(value);
    if (type.kind != TypeKind::kStruct && type.kind != TypeKind::kArray)
      return TakeApart(context_, value, scalars_, prologue_);
    const std::uint32_t count = context_.types.PartCount(context_.TypeIdOf(value));
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::span<const BitField> bits = BitsOf(context_.TypeIdOf(value), i);
      for (const BitField& field : bits) {
        if (field.name)
          scalars_.push_back(ReadBits(context_, Clone(context_.program, value), field, at_span));
      }
      if (bits.empty()) OpenPart(at.Part(Clone(context_.program, value), i));
    }
  }

  ExprId TakeScalar(Scalar kind) {
    if (Peek()) Open();
    ran_out_ = next_scalar_ >= scalars_.size();
    if (ran_out_) return context_.ErrorExpr({});
    return Implicit(context_, scalars_[next_scalar_++], context_.types.Make(kind));
  }

  ExprId Construct(TypeId type, ExprSpan parts) {
    const Span span = parts.empty() ? Span{} : context_[parts.front()].span;
    return Stopped() ? context_.ErrorExpr(span) : context_.At(span).ConstructOf(type, parts);
  }

  ExprId TakeVector(TypeId type_id) {
    const Type type = context_[type_id];
    Exprs parts;
    std::uint32_t filled = 0;
    while (filled < type.columns && !Stopped()) {
      const bool has_current = Peek();
      const Type given = has_current ? context_.TypeOf(current_) : Type{};
      const bool is_simple = given.kind == TypeKind::kScalar || given.kind == TypeKind::kVector;
      if (has_current && is_simple && filled + given.columns <= type.columns) {
        const ExprId value = std::exchange(current_, {});
        parts.push_back(Implicit(context_, value,
                                 context_.types.WithScalar(context_.TypeIdOf(value), type.scalar)));
        filled += given.columns;
      } else {
        parts.push_back(TakeScalar(type.scalar));
        ++filled;
      }
    }
    return Construct(type_id, parts);
  }

  // Takes the bit-fields of one number.
  ExprId TakeBits(std::span<const BitField> bits) {
    ExprId word;
    for (const BitField& field : bits) {
      if (!field.name || Stopped()) continue;
      const ExprId value = TakeScalar(context_[field.type].scalar);
      if (Stopped() || context_.IsError(value)) return value;
      const ExprId placed = PlaceBits(context_, value, field);
      const Span span = context_[placed].span;
      word = word ? context_.At(span).BinaryOf(BinaryOp::kBitOr, word, placed) : placed;
    }
    return word ? word : context_.At({}).ZeroOf(bits.front().type);
  }

  // Takes the rows of a matrix, the fields of a struct or the elements of an array.
  ExprId TakeParts(TypeId type_id) {
    const std::uint32_t count = context_.types.PartCount(type_id);
    Exprs parts;
    for (std::uint32_t i = 0; i < count && !Stopped(); ++i) {
      const std::span<const BitField> bits = BitsOf(type_id, i);
      parts.push_back(bits.empty() ? Take(context_.types.PartType(type_id, i)) : TakeBits(bits));
    }
    return Construct(type_id, parts);
  }

  ExprId Take(TypeId type_id) {
    if (Stopped()) return context_.ErrorExpr({});
    const Type type = context_[type_id];
    if (Peek()) {
      // An element of the type that is wanted here is kept whole.
      const Type& given = context_.TypeOf(current_);
      const bool same_shape = type.IsNumeric() && given.IsNumeric() && given.rows == type.rows &&
                              given.columns == type.columns;
      if (context_.TypeIdOf(current_) == type_id || same_shape)
        return Implicit(context_, std::exchange(current_, {}), type_id);
    }
    switch (type.kind) {
      case TypeKind::kScalar: return TakeScalar(type.scalar);
      case TypeKind::kVector: return TakeVector(type_id);
      case TypeKind::kMatrix:
      case TypeKind::kStruct:
      case TypeKind::kArray: return TakeParts(type_id);
      default: break;
    }
    if (!std::exchange(failed_, true)) {
      context_.Report(current_ ? context_[current_].span : Span{}, diag::NotConstructible,
                      context_.TypeName(type_id));
    }
    return context_.ErrorExpr({});
  }

  Context& context_;
  std::vector<ast::ExprId> sources_;
  std::size_t next_ = 0;
  ExprId current_;  // an element that is checked and not used yet
  Exprs scalars_;   // the components of the element that is dealt out
  std::size_t next_scalar_ = 0;
  Exprs prologue_;
  bool ran_out_ = false;
  bool failed_ = false;  // an error was reported
};

// The number of components that an initialiser gives; nullopt after an error, which was reported.
std::optional<std::uint64_t> CountComponents(Context& context, ast::ExprId init) {
  const auto& node = context[init].node;
  if (const auto* list = std::get_if<ast::InitListExpr>(&node)) {
    std::uint64_t total = 0;
    for (ast::ExprId element : context[list->elements]) {
      const auto count = CountComponents(context, element);
      if (!count) return std::nullopt;
      total += *count;
    }
    return total;
  }
  if (std::holds_alternative<ast::Literal>(node)) return 1;
  if (const auto* unary = std::get_if<ast::UnaryExpr>(&node))
    return CountComponents(context, unary->operand);
  const auto* call = std::get_if<ast::CallExpr>(&node);
  const auto* callee = call ? context.GetIf<ast::TypeExpr>(call->callee) : nullptr;
  const TypeId type =
      callee ? ResolveType(context, callee->type) : context.TypeIdOf(CheckExpr(context, init));
  if (context.IsError(type)) return std::nullopt;
  return ComponentsOf(context, type);
}

}  // namespace

ExprId CheckInit(Context& context, ast::ExprId init, TypeId type) {
  if (context.Is<ast::InitListExpr>(init)) {
    const Span span = context[init].span;
    return context.IsError(type) ? context.ErrorExpr(span)
                                 : ListReader(context, init).Read(type, span);
  }
  const ExprId value = CheckExpr(context, init);
  return context.IsError(value) ? value : Implicit(context, value, type);
}

std::optional<std::uint32_t> ImpliedCount(Context& context, ast::ExprId init, TypeId element) {
  const auto total = CountComponents(context, init);
  if (!total) return std::nullopt;
  const std::uint64_t each = std::max<std::uint64_t>(ComponentsOf(context, element), 1);
  if (*total == 0 || *total % each != 0 || *total / each > ~std::uint32_t{0}) {
    context.Report(context[init].span, diag::InitialiserNotWhole, WithCount(*total, "component"),
                   context.TypeName(element), each);
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(*total / each);
}

}  // namespace clipc::check
