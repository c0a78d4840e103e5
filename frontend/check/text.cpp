// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/check/text.h"

#include <bit>

#include "base/operators.h"
#include "base/overloaded.h"

namespace clipc::check {
namespace {

// Beside the precedences of kBinaryOperators: `a = b` and `a ? b : c`; `-a` and `(T)a`; `f(a)`,
// `a.b` and `a[b]`.
constexpr int kLoose = 0, kPrefix = 11, kPostfix = 12;

int PrecedenceOf(const Context& context, ast::ExprId id) {
  return std::visit(
      Overloaded{
          [](const ast::BinaryExpr& e) { return TraitsOf(e.op).precedence; },
          [](const ast::UnaryExpr& e) { return e.op && IsPostfix(*e.op) ? kPostfix : kPrefix; },
          [](const ast::CastExpr&) { return kPrefix; },
          [](const ast::AssignExpr&) { return kLoose; },
          [](const ast::ConditionalExpr&) { return kLoose; },
          [](const auto&) { return kPostfix; },
      },
      context[id].node);
}

std::string TextOf(const Context& context, const ast::Literal& literal) {
  const auto number = static_cast<std::int64_t>(literal.bits);
  const auto real = [&](std::string_view suffix) {
    std::string text = fmt::format("{}", std::bit_cast<double>(literal.bits));
    if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
    return text += suffix;
  };
  switch (literal.kind) {
    case LiteralKind::kBool: return number != 0 ? "true" : "false";
    case LiteralKind::kInt: return fmt::format("{}", number);
    case LiteralKind::kHexadecimal: return fmt::format("{:#x}", literal.bits);
    case LiteralKind::kUint: return fmt::format("{}u", literal.bits);
    case LiteralKind::kInt64: return fmt::format("{}l", number);
    case LiteralKind::kUint64: return fmt::format("{}ul", literal.bits);
    case LiteralKind::kHalf: return real("h");
    case LiteralKind::kFloat:
    case LiteralKind::kTypedFloat: return real("");
    case LiteralKind::kDouble: return real("L");
    case LiteralKind::kString:
      return fmt::format("\"{}\"", context[Name{static_cast<std::uint32_t>(literal.bits)}]);
  }
  return {};
}

std::string ListText(const Context& context, List<ast::ExprId> expressions) {
  std::string text;
  for (const ast::ExprId id : context[expressions])
    text += (text.empty() ? "" : ", ") + TextOf(context, id);
  return text;
}

// `<float, 4>`. A comparison or shift in it needs parentheses, as its `>` would end the list.
std::string TemplateText(const Context& context, List<ast::ExprId> arguments) {
  std::string text;
  for (const ast::ExprId id : context[arguments]) {
    text += text.empty() ? "<" : ", ";
    text += TextOf(context, id, TraitsOf(BinaryOp::kAdd).precedence);
  }
  return text.empty() ? "" : text + ">";
}

}  // namespace

std::string DimensionText(const Context& context, List<ast::ExprId> dimensions) {
  std::string text;
  for (const ast::ExprId dimension : context[dimensions])
    text += fmt::format("[{}]", dimension ? TextOf(context, dimension) : "");
  return text;
}

std::string TypeText(const Context& context, ast::TypeId id) {
  const ast::Type& type = context[id];
  std::string text = type.outer ? TypeText(context, type.outer) + "::" : "";
  text += QualifiedText(context, type.name) + TemplateText(context, type.arguments);
  return type.has_arguments && context[type.arguments].empty() ? text + "<>" : text;
}

std::string TextOf(const Context& context, ast::ExprId id, int precedence) {
  if (PrecedenceOf(context, id) < precedence) return fmt::format("({})", TextOf(context, id));
  const auto text = [&](ast::ExprId operand, int least) { return TextOf(context, operand, least); };
  return std::visit(
      Overloaded{
          [&](const ast::Literal& e) { return TextOf(context, e); },
          [&](const ast::NameExpr& e) {
            return QualifiedText(context, e.name) + TemplateText(context, e.arguments);
          },
          [&](const ast::TypeExpr& e) { return TypeText(context, e.type); },
          [&](const ast::CallExpr& e) {
            return fmt::format("{}({})", text(e.callee, kPostfix), ListText(context, e.arguments));
          },
          [&](const ast::IndexExpr& e) {
            return fmt::format("{}[{}]", text(e.base, kPostfix), text(e.index, kLoose));
          },
          [&](const ast::MemberExpr& e) {
            return fmt::format("{}{}{}{}", text(e.base, kPostfix),
                               context.GetIf<ast::TypeExpr>(e.base) ? "::" : ".", context[e.name],
                               TemplateText(context, e.arguments));
          },
          [&](const ast::UnaryExpr& e) {
            const std::string_view op = e.op ? SpellingOf(*e.op) : "+";
            return e.op && IsPostfix(*e.op) ? fmt::format("{}{}", text(e.operand, kPostfix), op)
                                            : fmt::format("{}{}", op, text(e.operand, kPostfix));
          },
          [&](const ast::BinaryExpr& e) {
            const int own = TraitsOf(e.op).precedence;
            return fmt::format("{} {} {}", text(e.left, own), SpellingOf(e.op),
                               text(e.right, own + 1));
          },
          [&](const ast::CommaExpr& e) {
            return fmt::format("({}, {})", text(e.left, kLoose), text(e.right, kLoose));
          },
          [&](const ast::AssignExpr& e) {
            return fmt::format("{} {}= {}", text(e.left, kPostfix), e.op ? SpellingOf(*e.op) : "",
                               text(e.right, kLoose));
          },
          [&](const ast::ConditionalExpr& e) {
            return fmt::format("{} ? {} : {}", text(e.condition, kLoose + 1),
                               text(e.when_true, kLoose), text(e.when_false, kLoose));
          },
          [&](const ast::CastExpr& e) {
            return fmt::format("({}{}){}", TypeText(context, e.type),
                               DimensionText(context, e.dimensions), text(e.operand, kPrefix));
          },
          [&](const ast::InitListExpr& e) {
            return fmt::format("{{{}}}", ListText(context, e.elements));
          },
          [&](const ast::SizeofExpr& e) {
            return fmt::format("sizeof({})", text(e.operand, kLoose));
          },
          [](const ast::ErrorExpr&) -> std::string { return "..."; },
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
