// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/check/checker.h"

// HLSL 2021 templates. An instance is a scope in which the parameters have names, and a copy of the
// declaration that is looked up there. Arguments are kept as numbers: a type's id, or the 32 bits
// of a value.
namespace clipc {
namespace {

constexpr std::uint64_t kUnknown = ~std::uint64_t{0};
constexpr std::size_t kMaxInstances = 4096;
constexpr std::uint32_t kUnderWay =
    ~std::uint32_t{0};  // the members of the instance are being looked at

}  // namespace

// Reads S<...>'s arguments behind those that are `found` already; defaults stand in for missing
// ones. False after an error, or when an argument is missing.
bool Checker::ReadTemplateArguments(List<ast::TemplateParameter> parameters,
                                    List<ast::ExprId> arguments,
                                    std::vector<std::uint64_t>& found) {
  for (std::uint32_t i = 0; i < arguments.size && i < parameters.size; ++i) {
    const ast::TemplateParameter& parameter = file_.template_parameters[parameters][i];
    const ast::ExprId argument = file_.expr_lists[arguments][i];
    if (parameter.is_type) {
      const ir::TypeId type = TypeArgument(argument);
      if (type == program_.types.Error()) return false;
      found[i] = type.index;
    } else {
      const auto value = ConstantInteger(argument);
      if (!value) return false;
      found[i] = static_cast<std::uint32_t>(*value);
    }
  }
  return true;
}

// A scope with the parameters' names. Parameters without an argument get their default; none when
// there is no default.
ScopeId Checker::BindTemplate(List<ast::TemplateParameter> parameters, ScopeId parent,
                              std::uint32_t order, std::vector<std::uint64_t>& found) {
  const ScopeId scope = AddScope(ScopeKind::kTemplate, parent, {}, order);
  const ContextSwitch in(*this, {.scope = scope, .order = order, .local_floor = symbols_.size()});
  for (std::uint32_t i = 0; i < parameters.size; ++i) {
    const ast::TemplateParameter& parameter = file_.template_parameters[parameters][i];
    if (found[i] == kUnknown) {
      if (!parameter.default_value) return {};
      if (parameter.is_type)
        found[i] = TypeArgument(parameter.default_value).index;
      else
        found[i] = static_cast<std::uint32_t>(ConstantInteger(parameter.default_value).value_or(0));
    }
    const SymbolKind kind = parameter.is_type ? SymbolKind::kType : SymbolKind::kTemplateValue;
    const SymbolId symbol = Declare(kind, scope, parameter.name, {}, parameter.span);
    symbols_[symbol].value = static_cast<std::uint32_t>(found[i]);
    symbols_[symbol].resolution = Resolution::kDone;
    if (!parameter.is_type) symbols_[symbol].owner = ResolveType(parameter.type).index;
  }
  return scope;
}

std::string Checker::InstanceKey(ast::DeclId decl, ScopeId scope, ir::TypeId self,
                                 const std::vector<std::uint64_t>& found) {
  std::string key = fmt::format("{},{},{}", decl.index, scope.index, self.index);
  for (std::uint64_t argument : found) key += fmt::format(",{}", argument);
  return key;
}

// S<float>; nothing when `id` is no template.
std::optional<ir::TypeId> Checker::InstantiateStruct(SymbolId id, const ast::Type& type) {
  const Symbol symbol = symbols_[id];
  const auto* decl =
      symbol.decl ? std::get_if<ast::StructDecl>(&file_.decls[symbol.decl].node) : nullptr;
  if (!decl || !decl->is_template) return std::nullopt;
  // Inside its own body the bare name means this instance.
  if (!type.has_arguments) {
    for (ScopeId scope = context_.scope; scope; scope = scopes_[scope].parent) {
      const bool is_own =
          scopes_[scope].kind == ScopeKind::kStruct &&
          struct_infos_[program_.types[scopes_[scope].self].structure.index].decl == symbol.decl;
      if (is_own) return scopes_[scope].self;
    }
  }
  const Depth depth(*this, type.span, kDeclarationWeight);
  std::vector<std::uint64_t> found(decl->template_parameters.size, kUnknown);
  if (!depth.ok() || !ReadTemplateArguments(decl->template_parameters, type.arguments, found))
    return program_.types.Error();
  if (type.arguments.size > decl->template_parameters.size) {
    diagnostics_.Report(type.span, diag::TooManyTypeArguments, Text(decl->name),
                        decl->template_parameters.size);
    return program_.types.Error();
  }
  // The struct's own name is known inside it.
  const bool is_in_namespace = symbol.scope && scopes_[symbol.scope].kind == ScopeKind::kNamespace;
  const std::uint32_t order = is_in_namespace ? id.index + 1 : OrderOf(id);
  const ScopeId scope = BindTemplate(decl->template_parameters, symbol.scope, order, found);
  if (!scope) {
    diagnostics_.Report(type.span, diag::MissingTypeArgument, Text(decl->name));
    return program_.types.Error();
  }
  const auto [slot, is_new] =
      instances_.try_emplace(InstanceKey(symbol.decl, symbol.scope, {}, found), kUnderWay);
  if (!is_new && slot->second == kUnderWay) {
    diagnostics_.Report(type.span, diag::TypeContainsItself, Text(decl->name));
    return program_.types.Error();
  }
  if (!is_new) return ir::TypeId{slot->second};
  if (instances_.size() > kMaxInstances) {
    diagnostics_.Report(type.span, diag::TooManyInstances, kMaxInstances);
    return program_.types.Error();
  }
  std::uint32_t& result = slot->second;
  const SymbolId instance = Declare(SymbolKind::kType, scope, {}, symbol.decl, decl->name_span);
  const ir::TypeId made = ResolveStruct(symbol.decl, instance, scope, order);
  result = made.index;
  return made;
}

// What `pattern`, the type of a parameter, says of the template's arguments when a value of `type`
// is passed.
void Checker::Deduce(ast::TypeId pattern_id, ir::TypeId type, const ast::FunctionDecl& decl,
                     std::vector<std::uint64_t>& found) {
  const ast::Type& pattern = file_.types[pattern_id];
  const ir::Type given = program_.types[type];
  const auto parameter_of = [&](Name name) -> std::optional<std::uint32_t> {
    for (std::uint32_t i = 0; i < decl.template_parameters.size; ++i) {
      if (file_.template_parameters[decl.template_parameters][i].name == name) return i;
    }
    return std::nullopt;
  };
  if (const auto i = parameter_of(pattern.name.name); i && !pattern.has_arguments) {
    if (found[*i] == kUnknown) found[*i] = type.index;
    return;
  }
  // vector<T, N>, matrix<T, R, C>
  const std::string_view text = Text(pattern.name.name);
  if ((text != "vector" && text != "matrix") || !given.IsNumeric()) return;
  const std::uint64_t parts[] = {program_.types.Make(given.scalar).index,
                                 text == "vector" ? given.columns : given.rows, given.columns};
  for (std::uint32_t a = 0; a < pattern.arguments.size && a < 3; ++a) {
    const ast::Expr& argument = file_.exprs[file_.expr_lists[pattern.arguments][a]];
    Name name;
    if (const auto* written = std::get_if<ast::TypeExpr>(&argument.node))
      name = file_.types[written->type].name.name;
    if (const auto* used = std::get_if<ast::NameExpr>(&argument.node)) name = used->name.name;
    const auto i = name ? parameter_of(name) : std::nullopt;
    if (i && found[*i] == kUnknown) found[*i] = parts[a];
  }
}

// The instance of a function template that a call asks for; none when the arguments do not say
// enough.
FunctionInfoId Checker::InstantiateFunction(SymbolId id, ir::TypeId self,
                                            List<ast::ExprId> explicit_arguments,
                                            std::span<const ir::ExprId> arguments) {
  const Symbol symbol = symbols_[id];
  const auto& decl = std::get<ast::FunctionDecl>(file_.decls[symbol.decl].node);
  std::vector<std::uint64_t> found(decl.template_parameters.size, kUnknown);
  if (explicit_arguments.size > found.size() || arguments.size() > decl.parameters.size) return {};
  if (!ReadTemplateArguments(decl.template_parameters, explicit_arguments, found)) return {};
  for (std::uint32_t i = 0; i < arguments.size(); ++i) {
    const ast::DeclId parameter = file_.decl_lists[decl.parameters][i];
    Deduce(std::get<ast::VarDecl>(file_.decls[parameter].node).type, TypeIdOf(arguments[i]), decl,
           found);
  }
  const std::uint32_t order = OrderOf(id);
  const ScopeId scope = BindTemplate(decl.template_parameters, symbol.scope, order, found);
  if (!scope) return {};
  const auto [slot, is_new] =
      instances_.try_emplace(InstanceKey(symbol.decl, symbol.scope, self, found),
                             static_cast<std::uint32_t>(functions_.size()));
  if (!is_new) return FunctionInfoId{slot->second};
  if (instances_.size() > kMaxInstances) {
    diagnostics_.Report(decl.name_span, diag::TooManyInstances, kMaxInstances);
    return {};
  }
  FunctionInfo info;
  info.decl = symbol.decl;
  info.scope = scope;
  const bool is_method = scopes_[symbol.scope].kind == ScopeKind::kStruct;
  info.order = is_method || order == ~0u ? order : order + 1;
  info.declared = is_method ? 0 : id.index;
  info.is_instance = true;
  if (is_method && !(decl.qualifiers & ast::kStatic))
    info.self = self ? self : scopes_[symbol.scope].self;
  functions_.push_back(info);
  const FunctionInfoId result{slot->second};
  ResolveSignature(result);
  return result;
}

}  // namespace clipc
