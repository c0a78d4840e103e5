// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Types and expressions.
#include <bit>

#include "base/overloaded.h"
#include "frontend/parse/ast_printer.h"

namespace clipc::ast {
namespace {

constexpr std::string_view kBinaryOps[] = {"*",  "/",  "%",  "+", "-", "<<", ">>", "<",  ">", "<=",
                                           ">=", "==", "!=", "&", "^", "|",  "&&", "||", ","};
constexpr std::string_view kUnaryOps[] = {"+", "-", "!", "~", "++", "--", "++", "--"};

}  // namespace

void Printer::Put(const QualifiedName& name) {
  if (name.from_global) out_ += "::";
  for (Name scope : file_.name_lists[name.scopes]) Put("{}::", Text(scope));
  out_ += Text(name.name);
}

void Printer::PutType(TypeId id) {
  if (!id) {
    out_ += "<no type>";
    return;
  }
  const Type& type = file_.types[id];
  if (type.outer) {
    PutType(type.outer);
    out_ += "::";
  }
  if (type.name.name)
    Put(type.name);
  else
    out_ += type.struct_definition ? "<unnamed>" : "<error>";
  if (type.has_arguments) PutTemplateArguments(type.arguments);
}

void Printer::PutList(List<ExprId> list, std::string_view open, std::string_view close) {
  out_ += open;
  bool first = true;
  for (ExprId id : file_.expr_lists[list]) {
    if (!first) out_ += ", ";
    first = false;
    PutExpr(id);
  }
  out_ += close;
}

void Printer::PutTemplateArguments(List<ExprId> list) { PutList(list, "<", ">"); }

void Printer::PutDimensions(List<ExprId> list) {
  for (ExprId id : file_.expr_lists[list]) {
    out_ += '[';
    if (id) PutExpr(id);
    out_ += ']';
  }
}

void Printer::PutLiteral(const Literal& literal) {
  switch (literal.kind) {
    case LiteralKind::kBool: out_ += literal.bits ? "true" : "false"; break;
    case LiteralKind::kInt: Put("{}", literal.bits); break;
    case LiteralKind::kUint: Put("{}u", literal.bits); break;
    case LiteralKind::kInt64: Put("{}l", literal.bits); break;
    case LiteralKind::kUint64: Put("{}ul", literal.bits); break;
    case LiteralKind::kHalf: Put("{:#}h", std::bit_cast<double>(literal.bits)); break;
    case LiteralKind::kFloat: Put("{:#}", std::bit_cast<double>(literal.bits)); break;
    case LiteralKind::kDouble: Put("{:#}L", std::bit_cast<double>(literal.bits)); break;
    case LiteralKind::kString:
      Put("{:?}", Text(Name{static_cast<std::uint32_t>(literal.bits)}));
      break;
  }
}

void Printer::PutExpr(ExprId id) {
  if (!id) {
    out_ += "<none>";
    return;
  }
  std::visit(
      Overloaded{
          [this](const Literal& e) { PutLiteral(e); },
          [this](const NameExpr& e) {
            Put(e.name);
            if (!e.arguments.empty()) PutTemplateArguments(e.arguments);
          },
          [this](const TypeExpr& e) { PutType(e.type); },
          [this](const UnaryExpr& e) {
            const bool post = e.op == UnaryOp::kPostIncrement || e.op == UnaryOp::kPostDecrement;
            out_ += '(';
            if (!post) out_ += kUnaryOps[static_cast<int>(e.op)];
            PutExpr(e.operand);
            if (post) out_ += kUnaryOps[static_cast<int>(e.op)];
            out_ += ')';
          },
          [this](const BinaryExpr& e) {
            out_ += '(';
            PutExpr(e.left);
            Put(" {} ", kBinaryOps[static_cast<int>(e.op)]);
            PutExpr(e.right);
            out_ += ')';
          },
          [this](const AssignExpr& e) {
            out_ += '(';
            PutExpr(e.left);
            Put(" {}= ", e.op ? kBinaryOps[static_cast<int>(*e.op)] : "");
            PutExpr(e.right);
            out_ += ')';
          },
          [this](const ConditionalExpr& e) {
            out_ += '(';
            PutExpr(e.condition);
            out_ += " ? ";
            PutExpr(e.when_true);
            out_ += " : ";
            PutExpr(e.when_false);
            out_ += ')';
          },
          [this](const CallExpr& e) {
            PutExpr(e.callee);
            PutList(e.arguments, "(", ")");
          },
          [this](const CastExpr& e) {
            out_ += "((";
            PutType(e.type);
            PutDimensions(e.dimensions);
            out_ += ')';
            PutExpr(e.operand);
            out_ += ')';
          },
          [this](const IndexExpr& e) {
            PutExpr(e.base);
            out_ += '[';
            PutExpr(e.index);
            out_ += ']';
          },
          [this](const MemberExpr& e) {
            PutExpr(e.base);
            Put("{}{}", std::holds_alternative<TypeExpr>(file_.exprs[e.base].node) ? "::" : ".",
                Text(e.name));
            if (!e.arguments.empty()) PutTemplateArguments(e.arguments);
          },
          [this](const InitListExpr& e) { PutList(e.elements, "{", "}"); },
          [this](const SizeofExpr& e) {
            out_ += "sizeof(";
            PutExpr(e.operand);
            out_ += ')';
          },
          [this](const ErrorExpr&) { out_ += "<error>"; },
      },
      file_.exprs[id].node);
}

}  // namespace clipc::ast
