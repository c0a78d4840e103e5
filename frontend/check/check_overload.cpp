// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "frontend/check/checker.h"

// Which overload a call means: the one whose arguments need the cheapest conversions (CostOf).
namespace clipc {

std::optional<ConversionRank> Checker::Rank(ir::TypeId from, ir::TypeId to) const {
  if (from == to) return ConversionRank{};
  if (const auto rank = RankImplicit(program_.types, from, to)) return rank;
  if (DerivesFrom(from, to)) return ConversionRank{.form = 1};
  return std::nullopt;
}

// False when the call does not fit.
bool Checker::RankArguments(const FunctionInfo& info, std::span<const ir::ExprId> arguments,
                            std::uint64_t& cost, bool& changes_shape) const {
  if (arguments.size() > info.parameters.size || arguments.size() < info.required) return false;
  cost = 0;
  changes_shape = false;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Parameter& parameter = parameters_[info.parameters][i];
    const ir::TypeId given = TypeIdOf(arguments[i]);
    const auto add = [&](std::optional<ConversionRank> rank) {
      if (!rank) return false;
      cost += CostOf(*rank);
      changes_shape = changes_shape || rank->truncation > 0 || rank->splat > 0;
      return true;
    };
    if (parameter.storage != ir::Storage::kOut && !add(Rank(given, parameter.type))) return false;
    if (parameter.storage != ir::Storage::kIn && !add(Rank(parameter.type, given))) return false;
  }
  return true;
}

// The best of those declared so far; when none of them fits, of those declared later.
Checker::Choice Checker::ChooseOverload(std::span<const FunctionInfoId> overloads,
                                        std::span<const ir::ExprId> arguments, Name name,
                                        Span span) {
  Choice choice;
  for (const bool later : {false, true}) {
    std::uint64_t best_cost = ~std::uint64_t{0};
    FunctionInfoId rival;
    for (FunctionInfoId id : overloads) {
      const FunctionInfo& info = Info(id);
      std::uint64_t cost = 0;
      bool changes_shape = false;
      if (info.is_broken) {
        choice.reported = true;
        return choice;
      }
      if ((info.declared >= context_.order) != later) continue;
      if (!RankArguments(info, arguments, cost, changes_shape) || cost > best_cost) continue;
      // A function is better than an instance of a template.
      const bool yields = choice.function && cost == best_cost && info.is_instance &&
                          !Info(choice.function).is_instance;
      if (yields) continue;
      rival = cost == best_cost ? choice.function : FunctionInfoId{};
      best_cost = cost;
      choice.function = id;
      choice.changes_shape = changes_shape;
    }
    if (rival) {
      diagnostics_.Report(span, diag::AmbiguousCall, Text(name), ArgumentTypes(arguments))
          .Note(DeclOf(Info(rival)).name_span, diag::Candidate, SignatureText(Info(rival)))
          .Note(DeclOf(Info(choice.function)).name_span, diag::Candidate,
                SignatureText(Info(choice.function)));
      return {.function = {}, .reported = true};
    }
    if (choice.function) break;
  }
  return choice;
}

std::string Checker::ArgumentTypes(std::span<const ir::ExprId> arguments) const {
  std::string text = "(";
  for (ir::ExprId argument : arguments) {
    if (text.size() > 1) text += ", ";
    text += TypeName(TypeIdOf(argument));
  }
  return text + ')';
}

void Checker::ReportNoOverload(std::span<const FunctionInfoId> overloads,
                               std::span<const ir::ExprId> arguments, Name name, Span span) {
  constexpr std::size_t kMaxNotes = 6;
  const bool count_fits = std::ranges::any_of(overloads, [&](FunctionInfoId id) {
    return arguments.size() >= Info(id).required && arguments.size() <= Info(id).parameters.size;
  });
  Diagnostic& report =
      count_fits || overloads.empty()
          ? diagnostics_.Report(span, diag::NoMatchingFunction, Text(name),
                                ArgumentTypes(arguments))
          : diagnostics_.Report(span, diag::WrongArgumentCount, Text(name), arguments.size());
  for (std::size_t i = 0; i < overloads.size() && i < kMaxNotes; ++i) {
    report.Note(DeclOf(Info(overloads[i])).name_span, diag::Candidate,
                SignatureText(Info(overloads[i])));
  }
}

}  // namespace clipc
