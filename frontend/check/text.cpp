// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/text.h"

#include <bit>

#include "base/operators.h"
#include "base/overloaded.h"

namespace clipc::check {

std::string TextOf(const Context& context, ast::ExprId id) {
  const auto list = [&](List<ast::ExprId> expressions) {
    std::string text;
    for (ast::ExprId expr : context[expressions])
      text += (text.empty() ? "" : ", ") + TextOf(context, expr);
    return text;
  };
  return std::visit(
      Overloaded{
          [&](const ast::Literal& e) -> std::string {
            switch (e.kind) {
              case LiteralKind::kBool: return e.bits ? "true" : "false";
              case LiteralKind::kString:
                return fmt::format("\"{}\"", context[Name{static_cast<std::uint32_t>(e.bits)}]);
              case LiteralKind::kHalf:
              case LiteralKind::kFloat:
              case LiteralKind::kDouble: return fmt::format("{}", std::bit_cast<double>(e.bits));
              default: return fmt::format("{}", e.bits);
            }
          },
          [&](const ast::NameExpr& e) { return QualifiedText(context, e.name); },
          [&](const ast::TypeExpr& e) { return QualifiedText(context, context[e.type].name); },
          [&](const ast::CallExpr& e) {
            return fmt::format("{}({})", TextOf(context, e.callee), list(e.arguments));
          },
          [&](const ast::IndexExpr& e) {
            return fmt::format("{}[{}]", TextOf(context, e.base), TextOf(context, e.index));
          },
          [&](const ast::MemberExpr& e) {
            return fmt::format("{}.{}", TextOf(context, e.base), context[e.name]);
          },
          [&](const ast::UnaryExpr& e) {
            const std::string_view text = e.op ? SpellingOf(*e.op) : "+";
            return e.op && IsPostfix(*e.op) ? fmt::format("{}{}", TextOf(context, e.operand), text)
                                            : fmt::format("{}{}", text, TextOf(context, e.operand));
          },
          [&](const ast::BinaryExpr& e) {
            return fmt::format("{} {} {}", TextOf(context, e.left), SpellingOf(e.op),
                               TextOf(context, e.right));
          },
          [&](const ast::ConditionalExpr& e) {
            return fmt::format("{} ? {} : {}", TextOf(context, e.condition),
                               TextOf(context, e.when_true), TextOf(context, e.when_false));
          },
          [&](const ast::CastExpr& e) {
            return fmt::format("({}){}", QualifiedText(context, context[e.type].name),
                               TextOf(context, e.operand));
          },
          [](const auto&) -> std::string { return "..."; },
      },
      context[id].node);
}

std::string QualifiedText(const Context& context, const ast::QualifiedName& name) {
  std::string text = name.from_global ? "::" : "";
  for (Name scope : context[name.scopes]) {
    text += context[scope];
    text += "::";
  }
  return text += context[name.name];
}

std::string QuotedList(std::span<const std::string_view> names) {
  std::string text;
  for (std::string_view name : names) text += fmt::format("{}`{}`", text.empty() ? "" : ", ", name);
  return text;
}

}  // namespace clipc::check
