// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "base/overloaded.h"
#include "frontend/check/checker.h"
#include "frontend/rules/constant.h"

// From types as written to types of the program.
namespace clipc {
namespace {

// Far above what any shader needs, and low enough that a type can be walked leaf by leaf.
constexpr std::uint64_t kMaxComponents = 1u << 20;
constexpr int kMaxTypeDepth = 64;

}  // namespace

ir::TypeId Checker::ResolveType(ast::TypeId id) {
  if (!id) return program_.types.Error();
  const ast::Type& type = file_.types[id];
  if (!type.struct_definition) return ResolveNamedType(type);
  const auto known = struct_symbols_.find(type.struct_definition.index);
  if (known != struct_symbols_.end())
    return known->second ? ResolveTypeSymbol(known->second) : program_.types.Error();
  DeclareLocalType(type.struct_definition);
  return ResolveTypeSymbol(struct_symbols_.at(type.struct_definition.index));
}

ir::TypeId Checker::ResolveNamedType(const ast::Type& type) {
  const bool is_plain = type.name.scopes.empty() && !type.name.from_global;
  if (!type.name.name) return program_.types.Error();
  if (is_plain && !type.has_arguments) {
    if (const auto numeric = NumericType(type.name.name)) return *numeric;
  }
  if (const SymbolId symbol = Find(type.name, true)) {
    if (const auto instance = InstantiateStruct(symbol, type)) return *instance;
    return ResolveTypeSymbol(symbol);
  }
  if (is_plain) {
    const std::string_view text = Text(type.name.name);
    if (const auto generic = GenericNumericType(type, text)) return *generic;
    if (const auto object = ObjectType(type, text)) return *object;
  }
  ReportUndeclared(type.span, type.name, true, false);
  return program_.types.Error();
}

ir::TypeId Checker::ResolveTypeSymbol(SymbolId id) {
  Symbol& symbol = symbols_[id];
  if (symbol.resolution == Resolution::kDone) return ir::TypeId{symbol.value};
  const Depth depth(*this, symbol.span, kDeclarationWeight);
  if (symbol.resolution == Resolution::kUnderWay || !depth.ok()) {
    if (depth.ok()) diagnostics_.Report(symbol.span, diag::TypeContainsItself, Text(symbol.name));
    symbol.value = program_.types.Error().index;
    symbol.resolution = Resolution::kDone;
    return program_.types.Error();
  }
  symbol.resolution = Resolution::kUnderWay;
  const Context context = ContextOf(id);
  const ast::Decl& decl = file_.decls[symbol.decl];
  ir::TypeId type = program_.types.Error();
  if (const auto* structure = std::get_if<ast::StructDecl>(&decl.node)) {
    if (structure->is_definition) {
      type = ResolveStruct(symbol.decl, id, context.scope, context.order);
    } else {
      diagnostics_.Report(structure->name_span, diag::IncompleteType, Text(structure->name));
    }
  } else if (const auto* alias = std::get_if<ast::TypedefDecl>(&decl.node)) {
    const ContextSwitch in(*this, context);
    type = ArrayOf(ResolveType(alias->type), alias->dimensions, alias->name_span);
  } else if (const auto* enumeration = std::get_if<ast::EnumDecl>(&decl.node)) {
    const ContextSwitch in(*this, context);
    type = EnumType(*enumeration);
  }
  symbol.value = type.index;
  symbol.resolution = Resolution::kDone;
  return type;
}

// What the declaration of `id` sees: its scope, what stands before it, and itself.
Checker::Context Checker::ContextOf(SymbolId id) const {
  const Symbol& symbol = symbols_[id];
  if (!symbol.scope) return context_;
  const Scope& scope = scopes_[symbol.scope];
  Context context;
  context.scope = symbol.scope;
  context.order = scope.kind == ScopeKind::kNamespace ? id.index + 1 : scope.order;
  context.local_floor = symbols_.size();
  return context;
}

std::uint64_t Checker::ComponentsOf(ir::TypeId id) const {
  const ir::Type& type = program_.types[id];
  switch (type.kind) {
    case ir::TypeKind::kArray:
      return std::min(type.count * ComponentsOf(type.element), kMaxComponents + 1);
    case ir::TypeKind::kStruct: return struct_infos_[type.structure.index].components;
    default: return type.IsNumeric() ? type.Components() : 1;
  }
}

int Checker::DepthOf(ir::TypeId id) const {
  const ir::Type& type = program_.types[id];
  if (type.kind == ir::TypeKind::kArray) return DepthOf(type.element) + 1;
  return type.kind == ir::TypeKind::kStruct ? struct_infos_[type.structure.index].depth : 0;
}

bool Checker::IsTooLarge(ir::TypeId type, Span span) {
  if (ComponentsOf(type) > kMaxComponents) {
    diagnostics_.Report(span, diag::TypeTooLarge, kMaxComponents);
    return true;
  }
  if (DepthOf(type) > kMaxTypeDepth) {
    diagnostics_.Report(span, diag::TypeTooDeep, kMaxTypeDepth);
    return true;
  }
  return false;
}

// An integer that the text fixes; nothing after an error, which was reported.
std::optional<std::int64_t> Checker::ConstantInteger(ast::ExprId id) {
  const ast::Expr& expr = file_.exprs[id];
  if (const auto* literal = std::get_if<ast::Literal>(&expr.node);
      literal && literal->kind == LiteralKind::kInt) {
    return static_cast<std::int64_t>(literal->bits);
  }
  Context context = context_;
  context.wants_constant = true;
  const ContextSwitch in(*this, context);
  const ir::ExprId value = CheckExpr(id);
  if (IsError(value)) return std::nullopt;
  if (const auto number = EvaluateInteger(program_, value)) return number;
  // A float with a whole value will do, as in fxc.
  if (const auto constant = EvaluateConstant(program_, value);
      constant && constant->components.size() == 1) {
    const double number = constant->components[0];
    if (number == static_cast<double>(static_cast<std::int32_t>(std::clamp(number, -2e9, 2e9)))) {
      return static_cast<std::int64_t>(number);
    }
  }
  diagnostics_.Report(expr.span, diag::NotConstantInteger, TextOf(id));
  return std::nullopt;
}

std::optional<std::uint32_t> Checker::ArraySize(ast::ExprId dimension) {
  const auto size = ConstantInteger(dimension);
  if (!size) return std::nullopt;
  if (*size > 0 && static_cast<std::uint64_t>(*size) <= kMaxComponents)
    return static_cast<std::uint32_t>(*size);
  diagnostics_.Report(file_.exprs[dimension].span, diag::BadArraySize, *size, kMaxComponents);
  return std::nullopt;
}

// element[d0][d1]; `implied` is the size of a `[]` in front.
ir::TypeId Checker::ArrayOf(ir::TypeId element, List<ast::ExprId> dimensions, Span span,
                            std::optional<std::uint32_t> implied) {
  if (dimensions.empty()) return element;
  if (element == program_.types.Void()) {
    diagnostics_.Report(span, diag::VoidValue, "an array of `void`");
    return program_.types.Error();
  }
  ir::TypeId type = element;
  bool is_broken = element == program_.types.Error();
  for (std::uint32_t i = dimensions.size; i-- > 0;) {
    const ast::ExprId dimension = file_.expr_lists[dimensions][i];
    std::optional<std::uint32_t> size;
    if (dimension) {
      size = ArraySize(dimension);
    } else if (i == 0 && implied) {
      size = implied;
    } else {
      diagnostics_.Report(span, diag::ArrayWithoutSize);
    }
    is_broken = is_broken || !size;
    if (is_broken) continue;
    type = program_.types.Array(type, *size);
    is_broken = IsTooLarge(type, span);
  }
  return is_broken ? program_.types.Error() : type;
}

ir::TypeId Checker::ResolveVarType(const ast::VarDecl& var) {
  const ir::TypeId element = ResolveType(var.type);
  const Span span = var.name ? var.name_span : file_.types[var.type].span;
  if (element == program_.types.Void()) {
    diagnostics_.Report(span, diag::VoidValue, fmt::format("`{}` of type `void`", Text(var.name)));
    return program_.types.Error();
  }
  const bool is_implied = !var.dimensions.empty() && !file_.expr_lists[var.dimensions][0];
  std::optional<std::uint32_t> implied;
  if (is_implied && var.init && element != program_.types.Error()) {
    List<ast::ExprId> inner = var.dimensions;
    ++inner.begin;
    --inner.size;
    const ir::TypeId row = ArrayOf(element, inner, span);
    if (row == program_.types.Error()) return row;
    implied = ImpliedCount(var.init, row);
    if (!implied) return program_.types.Error();
  }
  return ArrayOf(element, var.dimensions, span, implied);
}

bool Checker::IsRowMajor(ast::Qualifiers qualifiers) const {
  if (qualifiers & ast::kRowMajor) return true;
  if (qualifiers & ast::kColumnMajor) return false;
  if (qualifiers & ast::kPackRowMajor) return true;
  if (qualifiers & ast::kPackColumnMajor) return false;
  return options_.packing == MatrixPacking::kRowMajor;
}

// The qualifiers of a variable, those of the typedef it is declared with included.
ast::Qualifiers Checker::QualifiersOf(const ast::VarDecl& var) {
  ast::Qualifiers qualifiers = var.qualifiers;
  const ast::Type& type = file_.types[var.type];
  if (!type.name.name || type.struct_definition) return qualifiers;
  const SymbolId symbol = Find(type.name, true);
  if (!symbol || !symbols_[symbol].decl) return qualifiers;
  const auto* alias = std::get_if<ast::TypedefDecl>(&file_.decls[symbols_[symbol].decl].node);
  if (!alias) return qualifiers;
  constexpr ast::Qualifiers kPacking = ast::kRowMajor | ast::kColumnMajor;
  if (!(qualifiers & kPacking)) qualifiers |= alias->qualifiers & kPacking;
  return qualifiers | (alias->qualifiers & ast::kConst);
}

}  // namespace clipc
