// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <limits>

#include "base/overloaded.h"
#include "frontend/check/checker.h"
#include "frontend/rules/intrinsics.h"

// Expressions. Each is checked bottom up into a typed expression of the program; after an error it
// has the error type, which silences what follows.
namespace clipc {
namespace {

// Of expressions, statements and declarations inside each other. Frames of the checker are small
// enough for a stack of 8 MiB, sanitizers included.
constexpr int kMaxCheckDepth = 2500;

}  // namespace

Checker::Depth::Depth(Checker& checker, Span where, int weight)
    : checker_(checker), weight_(weight) {
  checker_.depth_ += weight_;
  ok_ = checker_.depth_ <= kMaxCheckDepth;
  if (!ok_) checker_.diagnostics_.Report(where, diag::CheckTooDeep, kMaxCheckDepth);
}

ir::ExprId Checker::ErrorExpr(Span span) { return At(span).ZeroOf(program_.types.Error()); }

ir::ExprId Checker::CheckExpr(ast::ExprId id) {
  const ast::Expr& expr = file_.exprs[id];
  const Depth depth(*this, expr.span);
  if (!depth.ok()) return ErrorExpr(expr.span);
  const Span span = expr.span;
  return Visit(Overloaded{
                   [&](const ast::Literal& e) { return CheckLiteral(e, span); },
                   [&](const ast::NameExpr& e) { return CheckName(e, span); },
                   [&](const ast::TypeExpr&) {
                     diagnostics_.Report(span, diag::TypeAsValue, TextOf(id));
                     return ErrorExpr(span);
                   },
                   [&](const ast::UnaryExpr& e) { return CheckUnary(e, span); },
                   [&](const ast::BinaryExpr& e) { return CheckBinary(e, span); },
                   [&](const ast::AssignExpr& e) { return CheckAssign(e, span); },
                   [&](const ast::ConditionalExpr& e) { return CheckConditional(e, span); },
                   [&](const ast::CallExpr& e) { return CheckCall(e, span); },
                   [&](const ast::CastExpr& e) { return CheckCast(e, span); },
                   [&](const ast::IndexExpr& e) { return CheckIndex(e, span); },
                   [&](const ast::MemberExpr& e) { return CheckMember(e, span); },
                   [&](const ast::InitListExpr&) {
                     diagnostics_.Report(span, diag::InitListAsValue);
                     return ErrorExpr(span);
                   },
                   [&](const ast::SizeofExpr& e) { return CheckSizeof(e, span); },
                   [&](const ast::ErrorExpr&) { return ErrorExpr(span); },
               },
               expr.node);
}

ir::ExprId Checker::CheckLiteral(const ast::Literal& literal, Span span) {
  ir::Builder at = At(span);
  const double number = std::bit_cast<double>(literal.bits);
  constexpr std::uint64_t kMaxInt = std::numeric_limits<std::int32_t>::max();
  constexpr std::uint64_t kMaxUint = std::numeric_limits<std::uint32_t>::max();
  const bool is_wide = literal.kind == LiteralKind::kInt64 || literal.kind == LiteralKind::kUint64;
  if (is_wide && literal.bits > kMaxUint && !program_.profile.IsAtLeast(6, 0)) {
    diagnostics_.Report(span, diag::IntegerTooLarge, literal.bits);
    return ErrorExpr(span);
  }
  switch (literal.kind) {
    case LiteralKind::kBool: return at.Bool(literal.bits != 0);
    case LiteralKind::kInt:
    case LiteralKind::kUint:
      if (literal.bits > kMaxUint) diagnostics_.Report(span, diag::IntegerTooLarge, literal.bits);
      if (literal.kind == LiteralKind::kUint || literal.bits > kMaxInt)
        return at.Uint(static_cast<std::uint32_t>(literal.bits));
      return at.Int(static_cast<std::int32_t>(literal.bits));
    case LiteralKind::kInt64:
      return at.Add(program_.types.Make(ir::Scalar::kInt64), ir::Literal{literal.bits});
    case LiteralKind::kUint64:
      return at.Add(program_.types.Make(ir::Scalar::kUint64), ir::Literal{literal.bits});
    case LiteralKind::kHalf: return at.LiteralOf(ir::Scalar::kHalf, number);
    case LiteralKind::kFloat: return at.Float(static_cast<float>(number));
    case LiteralKind::kDouble: return at.LiteralOf(ir::Scalar::kDouble, number);
    case LiteralKind::kString: break;
  }
  return at.ZeroOf(program_.types.String());
}

ir::ExprId Checker::CheckName(const ast::NameExpr& name, Span span) {
  if (const SymbolId symbol = Find(name.name)) return UseSymbol(symbol, span);
  const bool is_plain = name.name.scopes.empty();
  const std::string_view text = Text(name.name.name);
  if (is_plain && text == "this" && context_.body && context_.body->self)
    return At(span).Ref(context_.body->self);
  if (is_plain && IsIntrinsicName(text)) {
    diagnostics_.Report(span, diag::FunctionAsValue, text);
  } else {
    ReportUndeclared(span, name.name, false, false);
  }
  return ErrorExpr(span);
}

ir::ExprId Checker::UseSymbol(SymbolId id, Span span) {
  const Symbol& symbol = symbols_[id];
  switch (symbol.kind) {
    case SymbolKind::kVariable: return UseVariable(id, span);
    case SymbolKind::kField: {
      const ir::VarId self = context_.body ? context_.body->self : ir::VarId{};
      const auto field = self ? FindField(program_.vars[self].type, symbol.name) : std::nullopt;
      if (field) return At(span).Field(At(span).Ref(self), *field);
      diagnostics_.Report(span, diag::FieldWithoutObject, Text(symbol.name))
          .Note(symbol.span, diag::DeclaredHere, Text(symbol.name));
      return ErrorExpr(span);
    }
    case SymbolKind::kEnumerator: {
      const SymbolId owner{symbol.owner};
      ResolveEnum(owner, std::get<ast::EnumDecl>(file_.decls[symbol.decl].node));
      const auto& values = enum_values_[owner.index];
      if (symbol.value < values.size())
        return At(span).Add(ResolveTypeSymbol(owner), ir::Literal{values[symbol.value]});
      diagnostics_.Report(span, diag::InitialisedByItself, Text(symbol.name));
      return ErrorExpr(span);
    }
    case SymbolKind::kTemplateValue:
      return At(span).Add(ir::TypeId{symbol.owner}, ir::Literal{symbol.value});
    case SymbolKind::kFunction:
      diagnostics_.Report(span, diag::FunctionAsValue, Text(symbol.name));
      break;
    case SymbolKind::kType: diagnostics_.Report(span, diag::TypeAsValue, Text(symbol.name)); break;
    case SymbolKind::kNamespace:
      diagnostics_.Report(span, diag::NamespaceAsValue, Text(symbol.name));
      break;
  }
  return ErrorExpr(span);
}

ir::ExprId Checker::UseVariable(SymbolId id, Span span) {
  Symbol& symbol = symbols_[id];
  if (!symbol.scope) {
    if (symbol.is_leaked) HoistLoopVariable(id);
    return symbol.value == ~0u ? ErrorExpr(span) : At(span).Ref(ir::VarId{symbol.value});
  }
  const auto& var = std::get<ast::VarDecl>(file_.decls[symbol.decl].node);
  const bool is_uniform = !(var.qualifiers & ast::kStatic);
  if (context_.wants_constant && is_uniform && (var.qualifiers & ast::kConst) && var.init) {
    // fxc takes the value of a `const` global for a constant where it needs one, and nowhere else.
    Context context = ContextOf(id);
    context.wants_constant = true;
    const ContextSwitch in(*this, context);
    const ir::TypeId type = ResolveVarType(var);
    return type == program_.types.Error() ? ErrorExpr(span) : CheckInit(var.init, type);
  }
  if (!ResolveVar(id)) return ErrorExpr(span);
  if (is_uniform && symbol.is_const && var.init) {
    diagnostics_.Report(symbol.span, diag::ConstGlobalIsUniform, Text(symbol.name));
    symbol.is_const = false;
  }
  return At(span).Ref(ir::VarId{symbol.value});
}

// A fresh reference to a temporary that holds `value`.
ir::ExprId Checker::Hoist(ir::ExprId value, std::vector<ir::ExprId>& prologue) {
  const Span span = program_.exprs[value].span;
  const Temporary temporary = Make(value);
  prologue.push_back(temporary.prologue);
  return At(span).Ref(temporary.var);
}

ir::ExprId Checker::WithPrologue(std::span<const ir::ExprId> prologue, ir::ExprId value) {
  for (std::size_t i = prologue.size(); i-- > 0;) {
    value = At(program_.exprs[value].span).CommaOf(prologue[i], value);
  }
  return value;
}

TemporaryMaker::Temporary Checker::Make(ir::ExprId value) {
  ir::Builder at = At(program_.exprs[value].span);
  const ir::VarId var = at.Local("temporary", TypeIdOf(value));
  if (context_.body) {
    context_.body->temporaries.push_back(var);
  } else {
    program_.vars[var].storage = ir::Storage::kStatic;
    reached_globals_.push_back({context_.order, var});
  }
  return {var, at.AssignTo(at.Ref(var), value)};
}

ir::ExprId Checker::CheckConditional(const ast::ConditionalExpr& expr, Span span) {
  ir::ExprId condition = CheckExpr(expr.condition);
  ir::ExprId when_true = CheckExpr(expr.when_true);
  ir::ExprId when_false = CheckExpr(expr.when_false);
  if (IsError(condition) || IsError(when_true) || IsError(when_false)) return ErrorExpr(span);
  const Span condition_span = file_.exprs[expr.condition].span;
  if (!TypeOf(condition).IsNumeric()) {
    diagnostics_.Report(condition_span, diag::ConditionNotScalar,
                        "?:", TypeName(TypeIdOf(condition)));
    return ErrorExpr(span);
  }
  const bool is_scalar = TypeOf(condition).Components() == 1;
  std::optional<ir::TypeId> type = Common(TypeIdOf(when_true), TypeIdOf(when_false));
  if (type && !is_scalar) {
    type =
        Common(program_.types.WithScalar(TypeIdOf(condition), program_.types[*type].scalar), *type);
  }
  if (!type || *type == program_.types.Void()) {
    diagnostics_.Report(span, diag::BranchesDiffer, TypeName(TypeIdOf(when_true)),
                        TypeName(TypeIdOf(when_false)));
    return ErrorExpr(span);
  }
  when_true = Implicit(when_true, *type);
  when_false = Implicit(when_false, *type);
  const ir::TypeId boolean = program_.types.Make(ir::Scalar::kBool);
  condition = is_scalar ? ConvertSilently(condition, boolean)
                        : Implicit(condition, program_.types.WithScalar(*type, ir::Scalar::kBool));
  if (!is_scalar) return At(span).Add(*type, ir::Select{condition, when_true, when_false});
  // Before HLSL 2021 both sides are evaluated.
  std::vector<ir::ExprId> prologue;
  const bool evaluates_both = !options_.profile.IsAtLeast(6, 0);
  if (evaluates_both && !(ir::IsPure(program_, when_true) && ir::IsPure(program_, when_false))) {
    condition = Hoist(condition, prologue);
    const bool is_literal = std::holds_alternative<ir::Literal>(program_.exprs[when_true].node);
    if (!is_literal) when_true = Hoist(when_true, prologue);
    // Last in order: nothing comes between it and the choice.
    if (!ir::IsPure(program_, when_false)) when_false = Hoist(when_false, prologue);
  }
  return WithPrologue(prologue,
                      At(span).Add(*type, ir::Conditional{condition, when_true, when_false}));
}

ir::ExprId Checker::CheckCast(const ast::CastExpr& expr, Span span) {
  const ir::TypeId type =
      ArrayOf(ResolveType(expr.type), expr.dimensions, file_.types[expr.type].span);
  const ir::ExprId value = CheckExpr(expr.operand);
  if (IsError(value) || type == program_.types.Error()) return ErrorExpr(span);
  if (TypeIdOf(value) == type) return value;
  if (IsExplicitlyConvertible(program_.types, TypeIdOf(value), type)) {
    return ConvertExplicit(program_, value, type, *this);
  }
  if (DerivesFrom(TypeIdOf(value), type)) return Implicit(value, type);
  diagnostics_.Report(span, diag::CannotCast, TypeName(TypeIdOf(value)), TypeName(type));
  return ErrorExpr(span);
}

// As DXC has it: the bytes of the components, without padding.
ir::ExprId Checker::CheckSizeof(const ast::SizeofExpr& expr, Span span) {
  const ast::Expr& operand = file_.exprs[expr.operand];
  ir::TypeId type;
  if (const auto* written = std::get_if<ast::TypeExpr>(&operand.node)) {
    type = ResolveType(written->type);
  } else if (const auto* name = std::get_if<ast::NameExpr>(&operand.node);
             name && Find(name->name, true)) {
    type = TypeArgument(expr.operand);
  } else {
    type = TypeIdOf(CheckExpr(expr.operand));
  }
  if (type == program_.types.Error()) return ErrorExpr(span);
  const auto leaves = Flatten(program_.types, type);
  if (!leaves) {
    diagnostics_.Report(span, diag::SizeUnknown, TypeName(type));
    return ErrorExpr(span);
  }
  std::uint32_t size = 0;
  for (ir::Scalar leaf : *leaves) {
    const ir::Scalar base = ir::BaseOf(leaf);
    const bool is_wide =
        base == ir::Scalar::kDouble || base == ir::Scalar::kInt64 || base == ir::Scalar::kUint64;
    size += is_wide ? 8 : 4;
  }
  return At(span).Uint(size);
}

// The value as `to`, or what is wrong with that.
ir::ExprId Checker::Implicit(ir::ExprId value, ir::TypeId to) {
  const ir::TypeId from = TypeIdOf(value);
  const Span span = program_.exprs[value].span;
  if (from == to) return value;
  if (from == program_.types.Error() || to == program_.types.Error()) return ErrorExpr(span);
  if (RankImplicit(program_.types, from, to))
    return ConvertImplicit(program_, value, to, diagnostics_, this);
  if (DerivesFrom(from, to)) {
    // The fields of the first base come first.
    std::vector<ir::ExprId> prologue, fields;
    const ir::ExprId object =
        IsPath(value) && ir::IsPure(program_, value) ? value : Hoist(value, prologue);
    const ir::Struct& base = program_.types.StructOf(to);
    const StructInfo& info = *InfoOf(to);
    for (std::size_t i = 0; i < base.fields.size(); ++i) {
      const auto field = FindField(from, info.fields[i]);
      fields.push_back(At(span).Field(ir::Clone(program_, object), *field));
    }
    return WithPrologue(prologue, At(span).ConstructOf(to, fields));
  }
  diagnostics_.Report(span, diag::CannotConvert, TypeName(from), TypeName(to));
  return ErrorExpr(span);
}

// Of one component, or where the user asked for it: nothing to warn of.
ir::ExprId Checker::ConvertSilently(ir::ExprId value, ir::TypeId to) {
  if (TypeIdOf(value) == to) return value;
  return ConvertExplicit(program_, value, to, *this);
}

}  // namespace clipc
