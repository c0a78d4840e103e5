// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/partial_order.h"

#include <algorithm>
#include <string>
#include <vector>

#include "frontend/check/text.h"
#include "frontend/check/type_names.h"

namespace clipc::check {
namespace {

// Matches arguments of one specialisation with those of another, whose parameters stand for what
// they match first, and then for the same. Arguments are compared as text.
class Pattern {
 public:
  Pattern(Context& context, List<ast::TemplateParameter> parameters)
      : context_(context), parameters_(parameters), meant_(parameters.size) {}

  bool Matches(List<ast::ExprId> pattern, List<ast::ExprId> arguments) {
    if (pattern.size != arguments.size) return false;
    for (std::uint32_t i = 0; i < pattern.size; ++i) {
      if (!Matches(context_[pattern][i], context_[arguments][i])) return false;
    }
    return true;
  }

 private:
  bool Matches(ast::ExprId pattern, ast::ExprId argument) {
    const std::string text = TextOf(context_, argument);
    if (std::string* meant = MeaningOf(pattern)) return Means(*meant, text);
    const auto* outer = context_.GetIf<ast::TypeExpr>(pattern);
    const auto* inner = context_.GetIf<ast::TypeExpr>(argument);
    if (!outer || !inner || !context_[outer->type].has_arguments)
      return TextOf(context_, pattern) == text;
    const ast::Type& general = context_[outer->type];
    const ast::Type& special = context_[inner->type];
    if (special.has_arguments) {
      return special.name.name == general.name.name &&
             Matches(general.arguments, special.arguments);
    }
    return MatchesNumbers(general, special);
  }

  // Whether float2 is a vector<T, N>.
  bool MatchesNumbers(const ast::Type& general, const ast::Type& special) {
    const auto id = NumericType(context_, special.name.name);
    if (!id) return false;
    const Type type = context_[*id];
    const bool is_vector = type.kind == TypeKind::kVector;
    if (!is_vector && type.kind != TypeKind::kMatrix) return false;
    if (context_[general.name.name] != (is_vector ? "vector" : "matrix")) return false;
    std::vector<std::string> parts = {context_.types.Name(context_.types.Make(type.scalar))};
    if (!is_vector) parts.push_back(std::to_string(type.rows));
    parts.push_back(std::to_string(type.columns));
    if (general.arguments.size != parts.size()) return false;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      const ast::ExprId part = context_[general.arguments][i];
      std::string* meant = MeaningOf(part);
      if (meant ? !Means(*meant, parts[i]) : TextOf(context_, part) != parts[i]) return false;
    }
    return true;
  }

  static bool Means(std::string& meant, const std::string& text) {
    if (meant.empty()) meant = text;
    return meant == text;
  }

  // What the parameter that the argument names stands for; null if it names none.
  std::string* MeaningOf(ast::ExprId argument) {
    const std::string text = TextOf(context_, argument);
    for (std::uint32_t i = 0; i < parameters_.size; ++i) {
      if (context_[context_[parameters_][i].name] == text) return &meant_[i];
    }
    return nullptr;
  }

  Context& context_;
  List<ast::TemplateParameter> parameters_;
  std::vector<std::string> meant_;  // by parameter; empty: nothing yet
};

}  // namespace

bool IsAtLeastAsSpecial(Context& context, const ast::StructDecl& special,
                        const ast::StructDecl& general) {
  return Pattern(context, general.template_parameters)
      .Matches(general.template_arguments, special.template_arguments);
}

}  // namespace clipc::check
