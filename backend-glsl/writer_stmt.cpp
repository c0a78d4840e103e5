// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <variant>

#include "backend-glsl/writer.h"
#include "base/invariant.h"
#include "base/overloaded.h"

namespace clipc::glsl {

using namespace ir;

void Writer::Statements(std::span<const StmtId> list) {
  for (StmtId id : list) Statement(id);
}

// The statements of a block, or the one statement; the caller wrote the brace before it.
void Writer::Body(StmtId id) {
  ++indent_;
  namer_.OpenScope();
  if (const auto* block = std::get_if<ir::Block>(&program_.stmts[id].node)) {
    Statements(program_.stmt_lists[block->body]);
  } else {
    Statement(id);
  }
  namer_.CloseScope();
  --indent_;
}

void Writer::Comment(Span span) {
  if (!options_.comment_of) return;
  std::string comment = options_.comment_of(span);
  if (comment.empty() || comment == comment_) return;
  comment_ = std::move(comment);
  Line("// ", comment_);
}

void Writer::Statement(StmtId id) {
  if (!std::holds_alternative<ir::Block>(program_.stmts[id].node)) Comment(program_.stmts[id].span);
  Visit(Overloaded{
            [&](const ir::Block&) {
              Line("{");
              Body(id);
              Line("}");
            },
            [&](const Declare& node) { Line(DeclareText(node), ";"); },
            [&](const Evaluate& node) { Line(Expr(node.expr).text, ";"); },
            [&](const ir::If& node) { If(node, ""); },
            [&](const ir::For& node) { For(node); },
            [&](const While& node) {
              Line("while (", Expr(node.condition).text, ") {");
              Body(node.body);
              Line("}");
            },
            [&](const DoWhile& node) {
              Line("do {");
              Body(node.body);
              Line("} while (", Expr(node.condition).text, ");");
            },
            [&](const ir::Switch& node) { Switch(node); },
            [&](const Return& node) {
              node.value ? Line("return ", Expr(node.value).text, ";") : Line("return;");
            },
            [&](const Break&) { Line("break;"); },
            [&](const Continue&) { Line("continue;"); },
        },
        program_.stmts[id].node);
}

std::string Writer::DeclareText(const Declare& node) {
  const Var& var = program_.vars[node.var];
  const ExprId init = node.init ? node.init : var.init;
  // The variable is in scope after its initialiser only, in GLSL as in HLSL.
  std::string value;
  constant_ = true;
  if (init) value = ArgumentOf(init);
  const bool is_const = var.storage == Storage::kConstant && init && constant_;
  std::string& name = var_names_[node.var.index];
  name = LocalName(var.name, "value");
  const bool is_precise = var.precise && target_.Has(Feature::kPrecise);
  return Concat(is_const ? "const " : "", is_precise ? "precise " : "", Declaration(var.type, name),
                init ? " = " : "", value);
}

void Writer::If(const ir::If& node, std::string_view lead) {
  Line(std::string(lead) + "if (" + Expr(node.condition).text + ") {");
  Body(node.then);
  if (!node.otherwise) return Line("}");
  if (const auto* next = std::get_if<ir::If>(&program_.stmts[node.otherwise].node))
    return If(*next, "} else ");
  Line("} else {");
  Body(node.otherwise);
  Line("}");
}

void Writer::For(const ir::For& node) {
  namer_.OpenScope();
  std::string init;
  for (StmtId id : program_.stmt_lists[node.init]) {
    const auto& stmt = program_.stmts[id].node;
    std::string text;
    if (const auto* declare = std::get_if<Declare>(&stmt)) {
      text = DeclareText(*declare);
      if (!init.empty()) text.erase(0, text.find(' ') + 1);  // `int i = 0, j = 1`
    } else {
      text = Expr(std::get<Evaluate>(stmt).expr).text;
    }
    init += (init.empty() ? "" : ", ") + text;
  }
  std::string head = "for (" + init + ";";
  if (node.condition) head += " " + Expr(node.condition).text;
  head += ";";
  if (node.step) head += " " + Expr(node.step).text;
  Line(head, ") {");
  Body(node.body);
  Line("}");
  namer_.CloseScope();
}

void Writer::Switch(const ir::Switch& node) {
  Line("switch (" + Expr(node.value).text + ") {");
  namer_.OpenScope();
  const auto cases = program_.switch_cases[node.cases];
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const SwitchCase& arm = cases[i];
    for (ExprId label : program_.expr_lists[arm.labels]) Line("case " + Expr(label).text + ":");
    if (arm.is_default) Line("default:");
    ++indent_;
    Statements(program_.stmt_lists[arm.body]);
    // GLSL wants a statement after the last label.
    if (arm.body.empty() && i + 1 == cases.size()) Line("break;");
    --indent_;
  }
  namer_.CloseScope();
  Line("}");
}

}  // namespace clipc::glsl
