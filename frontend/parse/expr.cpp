// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <array>
#include <optional>

#include "frontend/parse/parser.h"

// Expressions, by precedence climbing.
namespace clipc::ast {
namespace {

// The binary operators by TokenKind: the one that the token is, or that an assignment such as `+=`
// contains.
constexpr auto kOperatorOfToken = [] {
  std::array<std::optional<BinaryOp>, static_cast<std::size_t>(TokenKind::kUnknown) + 1> operators;
  for (std::size_t i = 0; i < operators.size(); ++i) {
    const auto kind = static_cast<TokenKind>(i);
    std::string_view text = SpellingOf(kind);
    if (IsAssignment(kind)) text.remove_suffix(1);
    for (int op = 0; op <= static_cast<int>(BinaryOp::kLogicalOr); ++op) {
      if (SpellingOf(static_cast<BinaryOp>(op)) == text) operators[i] = static_cast<BinaryOp>(op);
    }
  }
  return operators;
}();

constexpr std::optional<BinaryOp> OperatorOfToken(TokenKind kind) {
  return kOperatorOfToken[static_cast<std::size_t>(kind)];
}

}  // namespace

// ---- operators

ExprId Parser::ParseExpression() {
  const std::size_t start = pos_;
  ExprId left = ParseAssignment();
  while (At(kComma) && !panic_) {
    Next();
    const ExprId right = ParseAssignment();
    left = AddExpr(start, CommaExpr{left, right});
  }
  return left;
}

ExprId Parser::ParseAssignment() {
  const std::size_t start = pos_;
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return ErrorExprHere();
  const ExprId left = ParseConditional();
  if (!IsAssignment(Peek().kind) || panic_) return left;
  const TokenKind kind = Next().kind;
  AssignExpr assignment{};
  if (kind != kEqual) assignment.op = OperatorOfToken(kind);
  assignment.left = left;
  assignment.right = ParseAssignment();
  return AddExpr(start, assignment);
}

ExprId Parser::ParseConditional() {
  const std::size_t start = pos_;
  const ExprId condition = ParseBinary(1);
  if (!At(kQuestion) || panic_) return condition;
  Next();
  const ExprId when_true = ParseExpression();
  if (!panic_) Expect(kColon, "`:` and the other value of `?`");
  const ExprId when_false = ParseAssignment();
  return AddExpr(start, ConditionalExpr{condition, when_true, when_false});
}

ExprId Parser::ParseBinary(int min_precedence) {
  const std::size_t start = pos_;
  ExprId left = ParseUnary();
  while (!panic_) {
    const std::optional<BinaryOp> op = OperatorOfToken(Peek().kind);
    if (!op || TraitsOf(*op).precedence < min_precedence || IsAssignment(Peek().kind)) break;
    if (greater_ends_ && (At(kGreater) || At(kGreaterGreater))) break;
    const Span op_span = Next().span();
    const ExprId right = ParseBinary(TraitsOf(*op).precedence + 1);
    left = AddExpr(start, BinaryExpr{*op, left, right, op_span});
  }
  return left;
}

ExprId Parser::ParseUnary() {
  switch (Peek().kind) {
    case kPlus: return ParsePrefix({});
    case kMinus: return ParsePrefix(UnaryOp::kNegate);
    case kExclaim: return ParsePrefix(UnaryOp::kNot);
    case kTilde: return ParsePrefix(UnaryOp::kComplement);
    case kPlusPlus: return ParsePrefix(UnaryOp::kPreIncrement);
    case kMinusMinus: return ParsePrefix(UnaryOp::kPreDecrement);
    case kStar:
    case kAmp: Error(Here(), diag::NoPointers, At(kStar) ? "*" : "&"); return ErrorExprHere();
    case kLeftParen:
      if (IsCast()) return ParseCast();
      break;
    default:
      if (AtWord(Word::kSizeof)) return ParseSizeof();
      break;
  }
  const std::size_t start = pos_;
  return ParsePostfix(ParsePrimary(), start);
}

ExprId Parser::ParsePrefix(std::optional<UnaryOp> op) {
  const std::size_t start = pos_;
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return ErrorExprHere();
  Next();
  const ExprId operand = ParseUnary();
  return AddExpr(start, UnaryExpr{op, operand});
}

// (T)e, (T[2])e
ExprId Parser::ParseCast() {
  const std::size_t start = pos_;
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return ErrorExprHere();
  Next();
  ParseQualifiers(nullptr);
  CastExpr cast{};
  cast.type = ParseType(true);
  cast.dimensions = ParseDimensions();
  ExpectClose(kRightParen, start);
  cast.operand = panic_ ? ErrorExprHere() : ParseUnary();
  return AddExpr(start, cast);
}

ExprId Parser::ParseSizeof() {
  const std::size_t start = pos_;
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return ErrorExprHere();
  Next();
  if (!At(kLeftParen) || !StartsType(1)) return AddExpr(start, SizeofExpr{ParseUnary()});
  const std::size_t open = pos_;
  Next();
  Bracketed bracketed(*this);
  const ExprId operand = At(kLeftParen, 1) ? ParseExpression() : ParseTypeOperand();
  Close(kRightParen, open);
  return AddExpr(start, SizeofExpr{operand});
}

// ---- postfix operators

ExprId Parser::ParsePostfix(ExprId base, std::size_t start) {
  while (!panic_) {
    switch (Peek().kind) {
      case kDot:
      case kArrow: base = ParseMember(base, start); break;
      case kLeftBracket: {
        const ExprId index = ParseInBrackets(kRightBracket);
        base = AddExpr(start, IndexExpr{base, index});
        break;
      }
      case kLeftParen: {
        const List<ExprId> arguments = ParseArguments();
        base = AddExpr(start, CallExpr{base, arguments});
        break;
      }
      case kPlusPlus:
      case kMinusMinus: {
        const bool adds = Next().kind == kPlusPlus;
        const UnaryOp op = adds ? UnaryOp::kPostIncrement : UnaryOp::kPostDecrement;
        base = AddExpr(start, UnaryExpr{op, base});
        break;
      }
      default: return base;
    }
  }
  return base;
}

// [e] or (e)
ExprId Parser::ParseInBrackets(TokenKind close) {
  const std::size_t open = pos_;
  Next();
  Bracketed bracketed(*this);
  const ExprId inner = ParseExpression();
  Close(close, open);
  return inner;
}

// .name, .name<float>
ExprId Parser::ParseMember(ExprId base, std::size_t start) {
  if (At(kArrow)) {
    if (Diagnostic* report = Error(Here(), diag::NoPointers, "->")) report->Fix(Here(), ".");
    EndPanic();
  }
  Next();
  MemberExpr member{};
  member.base = base;
  while (At(kColonColon, 1) && AtName()) {
    member.of = Peek().name();
    Skip(2);
  }
  if (!At(kIdentifier)) {
    Unexpected("the name of a member after `.`");
    return base;
  }
  member.name_span = Here();
  member.name = Next().name();
  const bool is_template = At(kLess) && MeaningOf(member.name) == Meaning::kFunctionTemplate &&
                           IsTemplateUse(member.name, 0);
  if (is_template || IsMemberTemplateUse(0)) member.arguments = ParseTemplateArguments();
  return AddExpr(start, member);
}

// (a, b)
List<ExprId> Parser::ParseArguments() {
  const std::size_t open = pos_;
  Bracketed bracketed(*this);
  Next();
  Collector arguments(exprs_);
  ParseList(kRightParen, open, "an expression", [&] { arguments.Add(ParseAssignment()); });
  return arguments.Finish();
}

// ---- operands

ExprId Parser::MissingExpr() {
  Unexpected("an expression");
  return ErrorExprHere();
}

ExprId Parser::ParsePrimary() {
  switch (Peek().kind) {
    case kIntLiteral:
    case kFloatLiteral: {
      const std::size_t start = pos_;
      const Token& token = Next();
      return AddExpr(start, Literal{token.literal, token.value});
    }
    case kStringLiteral: return ParseString();
    case kLeftParen: return ParseParenthesized();
    case kIdentifier:
    case kColonColon: return ParseNameOrType();
    case kLeftBrace:
      Unexpected("an expression");
      EndPanic();
      return ParseInitList();
    default: return MissingExpr();
  }
}

ExprId Parser::ParseParenthesized() {
  const std::size_t open = pos_;
  const ExprId inner = ParseInBrackets(kRightParen);
  file_.exprs[inner].span = SpanFrom(open);
  return inner;
}

// "a" "b": one string.
ExprId Parser::ParseString() {
  const std::size_t start = pos_;
  Name text = Next().name();
  if (At(kStringLiteral)) {
    std::string joined(Text(text));
    while (At(kStringLiteral)) joined += Text(Next().name());
    text = Intern(joined);
  }
  return AddExpr(start, Literal{LiteralKind::kString, text.index});
}

ExprId Parser::ParseNameOrType() {
  const std::size_t start = pos_;
  const TokenKind next = Peek(1).kind;
  const bool is_plain = next != kLeftParen && next != kLess && next != kColonColon;
  if (is_plain && At(kIdentifier) && AtWord(Word::kNone))
    return AddExpr(start, NameExpr{{Next().name(), {}, false}, {}});
  switch (WordAt()) {
    case Word::kTrue:
    case Word::kFalse:
      return AddExpr(start, Literal{LiteralKind::kBool, Next().name() == Intern("true") ? 1u : 0u});
    case Word::kUnsigned: return AddExpr(start, TypeExpr{ParseType(false)});
    case Word::kNumericType:
      if (MeaningOf(Peek().name()) == Meaning::kValue) break;  // `int int1;`
      if (At(kLeftParen, 1)) return AddExpr(start, TypeExpr{ParseType(false)});
      return MissingExpr();
    default: break;
  }
  if (At(kIdentifier) && !AtName() && !AtWord(Word::kNumericType)) {
    return MissingExpr();
  }
  // vector<float, 3>(...), S(...), ns::S(...)
  const std::size_t after = SkipTypeName(0);
  const bool is_call = after > 0 && At(kLeftParen, after);
  const bool templated = is_call && !At(kIdentifier, after - 1);
  if (is_call && IsTypeName(templated ? 0 : after - 1))
    return AddExpr(start, TypeExpr{ParseType(false)});
  NameExpr name{};
  name.name = ParseQualifiedName();
  if (At(kLess) && !panic_ && IsTemplateUse(name.name.name, 0))
    name.arguments = ParseTemplateArguments();
  if (At(kColonColon) && !name.arguments.empty()) return ParseMemberOfTemplate(name, start);
  return AddExpr(start, name);
}

// S<int>::x, S<int>::T<float>::x
ExprId Parser::ParseMemberOfTemplate(const NameExpr& name, std::size_t start) {
  Type type{SpanFrom(start), name.name, name.arguments, {}, true, {}};
  ExprId base = AddExpr(start, TypeExpr{AddType(type)});
  while (At(kColonColon) && !panic_) base = ParseMember(base, start);
  return base;
}

}  // namespace clipc::ast
