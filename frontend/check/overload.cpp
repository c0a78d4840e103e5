// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/overload.h"

#include <algorithm>

#include "base/spelling.h"
#include "frontend/check/enum_class.h"
#include "frontend/check/function.h"
#include "frontend/check/struct.h"

namespace clipc::check {
namespace {

// Whether the first type is T[], of objects, and the second an array of as many T as it likes: a
// parameter without a size takes every array (DXC's HLSLFileCheck, resource-array-param.hlsl).
bool IsOpenArrayOf(const Context& context, TypeId open, TypeId array) {
  const Type &to = context[open], &from = context[array];
  return to.kind == TypeKind::kArray && from.kind == TypeKind::kArray && to.count == 0 &&
         to.element == from.element && context[to.element].kind == TypeKind::kObject;
}

std::optional<ConversionRank> Rank(const Context& context, TypeId from, TypeId to) {
  if (from == to) return ConversionRank{};
  if (const auto rank = RankImplicit(context.types, from, to)) return rank;
  if (DerivesFrom(context, from, to)) return ConversionRank{.form = 1};
  if (IsOpenArrayOf(context, to, from)) return ConversionRank{};
  return std::nullopt;
}

// Returns whether the arguments fit; sets the cost of the call, and whether an argument changes its
// shape.
bool RankArguments(const Context& context, const FunctionInfo& info, ExprSpan arguments,
                   std::uint64_t& cost, bool& changes_shape) {
  if (arguments.size() > info.parameters.size || arguments.size() < info.required) return false;
  cost = 0;
  changes_shape = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Parameter& parameter = context[info.parameters][i];
    const TypeId given = context.TypeIdOf(arguments[i]);
    cost += EnumCost(context, arguments[i], parameter.enumeration);
    const auto add = [&](std::optional<ConversionRank> rank) {
      if (!rank) return false;
      cost += CostOf(*rank);
      changes_shape = changes_shape || rank->truncation > 0 || rank->splat > 0;
      return true;
    };
    if (parameter.storage != Storage::kOut && !add(Rank(context, given, parameter.type)))
      return false;
    if (parameter.storage != Storage::kIn && !add(Rank(context, parameter.type, given)))
      return false;
  }
  return true;
}

// How special the type of a template's parameter is: T, vector<T, N>, vector<T, 2>, float2.
int SpecialityOf(const Context& context, List<ast::TemplateParameter> parameters,
                 ast::TypeId type_id) {
  const ast::Type& type = context[type_id];
  const auto is_parameter = [&](Name name) {
    return std::ranges::any_of(context[parameters], [&](const ast::TemplateParameter& parameter) {
      return parameter.name == name;
    });
  };
  constexpr int kConcrete = 8;
  if (!type.has_arguments) return is_parameter(type.name.name) ? 0 : kConcrete;
  int speciality = 1;
  for (const ast::ExprId argument : context[type.arguments]) {
    const auto* inner = context.GetIf<ast::TypeExpr>(argument);
    const auto* name = context.GetIf<ast::NameExpr>(argument);
    if (inner && !is_parameter(context[inner->type].name.name)) ++speciality;
    if (!inner && !(name && is_parameter(name->name.name))) ++speciality;
  }
  return speciality;
}

// Whether one instance of a template is of a more special one than the other ([temp.func.order] of
// C++).
bool IsMoreSpecial(const Context& context, const FunctionInfo& one, const FunctionInfo& other) {
  const ast::FunctionDecl& left = DeclOf(context, one);
  const ast::FunctionDecl& right = DeclOf(context, other);
  if (!one.is_instance || !other.is_instance || left.parameters.size != right.parameters.size)
    return false;
  bool is_more = false;
  for (std::uint32_t i = 0; i < left.parameters.size; ++i) {
    const auto of = [&](const ast::FunctionDecl& decl) {
      return SpecialityOf(context, decl.template_parameters,
                          context.Get<ast::VarDecl>(context[decl.parameters][i]).type);
    };
    if (of(left) < of(right)) return false;
    is_more = is_more || of(left) > of(right);
  }
  return is_more;
}

std::string ArgumentTypes(const Context& context, ExprSpan arguments) {
  std::string text = "(";
  for (ExprId argument : arguments) {
    if (text.size() > 1) text += ", ";
    text += context.TypeName(argument);
  }
  return text + ')';
}

}  // namespace

Choice ChooseOverload(Context& context, std::span<const FunctionInfoId> overloads,
                      ExprSpan arguments, Name name, Span span) {
  Choice choice;
  for (const bool later : {false, true}) {
    std::uint64_t best_cost = ~std::uint64_t{0};
    FunctionInfoId rival;
    for (FunctionInfoId id : overloads) {
      const FunctionInfo& info = context[id];
      std::uint64_t cost = 0;
      bool changes_shape = false;
      if (info.is_broken) {
        choice.reported = true;
        return choice;
      }
      if ((info.declared >= context.view.order) != later) continue;
      if (!RankArguments(context, info, arguments, cost, changes_shape) || cost > best_cost)
        continue;
      // A function is better than an instance of a template, and of two of these the one of the
      // more special template.
      const bool is_tie = choice.function && cost == best_cost;
      const bool yields = is_tie && ((info.is_instance && !context[choice.function].is_instance) ||
                                     IsMoreSpecial(context, context[choice.function], info));
      if (yields) continue;
      const bool wins = is_tie && IsMoreSpecial(context, info, context[choice.function]);
      rival = is_tie && !wins ? choice.function : FunctionInfoId{};
      best_cost = cost;
      choice.function = id;
      choice.changes_shape = changes_shape;
    }
    if (rival) {
      context.Report(span, diag::AmbiguousCall, context[name], ArgumentTypes(context, arguments))
          .Note(DeclOf(context, context[rival]).name_span, diag::Candidate,
                SignatureText(context, context[rival]))
          .Note(DeclOf(context, context[choice.function]).name_span, diag::Candidate,
                SignatureText(context, context[choice.function]));
      return {.function = {}, .reported = true};
    }
    if (choice.function) break;
  }
  return choice;
}

FunctionInfoId ForClasses(Context& context, FunctionInfoId id, ExprSpan arguments) {
  const auto declared = context[context[id].parameters];
  std::vector<Parameter> parameters(declared.begin(), declared.end());
  std::string key = fmt::format("classes {}", id.index);
  bool is_same = true;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Parameter& parameter = parameters[i];
    const TypeId given = i < arguments.size() ? context.TypeIdOf(arguments[i]) : parameter.type;
    const bool is_class =
        IsInterface(context, parameter.type) && DerivesFrom(context, given, parameter.type);
    if (parameter.storage == Storage::kIn &&
        (is_class || IsOpenArrayOf(context, parameter.type, given))) {
      parameter.type = given;
      is_same = false;
    }
    key += fmt::format(" {}", parameter.type.index);
  }
  if (is_same) return id;
  const auto [known, is_new] = context.functions.instances.try_emplace(std::move(key), 0);
  if (is_new) {
    FunctionInfo info = context[id];
    info.parameters = context.functions.parameters.Add(std::span<const Parameter>(parameters));
    info.function = {};
    known->second = context.functions.infos.Add(info).index;
  }
  return FunctionInfoId{known->second};
}

void ReportNoOverload(Context& context, std::span<const FunctionInfoId> overloads,
                      ExprSpan arguments, Name name, Span span) {
  if (context.functions.has_too_many_instances) return;  // the function may be one of those
  constexpr std::size_t kMaxNotes = 6;
  const bool count_fits = std::ranges::any_of(overloads, [&](FunctionInfoId id) {
    return arguments.size() >= context[id].required &&
           arguments.size() <= context[id].parameters.size;
  });
  Diagnostic& report = count_fits || overloads.empty()
                           ? context.Report(span, diag::NoMatchingFunction, context[name],
                                            ArgumentTypes(context, arguments))
                           : context.Report(span, diag::WrongArgumentCount, context[name],
                                            WithCount(arguments.size(), "argument"));
  for (std::size_t i = 0; i < overloads.size() && i < kMaxNotes; ++i) {
    report.Note(DeclOf(context, context[overloads[i]]).name_span, diag::Candidate,
                SignatureText(context, context[overloads[i]]));
  }
}

}  // namespace clipc::check
