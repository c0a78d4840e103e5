// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/type.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "frontend/check/buffer.h"
#include "frontend/check/enum.h"
#include "frontend/check/init.h"
#include "frontend/check/scope.h"
#include "frontend/check/struct.h"
#include "frontend/check/template.h"
#include "frontend/check/type_names.h"
#include "frontend/check/value.h"

namespace clipc::check {
namespace {

// Limits far above what any shader needs, and low enough that a type can be walked leaf by leaf.
constexpr std::uint64_t kMaxComponents = 1u << 20;
// The fields of a struct and of the structs in it, those of an array's element once. A walk over a
// type visits each; structs of empty structs have many and no component.
constexpr std::uint64_t kMaxFields = 1u << 14;

constexpr int kMaxTypeDepth = 64;

std::optional<std::uint32_t> ArraySize(Context& context, ast::ExprId dimension) {
  const auto size = ConstantInteger(context, dimension);
  if (!size) return std::nullopt;
  if (*size > 0 && static_cast<std::uint64_t>(*size) <= kMaxComponents)
    return static_cast<std::uint32_t>(*size);
  context.Report(context[dimension].span, diag::BadArraySize, *size, kMaxComponents);
  return std::nullopt;
}

// Whether the type is InputPatch<T, N> or OutputPatch<T, N>, written with this name.
bool NamesPatch(const Context& context, ast::TypeId of) {
  const ast::Type& type = context[of];
  return type.has_arguments && type.name.name && IsPatchName(context[type.name.name]);
}

constexpr ast::Qualifiers kMajority = ast::kRowMajor | ast::kColumnMajor;

// Adds the qualifiers of the typedefs that `of` names, one after the other, and makes `of` the type
// that the last of them names. A patch is constant.
ast::Qualifiers WithAliases(Context& context, ast::Qualifiers qualifiers, ast::TypeId& of) {
  constexpr ast::Qualifiers kPragma = ast::kPackRowMajor | ast::kPackColumnMajor;
  constexpr int kMostAliases = 16;  // a name that hides one in its own typedef has no end
  for (int i = 0; i < kMostAliases; ++i) {
    const ast::Type& type = context[of];
    if (!type.name.name || type.struct_definition) break;
    const SymbolId symbol = Find(context, type.name, true);
    if (!symbol || !context[symbol].decl) break;
    const auto* alias = context.GetIf<ast::TypedefDecl>(context[symbol].decl);
    if (!alias || alias->is_template) break;
    if (!(qualifiers & kMajority)) qualifiers |= alias->qualifiers & kMajority;
    // The last pragma before a typedef holds for it. If there is none, the pragma of the variable
    // holds for a matrix, and none for an array (vkd3d's test of the pragma, checked against
    // native).
    if ((alias->qualifiers & kPragma) || !alias->dimensions.empty())
      qualifiers = (qualifiers & ~kPragma) | (alias->qualifiers & kPragma);
    qualifiers |= alias->qualifiers & ast::kConst;
    of = alias->type;
  }
  return NamesPatch(context, of) ? qualifiers | ast::kConst : qualifiers;
}

// The type, or the error type where the profile has no integers of 64 bits or no doubles, which is
// reported (fxc X3653, "vs_4_0 does not support doubles as a storage type"). In Direct3D 9's
// profiles a double is a float.
TypeId OfProfile(Context& context, TypeId type, Span span) {
  const Scalar kind = context[type].scalar;
  const Profile& profile = context.program.profile;
  const bool is_wide = kind == Scalar::kInt64 || kind == Scalar::kUint64;
  const bool lacks =
      is_wide ? !profile.IsAtLeast(6, 0) : kind == Scalar::kDouble && profile.major == 4;
  if (!lacks || context.program.is_interface_only) return type;
  return context.FailType(
      span, diag::TypeProfile, context.TypeName(type),
      fmt::format("{}_{}_0", InfoOf(context.program.stage).prefix, is_wide ? 6 : 5), profile.name);
}

// The unsigned type of `unsigned` before a typedef of integers, as DXC's
// ApplyTypeSpecSignToParsedType has it; fxc X3085 for every other type.
TypeId Unsigned(Context& context, TypeId named, Span span) {
  if (context.IsError(named)) return named;
  const Type& type = context[named];
  if (type.IsNumeric()) {
    switch (type.scalar) {
      case Scalar::kInt: return context.types.WithScalar(named, Scalar::kUint);
      case Scalar::kMin16Int: return context.types.WithScalar(named, Scalar::kMin16Uint);
      case Scalar::kInt64: return context.types.WithScalar(named, Scalar::kUint64);
      case Scalar::kUint:
      case Scalar::kMin16Uint:
      case Scalar::kUint64: return named;
      default: break;
    }
  }
  return context.FailType(span, diag::UnsignedType, context.TypeName(named));
}

}  // namespace

TypeId ResolveType(Context& context, ast::TypeId id) {
  if (!id) return context.types.Error();
  const ast::Type& type = context[id];
  if (!type.struct_definition) {
    const TypeId named = ResolveNamedType(context, type);
    return type.is_unsigned ? Unsigned(context, named, type.span) : named;
  }
  const auto known = context.structs.symbols.find(type.struct_definition.index);
  if (known != context.structs.symbols.end())
    return known->second ? ResolveTypeSymbol(context, known->second) : context.types.Error();
  DeclareLocalType(context, type.struct_definition);
  return ResolveTypeSymbol(context, context.structs.symbols.at(type.struct_definition.index));
}

// The type of at least 16 bits in place of `uint16_t3` and the like, which have exactly 16 and are
// in dxc with -enable-16bit-types alone; empty for other names.
std::string WiderThan16Bits(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> kTypes[] = {
      {"int16_t", "min16int"}, {"uint16_t", "min16uint"}, {"float16_t", "min16float"}};
  for (const auto& [exact, wider] : kTypes)
    if (name.starts_with(exact)) return fmt::format("{}{}", wider, name.substr(exact.size()));
  return {};
}

TypeId ResolveNamedType(Context& context, const ast::Type& type) {
  const bool is_plain = type.name.scopes.empty() && !type.name.from_global;
  if (!type.name.name) return context.types.Error();
  if (is_plain && !type.has_arguments) {
    // `uint16_t` and the like are young names, which older files have a typedef for.
    const std::string_view text = context[type.name.name];
    const bool may_be_own = text.find("_t") != std::string_view::npos;
    const bool is_own = may_be_own && Find(context, type.name, true);
    if (const auto numeric = is_own ? std::nullopt : NumericType(context, type.name.name)) {
      const std::string wider = may_be_own ? WiderThan16Bits(text) : "";
      if (!wider.empty())
        return context.FailType(
            type.span, diag::Unsupported,
            fmt::format("`{}`, a type of 16 bits in memory (`{}` may have more),", text, wider));
      return OfProfile(context, *numeric, type.span);
    }
  }
  if (const SymbolId symbol = Find(context, type.name, true)) {
    if (context.names.uses_any() && !IsOneThing(context, type.span, type.name, true))
      return context.types.Error();
    if (const auto instance = InstantiateStruct(context, symbol, type)) return *instance;
    if (const auto named = InstantiateAlias(context, symbol, type)) return *named;
    return ResolveTypeSymbol(context, symbol);
  }
  if (is_plain) {
    const std::string_view text = context[type.name.name];
    if (const auto generic = GenericNumericType(context, type, text)) return *generic;
    if (const auto object = ObjectType(context, type, text)) return *object;
  }
  ReportUndeclared(context, type.span, type.name, NameUse::kType);
  return context.types.Error();
}

TypeId ResolveTypeSymbol(Context& context, SymbolId id) {
  Symbol& symbol = context[id];
  if (symbol.resolution == Resolution::kDone) return TypeId{symbol.value};
  const RecursionGuard guard(context, symbol.span, RecursionGuard::kDeclaration);
  if (symbol.resolution == Resolution::kUnderWay || !guard.ok()) {
    if (guard.ok()) context.Report(symbol.span, diag::TypeContainsItself, context[symbol.name]);
    symbol.Resolve(context.types.Error().index);
    return context.types.Error();
  }
  symbol.resolution = Resolution::kUnderWay;
  const View view = ViewOf(context, id);
  const ast::Decl& decl = context[symbol.decl];
  TypeId type = context.types.Error();
  if (const auto* structure = std::get_if<ast::StructDecl>(&decl.node)) {
    if (structure->is_definition) {
      type = ResolveStruct(context, symbol.decl, id, view.scope, view.order);
    } else {
      context.Report(structure->name_span, diag::IncompleteType, context[structure->name]);
    }
  } else if (const auto* alias = std::get_if<ast::TypedefDecl>(&decl.node)) {
    const ViewSwitch in(context, view);
    const TypeId named = ResolveType(context, alias->type);
    if (context[named].kind == TypeKind::kStruct) {
      std::string& name = context[context[named].structure].name;
      if (name.empty()) name = context[alias->name];  // typedef struct {..} vertex_in;
    }
    type = ArrayOf(context, named, alias->dimensions, alias->name_span);
  } else if (const auto* enumeration = std::get_if<ast::EnumDecl>(&decl.node)) {
    const ViewSwitch in(context, view);
    type = EnumType(context, *enumeration);
  }
  symbol.Resolve(type.index);
  return type;
}

View ViewOf(const Context& context, SymbolId id) {
  const Symbol& symbol = context[id];
  if (!symbol.scope) return context.view;
  const Scope& scope = context[symbol.scope];
  View view;
  view.scope = symbol.scope;
  view.order = scope.kind == ScopeKind::kNamespace ? id.index + 1 : scope.order;
  view.local_floor = context.names.size();
  return view;
}

std::uint64_t ComponentsOf(const Context& context, TypeId id) {
  const Type& type = context[id];
  switch (type.kind) {
    case TypeKind::kArray:
      return std::min(type.count * ComponentsOf(context, type.element), kMaxComponents + 1);
    case TypeKind::kStruct: return context.structs.infos[type.structure.index].components;
    default: return type.IsNumeric() ? type.Components() : 1;
  }
}

std::uint64_t FieldsOf(const Context& context, TypeId id) {
  const Type& type = context[context.types.Innermost(id)];
  if (type.kind != TypeKind::kStruct) return 0;
  return context.structs.infos[type.structure.index].fields_of_all;
}

int DepthOf(const Context& context, TypeId id) {
  const Type& type = context[id];
  if (type.kind == TypeKind::kArray) return DepthOf(context, type.element) + 1;
  return type.kind == TypeKind::kStruct ? context.structs.infos[type.structure.index].depth : 0;
}

bool IsTooLarge(Context& context, TypeId type, Span span) {
  if (ComponentsOf(context, type) > kMaxComponents) {
    context.Report(span, diag::TypeTooLarge, kMaxComponents, "components");
    return true;
  }
  if (FieldsOf(context, type) > kMaxFields) {
    context.Report(span, diag::TypeTooLarge, kMaxFields, "fields");
    return true;
  }
  if (DepthOf(context, type) > kMaxTypeDepth) {
    context.Report(span, diag::TypeTooDeep, kMaxTypeDepth);
    return true;
  }
  return false;
}

TypeId ArrayOf(Context& context, TypeId element, List<ast::ExprId> dimensions, Span span,
               const OpenDimension& open) {
  return ArrayOf(context, element, context[dimensions], span, open);
}

TypeId ArrayOf(Context& context, TypeId element, std::span<const ast::ExprId> dimensions, Span span,
               const OpenDimension& open) {
  if (dimensions.empty()) return element;
  if (element == context.types.Void()) {
    return context.FailType(span, diag::VoidValue, "an array of `void`");
  }
  TypeId type = element;
  bool is_broken = context.IsError(element);
  for (std::size_t i = dimensions.size(); i-- > 0;) {
    const ast::ExprId dimension = dimensions[i];
    std::optional<std::uint32_t> size;
    if (dimension) {
      size = ArraySize(context, dimension);
    } else if (i == 0 && open.implied) {
      size = open.implied;
    } else if (i == 0 && dimensions.size() == 1 &&
               (open.is_buffer || context.types[element].kind == TypeKind::kObject)) {
      // The number of elements is not a part of a stage's interface with another.
      size = context.program.is_interface_only ? 1 : 0;
    } else {
      context.Report(span, diag::ArrayWithoutSize);
    }
    is_broken = is_broken || !size;
    if (is_broken) continue;
    type = context.types.Array(type, *size);
    is_broken = IsTooLarge(context, type, span);
  }
  return is_broken ? context.types.Error() : type;
}

TypeId ResolveVarType(Context& context, const ast::VarDecl& var) {
  const TypeId element = ResolveType(context, var.type);
  const Span span = var.name ? var.name_span : context[var.type].span;
  if (element == context.types.Void()) {
    return context.FailType(span, diag::VoidValue,
                            fmt::format("`{}` of type `void`", context[var.name]));
  }
  if ((var.qualifiers & (ast::kSnorm | ast::kUnorm)) && !context.IsError(element) &&
      !(context[element].IsNumeric() && IsFloat(context[element].scalar))) {
    context.Report(span, diag::QualifierNeedsFloat,
                   var.qualifiers & ast::kSnorm ? "snorm" : "unorm", context.TypeName(element));
  }
  // fxc X3077
  const TypeKind kind = context[element].kind;
  if ((var.qualifiers & (ast::kRowMajor | ast::kColumnMajor)) &&
      (kind == TypeKind::kScalar || kind == TypeKind::kVector || kind == TypeKind::kObject)) {
    context.Report(span, diag::QualifierWithoutEffect,
                   var.qualifiers & ast::kRowMajor ? "row_major" : "column_major",
                   fmt::format("`{}`, which is not a matrix", context.TypeName(element)));
  }
  if ((var.qualifiers & ast::kGloballyCoherent) &&
      !(kind == TypeKind::kObject && IsWritable(context[element].object))) {
    context.Report(span, diag::QualifierWithoutEffect, "globallycoherent",
                   fmt::format("`{}`, which the shader cannot write", context.TypeName(element)));
  }
  const bool is_implied = !var.dimensions.empty() && !context[var.dimensions][0];
  std::optional<std::uint32_t> implied;
  if (is_implied && var.init && !context.IsError(element)) {
    List<ast::ExprId> inner = var.dimensions;
    ++inner.begin;
    --inner.size;
    const TypeId row = ArrayOf(context, element, inner, span);
    if (context.IsError(row)) return row;
    implied = ImpliedCount(context, var.init, row);
    if (!implied) return context.types.Error();
  }
  const TypeId type =
      ArrayOf(context, element, var.dimensions, span, {implied, IsBufferObject(context, var)});
  return type == element ? type : WithoutString(context, type, var);
}

TypeId WithoutString(Context& context, TypeId type, const ast::VarDecl& var) {
  if (context.types.Innermost(type) != context.types.String()) return type;
  return context.FailType(var.name ? var.name_span : context[var.type].span, diag::StringUsed,
                          context[var.name]);
}

bool IsRowMajor(const Context& context, ast::Qualifiers qualifiers) {
  if (qualifiers & ast::kRowMajor) return true;
  if (qualifiers & ast::kColumnMajor) return false;
  if (qualifiers & ast::kPackRowMajor) return true;
  if (qualifiers & ast::kPackColumnMajor) return false;
  return context.options.packing == MatrixPacking::kRowMajor;
}

ast::Qualifiers QualifiersOf(Context& context, const ast::VarDecl& var) {
  ast::TypeId of = var.type;
  return WithAliases(context, var.qualifiers, of);
}

bool IsPatch(Context& context, const ast::VarDecl& var) { return !PatchName(context, var).empty(); }

std::string_view PatchName(Context& context, const ast::VarDecl& var) {
  ast::TypeId of = var.type;
  WithAliases(context, var.qualifiers, of);
  return NamesPatch(context, of) ? context[context[of].name.name] : std::string_view();
}

ast::Qualifiers ElementQualifiersOf(Context& context, const ast::VarDecl& var) {
  ast::TypeId of = var.type;
  const ast::Qualifiers outer = WithAliases(context, var.qualifiers, of);
  if (context[of].arguments.empty()) return outer;
  ast::ExprId element = context[context[of].arguments][0];
  while (const auto* array = context.GetIf<ast::IndexExpr>(element)) element = array->base;
  const auto* type = context.GetIf<ast::TypeExpr>(element);
  if (!type) return outer;
  of = type->type;
  return WithAliases(context, (outer & ~kMajority) | type->qualifiers, of);
}

}  // namespace clipc::check
