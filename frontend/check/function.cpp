// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/function.h"

#include <algorithm>

#include "frontend/check/enum_class.h"
#include "frontend/check/scope.h"
#include "frontend/check/self.h"
#include "frontend/check/type.h"

namespace clipc::check {
namespace {

// The record of a function, or of a method for objects of type `self`; made if need be.
FunctionInfoId InfoOfFunction(Context& context, SymbolId id, TypeId self) {
  // A static method is one function for all structs that derive from its own.
  if (DeclOf(context, id).qualifiers & ast::kStatic) self = {};
  FunctionInfoId& known = context.functions.of_symbol[Overloads::KeyOf(id, self)];
  if (!known) known = AddFunction(context, id, self);
  return known;
}

void AddParameter(Context& context, const ast::VarDecl& var, ast::DeclId id, FunctionInfo& info,
                  KeptVector<Parameter>& parameters) {
  Parameter parameter;
  parameter.decl = id;
  parameter.type = WithoutString(context, ResolveVarType(context, var), var);
  parameter.enumeration = EnumOf(context, var);
  const bool out = (var.qualifiers & ast::kOut) != 0;
  const bool in = (var.qualifiers & ast::kIn) != 0;
  parameter.storage = !out ? Storage::kIn : in ? Storage::kInOut : Storage::kOut;
  if (context.IsError(parameter.type)) info.is_broken = true;
  if (var.init) {
    parameter.with_default = id;
  } else {
    info.required = static_cast<std::uint32_t>(parameters.size()) + 1;
  }
  parameters.push_back(parameter);
}

// Finds the definition of a function that its struct or namespace only declares, `float S::f()
// {...}`, if there is one.
void FindOutOfLine(Context& context, FunctionInfo& info) {
  const Name name = DeclOf(context, info).name;
  for (ast::DeclId id : context.functions.out_of_line.Of(context, name, info.scope)) {
    const auto& decl = context.Get<ast::FunctionDecl>(id);
    if (decl.parameters.size != info.parameters.size || !decl.body) continue;
    bool same = true;
    std::vector<Parameter> parameters(context[info.parameters].begin(),
                                      context[info.parameters].end());
    const ViewSwitch in_struct(context, context.ViewFrom(info.scope, info.order));
    for (std::uint32_t i = 0; i < decl.parameters.size && same; ++i) {
      parameters[i].decl = context[decl.parameters][i];
      same = ResolveVarType(context, context.Get<ast::VarDecl>(parameters[i].decl)) ==
             parameters[i].type;
    }
    if (!same) continue;
    info.decl = id;
    info.order = ~0u;  // its body comes after what the struct or namespace has
    info.parameters = context.functions.parameters.Add(std::span<const Parameter>(parameters));
    return;
  }
}

// A text that is the same for the same parameters.
std::string ParameterKey(const Context& context, const FunctionInfo& info) {
  std::string key;
  for (const Parameter& parameter : context[info.parameters]) {
    key += fmt::format("{}:{},", static_cast<int>(parameter.storage), parameter.type.index);
    if (parameter.enumeration) key += fmt::format("{};", parameter.enumeration.index);
  }
  return key;
}

// Merges a prototype and its definition, or two prototypes, into one overload and returns it. The
// one with the body is kept, and takes over the default arguments of the other.
FunctionInfoId MergeOverloads(Context& context, FunctionInfoId known, FunctionInfoId added) {
  FunctionInfo& info = context[added];
  FunctionInfo& other = context[known];
  const ast::FunctionDecl& decl = DeclOf(context, info);
  const ast::FunctionDecl& other_decl = DeclOf(context, other);
  if (decl.body && other_decl.body) {
    context.Report(decl.name_span, diag::FunctionRedefinition, SignatureText(context, info))
        .Note(other_decl.name_span, diag::DeclaredHere, context[decl.name]);
  } else if (info.return_type != other.return_type) {
    context.diagnostics
        .Report(decl.name_span, diag::ReturnTypeDiffers, SignatureText(context, info),
                context.TypeName(info.return_type), context.TypeName(other.return_type))
        .Note(other_decl.name_span, diag::DeclaredHere, context[decl.name]);
  }
  FunctionInfo& kept = decl.body ? info : other;
  const FunctionInfo& dropped = decl.body ? other : info;
  for (std::uint32_t i = 0; i < kept.parameters.size; ++i) {
    Parameter& parameter = context[kept.parameters][i];
    if (!parameter.with_default)
      parameter.with_default = context[dropped.parameters][i].with_default;
  }
  kept.required = std::min(kept.required, dropped.required);
  kept.declared = std::min(kept.declared, dropped.declared);
  return decl.body ? added : known;
}

}  // namespace

const ast::FunctionDecl& DeclOf(const Context& context, const FunctionInfo& info) {
  return context.Get<ast::FunctionDecl>(info.decl);
}

const ast::FunctionDecl& DeclOf(const Context& context, SymbolId function) {
  return context.Get<ast::FunctionDecl>(context[function].decl);
}

FunctionInfoId AddFunction(Context& context, SymbolId id, TypeId self, ScopeId instance) {
  const Symbol& symbol = context[id];
  const Scope& scope = context[symbol.scope];
  const bool is_method = scope.kind == ScopeKind::kStruct;
  FunctionInfo info;
  info.decl = symbol.decl;
  info.scope = instance ? instance : symbol.scope;
  info.order = is_method ? scope.order : id.index + 1;
  info.declared = is_method ? 0 : id.index;
  info.is_instance = static_cast<bool>(instance);
  if (is_method && !(DeclOf(context, id).qualifiers & ast::kStatic))
    info.self = self ? self : scope.self;
  return context.functions.infos.Add(info);
}

void ResolveSignature(Context& context, FunctionInfoId id) {
  FunctionInfo& info = context[id];
  if (info.is_resolved) return;
  info.is_resolved = true;
  const ViewSwitch in(context, context.ViewFrom(info.scope, info.order));
  const ast::FunctionDecl& decl = DeclOf(context, info);
  info.return_type = ArrayOf(context, ResolveType(context, decl.return_type),
                             decl.return_dimensions, decl.name_span);
  if (context.types.Innermost(info.return_type) == context.types.String())
    info.return_type = context.FailType(decl.name_span, diag::StringUsed, context[decl.name]);
  if (context.IsError(info.return_type)) info.is_broken = true;
  KeptVector<Parameter> parameters;
  parameters.reserve(decl.parameters.size);
  for (ast::DeclId parameter : context[decl.parameters]) {
    AddParameter(context, context.Get<ast::VarDecl>(parameter), parameter, info, parameters);
  }
  info.parameters = context.functions.parameters.Add(std::span<const Parameter>(parameters));
  const bool has_owner = static_cast<bool>(context[info.scope].parent);
  if (has_owner && !decl.body) FindOutOfLine(context, info);
  if (info.self) info.changes_self = MayChangeSelf(context, DeclOf(context, info), info.scope);
}

bool SameParameters(const Context& context, const FunctionInfo& a, const FunctionInfo& b) {
  return std::ranges::equal(
      context[a.parameters], context[b.parameters], [](const Parameter& x, const Parameter& y) {
        return x.type == y.type && x.storage == y.storage && x.enumeration == y.enumeration;
      });
}

const KeptVector<FunctionInfoId>& OverloadsOf(Context& context, SymbolId first, TypeId self) {
  const Symbol& symbol = context[first];
  const SymbolId newest = context.names.NewestIn(symbol.scope, symbol.name);
  const std::uint64_t key = Overloads::KeyOf(newest, self);
  if (const auto known = context.functions.overloads.find(key);
      known != context.functions.overloads.end())
    return known->second;
  KeptVector<SymbolId> symbols;
  for (SymbolId id = newest; id; id = context[id].older) {
    if (context[id].kind != SymbolKind::kFunction) continue;
    if (DeclOf(context, id).is_template) continue;
    symbols.push_back(id);
  }
  KeptVector<FunctionInfoId> overloads;
  std::unordered_map<std::string, std::size_t> by_parameters;
  for (auto id = symbols.rbegin(); id != symbols.rend(); ++id) {
    const FunctionInfoId added = InfoOfFunction(context, *id, self);
    ResolveSignature(context, added);
    if (symbols.size() == 1) {
      overloads.push_back(added);
      break;
    }
    const std::string parameters = context[added].is_broken ? fmt::format("broken {}", added.index)
                                                            : ParameterKey(context, context[added]);
    const auto [slot, is_new] = by_parameters.emplace(parameters, overloads.size());
    if (is_new)
      overloads.push_back(added);
    else
      overloads[slot->second] = MergeOverloads(context, overloads[slot->second], added);
  }
  return context.functions.overloads.emplace(key, std::move(overloads)).first->second;
}

SymbolId FindFunction(Context& context, const ast::QualifiedName& name) {
  View view = context.view;
  view.order = ~0u;
  view.local_floor = ~0u;
  const ViewSwitch in(context, view);
  const SymbolId symbol = Find(context, name);
  return symbol && context[symbol].kind == SymbolKind::kFunction ? symbol : SymbolId{};
}

void DeclarePrototype(Context& context, const ast::FunctionDecl& decl) {
  const SymbolId symbol = FindFunction(context, {decl.name, {}, false});
  if (!symbol) return;
  for (const FunctionInfoId id : OverloadsOf(context, symbol, {})) {
    FunctionInfo& info = context[id];
    if (info.parameters.size == decl.parameters.size)
      info.declared = std::min(info.declared, std::max(context.view.order, 1u) - 1);
  }
}

std::string SignatureText(const Context& context, const FunctionInfo& info) {
  std::string text(context[DeclOf(context, info).name]);
  text += '(';
  bool first = true;
  for (const Parameter& parameter : context[info.parameters]) {
    if (!first) text += ", ";
    first = false;
    if (parameter.storage == Storage::kOut) text += "out ";
    if (parameter.storage == Storage::kInOut) text += "inout ";
    text += context.TypeName(parameter.type);
  }
  return text + ')';
}

}  // namespace clipc::check
