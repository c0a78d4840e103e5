// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "base/overloaded.h"
#include "frontend/parse/parser.h"

// Expressions by precedence climbing.
namespace clipc::ast {
namespace {

struct BinaryInfo {
  BinaryOp op;
  int precedence;  // 0: no binary operator
};

BinaryInfo BinaryOf(TokenKind kind) {
  switch (kind) {
    case TokenKind::kPipePipe: return {BinaryOp::kLogicalOr, 1};
    case TokenKind::kAmpAmp: return {BinaryOp::kLogicalAnd, 2};
    case TokenKind::kPipe: return {BinaryOp::kBitOr, 3};
    case TokenKind::kCaret: return {BinaryOp::kBitXor, 4};
    case TokenKind::kAmp: return {BinaryOp::kBitAnd, 5};
    case TokenKind::kEqualEqual: return {BinaryOp::kEqual, 6};
    case TokenKind::kExclaimEqual: return {BinaryOp::kNotEqual, 6};
    case TokenKind::kLess: return {BinaryOp::kLess, 7};
    case TokenKind::kGreater: return {BinaryOp::kGreater, 7};
    case TokenKind::kLessEqual: return {BinaryOp::kLessEqual, 7};
    case TokenKind::kGreaterEqual: return {BinaryOp::kGreaterEqual, 7};
    case TokenKind::kLessLess: return {BinaryOp::kShiftLeft, 8};
    case TokenKind::kGreaterGreater: return {BinaryOp::kShiftRight, 8};
    case TokenKind::kPlus: return {BinaryOp::kAdd, 9};
    case TokenKind::kMinus: return {BinaryOp::kSub, 9};
    case TokenKind::kStar: return {BinaryOp::kMul, 10};
    case TokenKind::kSlash: return {BinaryOp::kDiv, 10};
    case TokenKind::kPercent: return {BinaryOp::kMod, 10};
    default: return {BinaryOp::kComma, 0};
  }
}

// Of `+=` and so on; none for `=`.
std::optional<BinaryOp> CompoundOf(TokenKind kind) {
  switch (kind) {
    case TokenKind::kPlusEqual: return BinaryOp::kAdd;
    case TokenKind::kMinusEqual: return BinaryOp::kSub;
    case TokenKind::kStarEqual: return BinaryOp::kMul;
    case TokenKind::kSlashEqual: return BinaryOp::kDiv;
    case TokenKind::kPercentEqual: return BinaryOp::kMod;
    case TokenKind::kAmpEqual: return BinaryOp::kBitAnd;
    case TokenKind::kPipeEqual: return BinaryOp::kBitOr;
    case TokenKind::kCaretEqual: return BinaryOp::kBitXor;
    case TokenKind::kLessLessEqual: return BinaryOp::kShiftLeft;
    case TokenKind::kGreaterGreaterEqual: return BinaryOp::kShiftRight;
    default: return std::nullopt;
  }
}

}  // namespace

// ---- nodes and their height

std::uint32_t Parser::HeightOf(List<ExprId> list) const {
  std::uint32_t height = 0;
  for (ExprId id : file_.expr_lists[list]) height = std::max(height, HeightOf(id));
  return height;
}

// Of the children of a node that is being made.
std::uint32_t Parser::HeightOf(const decltype(Expr::node)& node) const {
  return Visit(
      Overloaded{
          [](const Literal&) { return 0u; },
          [this](const NameExpr& e) { return HeightOf(e.arguments); },
          [this](const TypeExpr& e) { return HeightOf(e.type); },
          [this](const UnaryExpr& e) { return HeightOf(e.operand); },
          [this](const BinaryExpr& e) { return std::max(HeightOf(e.left), HeightOf(e.right)); },
          [this](const AssignExpr& e) { return std::max(HeightOf(e.left), HeightOf(e.right)); },
          [this](const ConditionalExpr& e) {
            return std::max({HeightOf(e.condition), HeightOf(e.when_true), HeightOf(e.when_false)});
          },
          [this](const CallExpr& e) { return std::max(HeightOf(e.callee), HeightOf(e.arguments)); },
          [this](const CastExpr& e) {
            return std::max({HeightOf(e.type), HeightOf(e.dimensions), HeightOf(e.operand)});
          },
          [this](const IndexExpr& e) { return std::max(HeightOf(e.base), HeightOf(e.index)); },
          [this](const MemberExpr& e) { return std::max(HeightOf(e.base), HeightOf(e.arguments)); },
          [this](const InitListExpr& e) { return HeightOf(e.elements); },
          [this](const SizeofExpr& e) { return HeightOf(e.operand); },
          [](const ErrorExpr&) { return 0u; },
      },
      node);
}

bool Parser::CheckHeight(std::uint32_t height, Span span) {
  if (height <= kMaxHeight) return true;
  Error(span, diag::ExpressionTooLong, static_cast<int>(kMaxHeight));
  Abort();
  return false;
}

ExprId Parser::AddExpr(std::size_t start, decltype(Expr::node) node) {
  const Span span = SpanFrom(start);
  std::uint32_t height = 1 + HeightOf(node);
  if (!CheckHeight(height, span)) {
    node = ErrorExpr{};
    height = 1;
  }
  tallest_ = std::max(tallest_, height);
  heights_.push_back(static_cast<std::uint16_t>(height));
  return file_.exprs.Add(Expr{span, std::move(node)});
}

ExprId Parser::ErrorExprHere() { return AddExpr(pos_, ErrorExpr{}); }

// ---- operators

ExprId Parser::ParseExpression() {
  const std::size_t start = pos_;
  ExprId left = ParseAssignment();
  while (At(TokenKind::kComma) && !panic_) {
    const Span op = Next().span();
    const ExprId right = ParseAssignment();
    left = AddExpr(start, BinaryExpr{BinaryOp::kComma, left, right, op});
  }
  return left;
}

ExprId Parser::ParseAssignment() {
  const std::size_t start = pos_;
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return ErrorExprHere();
  const ExprId left = ParseConditional();
  if (!IsAssignment(Peek().kind) || panic_) return left;
  const std::optional<BinaryOp> op = CompoundOf(Next().kind);
  const ExprId right = ParseAssignment();
  return AddExpr(start, AssignExpr{op, left, right});
}

ExprId Parser::ParseConditional() {
  const std::size_t start = pos_;
  const ExprId condition = ParseBinary(1);
  if (!At(TokenKind::kQuestion) || panic_) return condition;
  Next();
  const ExprId when_true = ParseExpression();
  if (!panic_) Expect(TokenKind::kColon, "`:` and the other value of `?`");
  const ExprId when_false = ParseAssignment();
  return AddExpr(start, ConditionalExpr{condition, when_true, when_false});
}

// Operators that bind at least as tightly as `min_precedence`; all associate to the left.
ExprId Parser::ParseBinary(int min_precedence) {
  const std::size_t start = pos_;
  ExprId left = ParseUnary();
  while (!panic_) {
    const BinaryInfo info = BinaryOf(Peek().kind);
    if (info.precedence == 0 || info.precedence < min_precedence) break;
    if (greater_ends_ && (info.op == BinaryOp::kGreater || info.op == BinaryOp::kShiftRight)) break;
    const Span op = Next().span();
    const ExprId right = ParseBinary(info.precedence + 1);
    left = AddExpr(start, BinaryExpr{info.op, left, right, op});
  }
  return left;
}

ExprId Parser::ParseUnary() {
  switch (Peek().kind) {
    case TokenKind::kPlus: return ParsePrefix(UnaryOp::kPlus);
    case TokenKind::kMinus: return ParsePrefix(UnaryOp::kMinus);
    case TokenKind::kExclaim: return ParsePrefix(UnaryOp::kNot);
    case TokenKind::kTilde: return ParsePrefix(UnaryOp::kComplement);
    case TokenKind::kPlusPlus: return ParsePrefix(UnaryOp::kPreIncrement);
    case TokenKind::kMinusMinus: return ParsePrefix(UnaryOp::kPreDecrement);
    case TokenKind::kStar:
    case TokenKind::kAmp:
      Error(Here(), diag::NoPointers, At(TokenKind::kStar) ? "*" : "&");
      return ErrorExprHere();
    case TokenKind::kLeftParen:
      if (IsCast()) return ParseCast();
      break;
    default:
      if (AtWord(Word::kSizeof)) return ParseSizeof();
      break;
  }
  const std::size_t start = pos_;
  return ParsePostfix(ParsePrimary(), start);
}

ExprId Parser::ParsePrefix(UnaryOp op) {
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
  ExpectClose(TokenKind::kRightParen, start);
  cast.operand = panic_ ? ErrorExprHere() : ParseUnary();
  return AddExpr(start, cast);
}

ExprId Parser::ParseSizeof() {
  const std::size_t start = pos_;
  Nesting nesting(*this, 0);
  if (!nesting.ok()) return ErrorExprHere();
  Next();
  if (!At(TokenKind::kLeftParen) || !StartsType(1)) return AddExpr(start, SizeofExpr{ParseUnary()});
  const std::size_t open = pos_;
  Next();
  Bracketed bracketed(*this);
  const ExprId operand =
      Peek(1).kind == TokenKind::kLeftParen ? ParseExpression() : ParseTypeOperand();
  if (!ExpectClose(TokenKind::kRightParen, open)) SkipToClose(TokenKind::kRightParen);
  return AddExpr(start, SizeofExpr{operand});
}

// ---- what follows an operand

ExprId Parser::ParsePostfix(ExprId base, std::size_t start) {
  while (!panic_) {
    switch (Peek().kind) {
      case TokenKind::kDot:
      case TokenKind::kArrow: base = ParseMember(base, start); break;
      case TokenKind::kLeftBracket: {
        const std::size_t open = pos_;
        Next();
        Bracketed bracketed(*this);
        const ExprId index = ParseExpression();
        if (!ExpectClose(TokenKind::kRightBracket, open)) SkipToClose(TokenKind::kRightBracket);
        base = AddExpr(start, IndexExpr{base, index});
        break;
      }
      case TokenKind::kLeftParen: {
        const List<ExprId> arguments = ParseArguments();
        base = AddExpr(start, CallExpr{base, arguments});
        break;
      }
      case TokenKind::kPlusPlus:
        Next();
        base = AddExpr(start, UnaryExpr{UnaryOp::kPostIncrement, base});
        break;
      case TokenKind::kMinusMinus:
        Next();
        base = AddExpr(start, UnaryExpr{UnaryOp::kPostDecrement, base});
        break;
      default: return base;
    }
  }
  return base;
}

ExprId Parser::ParseMember(ExprId base, std::size_t start) {
  if (At(TokenKind::kArrow)) {
    if (Diagnostic* report = Error(Here(), diag::NoPointers, "->")) report->Fix(Here(), ".");
    panic_ = aborted_;
  }
  Next();
  MemberExpr member{};
  member.base = base;
  // `a.S::x` names the base class S of a.
  while (Peek(1).kind == TokenKind::kColonColon && AtName()) {
    Next();
    Next();
  }
  if (!At(TokenKind::kIdentifier)) {
    Unexpected("the name of a member after `.`");
    return base;
  }
  member.name_span = Here();
  member.name = Next().name();
  if (IsMemberTemplateUse(0)) member.arguments = ParseTemplateArguments();
  return AddExpr(start, member);
}

// (a, b), at its `(`.
List<ExprId> Parser::ParseArguments() {
  const std::size_t open = pos_;
  Bracketed bracketed(*this);
  Next();
  Collector<ExprId> arguments(expr_stack_);
  while (!At(TokenKind::kRightParen) && !AtEnd()) {
    arguments.Add(ParseAssignment());
    if (panic_ || !Accept(TokenKind::kComma)) break;
    if (At(TokenKind::kRightParen)) Unexpected("an expression");
  }
  if (!panic_ && !At(TokenKind::kRightParen)) {
    Diagnostic* report = Error(Here(), diag::UnexpectedToken, Describe(), "`,` or `)`");
    if (report) report->Note(tokens_[open].span(), diag::OpenedHere, "(");
  }
  if (panic_)
    SkipToClose(TokenKind::kRightParen);
  else
    Next();
  return arguments.Finish(file_.expr_lists);
}

// ---- operands

ExprId Parser::ParsePrimary() {
  switch (Peek().kind) {
    case TokenKind::kIntLiteral:
    case TokenKind::kFloatLiteral: return ParseLiteral();
    case TokenKind::kStringLiteral: return ParseString();
    case TokenKind::kLeftParen: return ParseParenthesized();
    case TokenKind::kIdentifier:
    case TokenKind::kColonColon: return ParseNameOrType();
    case TokenKind::kLeftBrace:
      Unexpected("an expression");
      panic_ = aborted_;
      return ParseInitList();
    default: Unexpected("an expression"); return ErrorExprHere();
  }
}

ExprId Parser::ParseParenthesized() {
  const std::size_t open = pos_;
  Bracketed bracketed(*this);
  Next();
  const ExprId inner = ParseExpression();
  if (!ExpectClose(TokenKind::kRightParen, open)) SkipToClose(TokenKind::kRightParen);
  file_.exprs[inner].span = SpanFrom(open);
  return inner;
}

ExprId Parser::ParseLiteral() {
  const std::size_t start = pos_;
  const Token token = Next();
  return AddExpr(start, Literal{token.literal, token.value});
}

// Adjacent strings are one.
ExprId Parser::ParseString() {
  const std::size_t start = pos_;
  Name text = Next().name();
  if (At(TokenKind::kStringLiteral)) {
    std::string joined(Text(text));
    while (At(TokenKind::kStringLiteral)) joined += Text(Next().name());
    text = Intern(joined);
  }
  return AddExpr(start, Literal{LiteralKind::kString, text.index});
}

ExprId Parser::ParseNameOrType() {
  const std::size_t start = pos_;
  const TokenKind next = Peek(1).kind;
  const bool is_plain =
      next != TokenKind::kLeftParen && next != TokenKind::kLess && next != TokenKind::kColonColon;
  if (is_plain && At(TokenKind::kIdentifier) && AtWord(Word::kNone))
    return AddExpr(start, NameExpr{{Next().name(), {}, false}, {}});
  switch (WordAt()) {
    case Word::kTrue:
    case Word::kFalse:
      return AddExpr(start, Literal{LiteralKind::kBool, Next().name() == Intern("true") ? 1u : 0u});
    case Word::kUnsigned: return AddExpr(start, TypeExpr{ParseType(false)});
    case Word::kNumericType:
      if (MeaningOf(Peek().name()) == Meaning::kValue) break;  // `int int1;`
      if (Peek(1).kind == TokenKind::kLeftParen) return AddExpr(start, TypeExpr{ParseType(false)});
      Unexpected("an expression");
      return ErrorExprHere();
    default: break;
  }
  if (At(TokenKind::kIdentifier) && !AtName() && !AtWord(Word::kNumericType)) {
    Unexpected("an expression");
    return ErrorExprHere();
  }
  // vector<float, 3>(...), S(...), ns::S(...)
  const std::size_t after = SkipTypeName(0);
  const bool is_call = after > 0 && Peek(after).kind == TokenKind::kLeftParen;
  const bool templated = is_call && Peek(after - 1).kind != TokenKind::kIdentifier;
  if (is_call && IsTypeName(templated ? 0 : after - 1))
    return AddExpr(start, TypeExpr{ParseType(false)});
  NameExpr name{};
  name.name = ParseQualifiedName();
  if (At(TokenKind::kLess) && !panic_ && IsTemplateUse(name.name.name, 0))
    name.arguments = ParseTemplateArguments();
  if (At(TokenKind::kColonColon) && !name.arguments.empty())
    return ParseMemberOfTemplate(name, start);
  return AddExpr(start, name);
}

// S<int>::x, S<int>::T<float>::x
ExprId Parser::ParseMemberOfTemplate(const NameExpr& name, std::size_t start) {
  Type type{SpanFrom(start), name.name, name.arguments, {}, true, {}};
  ExprId base = AddExpr(start, TypeExpr{AddType(type)});
  while (At(TokenKind::kColonColon) && !panic_) base = ParseMember(base, start);
  return base;
}

}  // namespace clipc::ast
