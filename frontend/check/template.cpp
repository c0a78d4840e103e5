// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/template.h"

#include <algorithm>
#include <utility>

#include "frontend/check/function.h"
#include "frontend/check/global.h"
#include "frontend/check/partial_order.h"
#include "frontend/check/scope.h"
#include "frontend/check/struct.h"
#include "frontend/check/type.h"
#include "frontend/check/type_names.h"
#include "frontend/check/value.h"
#include "frontend/typing/constant.h"

namespace clipc::check {
namespace {

constexpr std::uint64_t kUnknown = ~std::uint64_t{0};

constexpr std::size_t kMaxInstances = 4096;
constexpr std::uint32_t kUnderWay =
    ~std::uint32_t{0};  // the value of an instance whose members are being resolved

// The argument of a template as a number; nullopt after an error, which was reported.
std::optional<std::uint32_t> ReadArgument(Context& context, const ast::TemplateParameter& parameter,
                                          ast::ExprId argument) {
  if (parameter.is_type) {
    const TypeId type = TypeArgument(context, argument);
    return context.IsError(type) ? std::nullopt : std::optional(type.index);
  }
  const auto value = ConstantInteger(context, argument);
  return value ? std::optional(static_cast<std::uint32_t>(*value)) : std::nullopt;
}

// Reads the arguments that are written, S<...>, into `found`. Returns false after an error, which
// was reported.
bool ReadTemplateArguments(Context& context, List<ast::TemplateParameter> parameters,
                           List<ast::ExprId> arguments, std::vector<std::uint64_t>& found) {
  for (std::uint32_t i = 0; i < arguments.size && i < parameters.size; ++i) {
    const auto value = ReadArgument(context, context[parameters][i], context[arguments][i]);
    if (!value) return false;
    found[i] = *value;
  }
  return true;
}

// Makes a scope with the names of the parameters. A parameter without an argument gets its default;
// returns none if it does not have one.
ScopeId BindTemplate(Context& context, List<ast::TemplateParameter> parameters, ScopeId parent,
                     std::uint32_t order, std::vector<std::uint64_t>& found) {
  const ScopeId scope = context.names.AddScope(ScopeKind::kTemplate, parent, {}, order);
  const ViewSwitch in(context, context.ViewFrom(scope, order));
  for (std::uint32_t i = 0; i < parameters.size; ++i) {
    const ast::TemplateParameter& parameter = context[parameters][i];
    if (found[i] == kUnknown) {
      if (!parameter.default_value) return {};
      found[i] = ReadArgument(context, parameter, parameter.default_value)
                     .value_or(parameter.is_type ? context.types.Error().index : 0);
    }
    const SymbolKind kind = parameter.is_type ? SymbolKind::kType : SymbolKind::kTemplateValue;
    const SymbolId symbol = context.names.Declare(kind, scope, parameter.name, {}, parameter.span);
    context[symbol].Resolve(static_cast<std::uint32_t>(found[i]));
    if (!parameter.is_type) context[symbol].owner = ResolveType(context, parameter.type).index;
  }
  return scope;
}

std::string InstanceKey(ast::DeclId decl, ScopeId scope, TypeId self,
                        const std::vector<std::uint64_t>& found) {
  std::string key = fmt::format("{},{},{}", decl.index, scope.index, self.index);
  for (std::uint64_t argument : found) key += fmt::format(",{}", argument);
  return key;
}

bool DeduceParts(Context& context, const ast::Type& pattern, TypeId type,
                 List<ast::TemplateParameter> parameters, std::vector<std::uint64_t>& found);

// Adds to `found` the arguments of the template that follow from passing a value of `type` to a
// parameter whose type is written as `pattern`. Returns false if it follows too that an argument is
// a type of other numbers than the one that was found before ([temp.deduct.type] of C++, clause 2).
bool Deduce(Context& context, ast::TypeId pattern_id, TypeId type,
            List<ast::TemplateParameter> parameters, std::vector<std::uint64_t>& found) {
  const ast::Type& pattern = context[pattern_id];
  const Type given = context[type];
  const auto parameter_of = [&](Name name) -> std::optional<std::uint32_t> {
    for (std::uint32_t i = 0; i < parameters.size; ++i) {
      if (context[parameters][i].name == name) return i;
    }
    return std::nullopt;
  };
  if (const auto i = parameter_of(pattern.name.name); i && !pattern.has_arguments) {
    if (found[*i] == kUnknown) found[*i] = type.index;
    const Type& before = context[TypeId{static_cast<std::uint32_t>(found[*i])}];
    return !before.IsNumeric() || !given.IsNumeric() || before.scalar == given.scalar;
  }
  // vector<T, N>, matrix<T, R, C>
  const std::string_view text = context[pattern.name.name];
  if (!given.IsNumeric()) return DeduceParts(context, pattern, type, parameters, found);
  if (text != "vector" && text != "matrix") return true;
  const std::uint64_t parts[] = {context.types.Make(given.scalar).index,
                                 text == "vector" ? given.columns : given.rows, given.columns};
  for (std::uint32_t a = 0; a < pattern.arguments.size && a < 3; ++a) {
    const ast::Expr& argument = context[context[pattern.arguments][a]];
    Name name;
    if (const auto* written = std::get_if<ast::TypeExpr>(&argument.node))
      name = context[written->type].name.name;
    if (const auto* used = std::get_if<ast::NameExpr>(&argument.node)) name = used->name.name;
    const auto i = name ? parameter_of(name) : std::nullopt;
    if (i && found[*i] == kUnknown) found[*i] = parts[a];
    if (i && a == 0 && found[*i] != parts[a]) return false;
  }
  return true;
}

// The same for a pattern Pair<T> or Texture2D<T>: from the arguments of an instance of that struct,
// or from the element of that object.
bool DeduceParts(Context& context, const ast::Type& pattern, TypeId type,
                 List<ast::TemplateParameter> parameters, std::vector<std::uint64_t>& found) {
  const Type given = context[type];
  if (given.kind == TypeKind::kObject && given.element && pattern.arguments.size > 0) {
    const std::string name = context.types.Name(type);
    const auto* element = context.GetIf<ast::TypeExpr>(context[pattern.arguments][0]);
    if (!element || name.substr(0, name.find('<')) != context[pattern.name.name]) return true;
    return Deduce(context, element->type, given.element, parameters, found);
  }
  const StructInfo* info = InfoOf(context, type);
  const SymbolId general = info ? Find(context, pattern.name, true) : SymbolId{};
  if (!general || context[general].decl != info->decl) return true;
  const auto& decl = context.Get<ast::StructDecl>(info->decl);
  const ScopeId bound = context[info->scope].parent;
  bool agrees = true;
  for (std::uint32_t i = 0; i < pattern.arguments.size && i < decl.template_parameters.size; ++i) {
    const ast::TemplateParameter& parameter = context[decl.template_parameters][i];
    const SymbolId symbol = context.names.FindIn(bound, parameter.name);
    if (!symbol) continue;
    const std::uint32_t value = context[symbol].value;
    const ast::ExprId argument = context[pattern.arguments][i];
    const auto* written = context.GetIf<ast::TypeExpr>(argument);
    if (parameter.is_type) {
      if (written)
        agrees = Deduce(context, written->type, TypeId{value}, parameters, found) && agrees;
      continue;
    }
    const auto* used = context.GetIf<ast::NameExpr>(argument);
    const Name name = used ? used->name.name : written ? context[written->type].name.name : Name{};
    for (std::uint32_t p = 0; name && p < parameters.size; ++p) {
      if (context[parameters][p].name != name) continue;
      if (found[p] == kUnknown) found[p] = value;
      agrees = agrees && found[p] == value;
    }
  }
  return agrees;
}

// A specialisation of a struct that fits the arguments of the template.
struct StructSpecialisation {
  ast::DeclId decl;
  std::vector<std::uint64_t> found;  // the arguments of its own parameters
};

// A struct template with the arguments that it is given.
struct StructTemplate {
  SymbolId symbol;
  const ast::StructDecl& decl;
  std::uint32_t order;
  const std::vector<std::uint64_t>& given;
};

// Whether the arguments of the specialisation are those that are given. Then `found` has what its
// own parameters stand for.
bool Fits(Context& context, const StructTemplate& general, const ast::StructDecl& special,
          std::vector<std::uint64_t>& found) {
  const std::vector<std::uint64_t>& given = general.given;
  const List<ast::TemplateParameter> parameters = general.decl.template_parameters;
  const List<ast::TemplateParameter> own = special.template_parameters;
  const List<ast::ExprId> written = special.template_arguments;
  for (std::uint32_t i = 0; i < written.size && i < given.size(); ++i) {
    const ast::Expr& argument = context[context[written][i]];
    if (const auto* type = std::get_if<ast::TypeExpr>(&argument.node)) {
      if (context[parameters][i].is_type)
        Deduce(context, type->type, TypeId{static_cast<std::uint32_t>(given[i])}, own, found);
    } else if (const auto* name = std::get_if<ast::NameExpr>(&argument.node)) {
      for (std::uint32_t p = 0; p < own.size; ++p) {
        const bool is_it = context[own][p].name == name->name.name;
        if (is_it && found[p] == kUnknown) found[p] = given[i];
      }
    }
  }
  if (std::ranges::find(found, kUnknown) != found.end()) return false;
  const ScopeId scope =
      BindTemplate(context, own, context[general.symbol].scope, general.order, found);
  const ViewSwitch in(context, context.ViewFrom(scope, general.order));
  std::vector<std::uint64_t> meant(given.size(), kUnknown);
  if (!ReadTemplateArguments(context, parameters, written, meant)) return false;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (i < written.size && meant[i] != given[i]) return false;
  }
  return true;
}

// The specialisation that has the arguments: the one without parameters of its own, else the most
// special one; none: the template itself.
std::optional<StructSpecialisation> SpecialisationOf(Context& context,
                                                     const StructTemplate& general, Span span) {
  const auto known = context.structs.specialisations.find(general.symbol.index);
  if (known == context.structs.specialisations.end()) return std::nullopt;
  std::vector<StructSpecialisation> fitting;
  for (const ast::DeclId decl : known->second) {
    const auto& special = context.Get<ast::StructDecl>(decl);
    std::vector<std::uint64_t> found(special.template_parameters.size, kUnknown);
    if (!Fits(context, general, special, found)) continue;
    if (found.empty()) return StructSpecialisation{decl, found};
    fitting.push_back({decl, found});
  }
  if (fitting.empty()) return std::nullopt;
  const auto special = [&](const StructSpecialisation& one) -> const ast::StructDecl& {
    return context.Get<ast::StructDecl>(one.decl);
  };
  for (const StructSpecialisation& one : fitting) {
    const bool is_most_special = std::ranges::all_of(fitting, [&](const auto& other) {
      return other.decl == one.decl || (IsAtLeastAsSpecial(context, special(one), special(other)) &&
                                        !IsAtLeastAsSpecial(context, special(other), special(one)));
    });
    if (is_most_special) return one;
  }
  context.Report(span, diag::AmbiguousSpecialisation, context[general.decl.name]);
  return fitting.front();
}

// The specialisation of the function template `id` that has these arguments; none: the template
// itself is meant.
SymbolId SpecialisationOf(Context& context, SymbolId id, const std::vector<std::uint64_t>& given) {
  const ast::FunctionDecl& general = DeclOf(context, id);
  const auto known = context.functions.specialisations.find(general.name.index);
  if (known == context.functions.specialisations.end()) return {};
  const ScopeId parent = context[id].scope;
  SymbolId result;
  for (const SymbolId special : known->second) {
    const ast::FunctionDecl& decl = DeclOf(context, special);
    if (context[special].scope != parent || decl.parameters.size != general.parameters.size)
      continue;
    const std::uint32_t order = OrderOf(context, special);
    const ViewSwitch in(context, context.ViewFrom(parent, order));
    std::vector<std::uint64_t> meant(given.size(), kUnknown);
    if (!ReadTemplateArguments(context, general.template_parameters, decl.template_arguments,
                               meant))
      continue;
    for (std::uint32_t i = 0; i < decl.parameters.size; ++i) {
      const auto& pattern = context.Get<ast::VarDecl>(context[general.parameters][i]);
      const auto& own = context.Get<ast::VarDecl>(context[decl.parameters][i]);
      Deduce(context, pattern.type, ResolveVarType(context, own), general.template_parameters,
             meant);
    }
    if (!BindTemplate(context, general.template_parameters, parent, order, meant)) continue;
    if (meant == given && (decl.body || !result)) result = special;
  }
  return result;
}

// Whether there may be the instance that was just added. The first one that may not be is reported.
bool MayInstantiate(Context& context, Span where) {
  Overloads& functions = context.functions;
  if (functions.instances.size() <= kMaxInstances) return true;
  if (!std::exchange(functions.has_too_many_instances, true))
    context.Report(where, diag::TooManyInstances, kMaxInstances);
  return false;
}

}  // namespace

std::optional<TypeId> InstantiateStruct(Context& context, SymbolId id, const ast::Type& type) {
  const Symbol symbol = context[id];
  const auto* decl = symbol.decl ? context.GetIf<ast::StructDecl>(symbol.decl) : nullptr;
  if (!decl || !decl->is_template) return std::nullopt;
  // Inside its own body the bare name means this instance.
  if (!type.has_arguments) {
    for (ScopeId scope = context.view.scope; scope; scope = context[scope].parent) {
      if (context[scope].kind != ScopeKind::kStruct) continue;
      const ast::DeclId around =
          context.structs.infos[context[context[scope].self].structure.index].decl;
      if (around == symbol.decl || context.structs.IsSpecialisation(id, around))
        return context[scope].self;
    }
  }
  const RecursionGuard guard(context, type.span, RecursionGuard::kDeclaration);
  std::vector<std::uint64_t> found(decl->template_parameters.size, kUnknown);
  if (!guard.ok() ||
      !ReadTemplateArguments(context, decl->template_parameters, type.arguments, found))
    return context.types.Error();
  if (type.arguments.size > decl->template_parameters.size) {
    return context.FailType(type.span, diag::TooManyTypeArguments, context[decl->name],
                            decl->template_parameters.size);
  }
  // The struct's own name is known inside it.
  const bool is_in_namespace = symbol.scope && context[symbol.scope].kind == ScopeKind::kNamespace;
  const std::uint32_t order = is_in_namespace ? id.index + 1 : OrderOf(context, id);
  ScopeId scope = BindTemplate(context, decl->template_parameters, symbol.scope, order, found);
  if (!scope) {
    return context.FailType(type.span, diag::MissingTypeArgument, context[decl->name]);
  }
  ast::DeclId meant = symbol.decl;
  if (const auto special = SpecialisationOf(context, {id, *decl, order, found}, type.span)) {
    meant = special->decl;
    found = special->found;
    scope = BindTemplate(context, context.Get<ast::StructDecl>(meant).template_parameters,
                         symbol.scope, order, found);
  }
  const auto [slot, is_new] = context.functions.instances.try_emplace(
      InstanceKey(meant, symbol.scope, {}, found), kUnderWay);
  if (!is_new && slot->second == kUnderWay) {
    return context.FailType(type.span, diag::TypeContainsItself, context[decl->name]);
  }
  if (!is_new) return TypeId{slot->second};
  if (!MayInstantiate(context, type.span)) {
    context.functions.instances.erase(slot);
    return context.types.Error();
  }
  std::uint32_t& result = slot->second;
  const SymbolId instance =
      context.names.Declare(SymbolKind::kType, scope, {}, meant, decl->name_span);
  const TypeId made = ResolveStruct(context, meant, instance, scope, order);
  result = made.index;
  return made;
}

std::optional<TypeId> InstantiateAlias(Context& context, SymbolId id, const ast::Type& type) {
  const Symbol symbol = context[id];
  const auto* alias = symbol.decl ? context.GetIf<ast::TypedefDecl>(symbol.decl) : nullptr;
  if (!alias || !alias->is_template) return std::nullopt;
  const RecursionGuard guard(context, type.span, RecursionGuard::kDeclaration);
  const List<ast::TemplateParameter> parameters = alias->template_parameters;
  std::vector<std::uint64_t> found(parameters.size, kUnknown);
  if (!guard.ok() || !ReadTemplateArguments(context, parameters, type.arguments, found))
    return context.types.Error();
  if (type.arguments.size > parameters.size)
    return context.FailType(type.span, diag::TooManyTypeArguments, context[alias->name],
                            parameters.size);
  const std::uint32_t order = OrderOf(context, id);
  const ScopeId scope = BindTemplate(context, parameters, symbol.scope, order, found);
  if (!scope) return context.FailType(type.span, diag::MissingTypeArgument, context[alias->name]);
  const ViewSwitch in(context, context.ViewFrom(scope, order));
  return ArrayOf(context, ResolveType(context, alias->type), alias->dimensions, alias->name_span);
}

namespace {

constexpr Scalar kFloats[] = {Scalar::kFloat, Scalar::kHalf, Scalar::kDouble, Scalar::kMin16Float,
                              Scalar::kMin10Float};

bool IsLiteral(const Program& program, ExprId expr) {
  if (const auto* unary = As<Unary>(program, expr)) expr = unary->operand;
  return As<Literal>(program, expr) || IsLiteralList(program, expr);
}

// The same for a parameter `T values[N]`: an array does not become a pointer, as it would in C++.
bool DeduceParameter(Context& context, const ast::VarDecl& parameter, TypeId type,
                     List<ast::TemplateParameter> parameters, std::vector<std::uint64_t>& found) {
  for (const ast::ExprId dimension : context[parameter.dimensions]) {
    const Type given = context[type];
    if (given.kind != TypeKind::kArray) return true;
    type = given.element;
    const auto* used = dimension ? context.GetIf<ast::NameExpr>(dimension) : nullptr;
    for (std::uint32_t i = 0; used && i < parameters.size; ++i) {
      if (context[parameters][i].name != used->name.name) continue;
      if (found[i] == kUnknown) found[i] = given.count;
      if (found[i] != given.count) return false;
    }
  }
  return Deduce(context, parameter.type, type, parameters, found);
}

// Adds to `found` what follows from the arguments of a call. A literal becomes whatever type of
// numbers the other arguments agree on. Returns false where arguments do not agree.
bool DeduceFromArguments(Context& context, const ast::FunctionDecl& decl, ExprSpan arguments,
                         std::vector<std::uint64_t>& found) {
  const auto deduce = [&](std::uint32_t i, std::vector<std::uint64_t>& into) {
    const auto& parameter = context.Get<ast::VarDecl>(context[decl.parameters][i]);
    return DeduceParameter(context, parameter, context.TypeIdOf(arguments[i]),
                           decl.template_parameters, into);
  };
  bool agrees = true;
  for (std::uint32_t i = 0; i < arguments.size(); ++i)
    if (!IsLiteral(context.program, arguments[i])) agrees = deduce(i, found) && agrees;
  const std::vector<std::uint64_t> before = found;
  // Whether a literal with a point becomes a whole number, which is not what the template is called
  // with: 2.5 of larger(i, 2.5).
  const auto loses = [&](std::uint32_t i) {
    const TypeId type = context.TypeIdOf(arguments[i]);
    if (!context[type].IsNumeric() || !IsFloat(context[type].scalar)) return false;
    return std::ranges::none_of(kFloats, [&](Scalar kind) {
      std::vector<std::uint64_t> own = before;
      const auto& parameter = context.Get<ast::VarDecl>(context[decl.parameters][i]);
      return Deduce(context, parameter.type, context.types.WithScalar(type, kind),
                    decl.template_parameters, own);
    });
  };
  for (std::uint32_t i = 0; i < arguments.size(); ++i) {
    if (!IsLiteral(context.program, arguments[i])) continue;
    std::vector<std::uint64_t> own = before;
    agrees = agrees && !loses(i);
    deduce(i, own);
    for (std::size_t p = 0; p < own.size(); ++p) {
      if (before[p] != kUnknown || own[p] == kUnknown) continue;
      agrees = agrees && (found[p] == kUnknown || found[p] == own[p]);
      found[p] = own[p];
    }
  }
  return agrees;
}

}  // namespace

FunctionInfoId InstantiateFunction(Context& context, SymbolId id, TypeId self,
                                   List<ast::ExprId> explicit_arguments, ExprSpan arguments) {
  const Symbol symbol = context[id];
  const ast::FunctionDecl& decl = DeclOf(context, id);
  std::vector<std::uint64_t> found(decl.template_parameters.size, kUnknown);
  if (explicit_arguments.size > found.size() || arguments.size() > decl.parameters.size) return {};
  if (!ReadTemplateArguments(context, decl.template_parameters, explicit_arguments, found))
    return {};
  if (!DeduceFromArguments(context, decl, arguments, found) && explicit_arguments.empty())
    return {};
  const ScopeId scope =
      BindTemplate(context, decl.template_parameters, symbol.scope, OrderOf(context, id), found);
  if (!scope) return {};
  const SymbolId special = SpecialisationOf(context, id, found);
  const SymbolId meant = special ? special : id;
  const auto [slot, is_new] = context.functions.instances.try_emplace(
      InstanceKey(context[meant].decl, symbol.scope, self, found), context.functions.infos.size());
  if (!is_new) return FunctionInfoId{slot->second};
  if (!MayInstantiate(context, decl.name_span)) {
    context.functions.instances.erase(slot);
    return {};
  }
  const FunctionInfoId result = AddFunction(context, meant, self, special ? symbol.scope : scope);
  // A specialisation is found where its template is.
  context[result].declared = std::min(context[result].declared, id.index);
  ResolveSignature(context, result);
  return result;
}

}  // namespace clipc::check
