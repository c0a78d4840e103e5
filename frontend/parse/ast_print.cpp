// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/parse/ast_print.h"

#include <bit>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/overloaded.h"

namespace clipc::ast {
namespace {

// Parts of a line that print nothing if they are empty.

template <typename Part>
struct With {  // `text` and then the part, which may be none
  std::string_view text;
  Part part;
};
struct Arguments {  // <a, b>
  List<ExprId> list;
};
struct Sequence {  // the brackets are printed even if the list is empty
  std::string_view open;
  List<ExprId> list;
  std::string_view close;
};
struct Dimensions {  // [a][b]
  List<ExprId> list;
};
struct Scope {  // a::b::
  const QualifiedName& name;
};
struct QualifierBits {
  Qualifiers bits;
};
std::string_view If(bool condition, std::string_view text) { return condition ? text : ""; }

class Printer {
 public:
  explicit Printer(const File& file) : file_(file) {}

  std::string Print() {
    for (DeclId id : file_.top_level) PutDecl(id, "variable");
    for (const auto& [function, stage] : file_.technique_shaders)
      Line("technique compiles ", InfoOf(stage).prefix, " ", function);
    return std::move(out_);
  }

 private:
  template <typename... Parts>
  void Line(const Parts&... parts) {
    out_.append(static_cast<std::size_t>(indent_) * 2, ' ');
    Put(parts...);
    out_ += '\n';
  }
  template <typename... Parts>
  void Put(const Parts&... parts) {
    (PutPart(parts), ...);
  }
  // Calls `put`, and indents the lines that it prints one level further.
  template <typename PutLines>
  void Below(PutLines put) {
    ++indent_;
    put();
    --indent_;
  }
  std::string_view Text(Name name) const { return file_.names[name]; }

  // ---- parts of a line
  void PutPart(std::string_view text) { out_ += text; }
  void PutPart(Name name) { out_ += name ? Text(name) : "<unnamed>"; }
  void PutPart(const QualifiedName& name) {
    if (name.from_global) out_ += "::";
    for (Name scope : file_.name_lists[name.scopes]) Put(scope, "::");
    out_ += Text(name.name);
  }
  void PutPart(Scope scope) {
    if (scope.name.name) Put(scope.name, "::");
  }
  template <typename Part>
  void PutPart(const With<Part>& with) {
    if (with.part) Put(with.text, with.part);
  }
  void PutPart(Arguments arguments) {
    if (!arguments.list.empty()) Put(Sequence{"<", arguments.list, ">"});
  }
  void PutPart(Dimensions dimensions) {
    for (ExprId id : file_.expr_lists[dimensions.list]) Put("[", With{"", id}, "]");
  }
  void PutPart(QualifierBits qualifiers) {
#define QUALIFIER(bit, spelling, word) Put(If((qualifiers.bits & bit) != 0, " " spelling));
#define PACKING(bit, text) Put(If((qualifiers.bits & bit) != 0, " " text));
#include "frontend/parse/qualifier_bits.def"
  }
  void PutPart(const Sequence& sequence) {
    Put(sequence.open);
    std::string_view separator;
    for (ExprId id : file_.expr_lists[sequence.list]) Put(std::exchange(separator, ", "), id);
    Put(sequence.close);
  }
  void PutPart(List<TypeId> bases) {
    std::string_view separator = " : ";
    for (TypeId base : file_.type_lists[bases]) Put(std::exchange(separator, ", "), base);
  }
  void PutPart(List<RegisterBinding> registers);
  void PutPart(TypeId id);
  void PutPart(ExprId id);
  void PutPart(const Literal& literal);

  // ---- lines
  void PutAttributes(List<Attr> attributes);
  void PutTemplate(List<TemplateParameter> parameters);
  // Prints the struct that a declaration of the type `id` defines in place, if there is one.
  void PutDefinition(TypeId id) {
    if (id && file_.types[id].struct_definition)
      PutDecl(file_.types[id].struct_definition, "field");
  }
  // Prints a declaration; `variable` is the word for a variable in this scope: "field".
  void PutDecl(DeclId id, std::string_view variable);
  void PutDecls(List<DeclId> decls, std::string_view variable) {
    for (DeclId id : file_.decl_lists[decls]) PutDecl(id, variable);
  }
  void PutVar(std::string_view kind, const VarDecl& var);
  void PutFunction(const FunctionDecl& function);
  void PutStruct(const StructDecl& structure);
  void PutEnum(const EnumDecl& decl);
  void PutStmt(StmtId id);
  void PutBody(StmtId id) {
    if (id) Below([&] { PutStmt(id); });
  }
  void PutFor(const ForStmt& loop);

  const File& file_;
  std::string out_;
  int indent_ = 0;
};

// ---- types and expressions

void Printer::PutPart(TypeId id) {
  if (!id) return Put("<no type>");
  const Type& type = file_.types[id];
  Put(If(type.is_unsigned, "unsigned "), With{"", type.outer}, If(bool(type.outer), "::"));
  if (type.name.name) {
    Put(type.name);
  } else {
    Put(type.struct_definition ? "<unnamed>" : "<error>");
  }
  if (type.has_arguments) Put(Sequence{"<", type.arguments, ">"});
}

void Printer::PutPart(const Literal& literal) {
  // The suffixes by LiteralKind.
  constexpr std::string_view kSuffixes[] = {"", "", "", "u", "l", "ul", "h", "", "", "L", ""};
  const std::string_view suffix = kSuffixes[static_cast<std::size_t>(literal.kind)];
  const auto out = std::back_inserter(out_);
  if (literal.kind == LiteralKind::kBool) {
    Put(literal.bits ? "true" : "false");
  } else if (literal.kind == LiteralKind::kString) {
    fmt::format_to(out, "{:?}", Text(Name{static_cast<std::uint32_t>(literal.bits)}));
  } else if (IsFloatingPoint(literal.kind)) {
    fmt::format_to(out, "{:#}{}", std::bit_cast<double>(literal.bits), suffix);
  } else {
    fmt::format_to(out, "{}{}", literal.bits, suffix);
  }
}

void Printer::PutPart(ExprId id) {
  if (!id) return Put("<none>");
  std::visit(Overloaded{
                 [this](const Literal& e) { Put(e); },
                 [this](const NameExpr& e) { Put(e.name, Arguments{e.arguments}); },
                 [this](const TypeExpr& e) { Put(e.type); },
                 [this](const UnaryExpr& e) {
                   const std::string_view op = e.op ? SpellingOf(*e.op) : "+";
                   const bool post = e.op && IsPostfix(*e.op);
                   Put("(", If(!post, op), e.operand, If(post, op), ")");
                 },
                 [this](const BinaryExpr& e) {
                   Put("(", e.left, " ", SpellingOf(e.op), " ", e.right, ")");
                 },
                 [this](const CommaExpr& e) { Put("(", e.left, " , ", e.right, ")"); },
                 [this](const AssignExpr& e) {
                   Put("(", e.left, " ", e.op ? SpellingOf(*e.op) : "", "= ", e.right, ")");
                 },
                 [this](const ConditionalExpr& e) {
                   Put("(", e.condition, " ? ", e.when_true, " : ", e.when_false, ")");
                 },
                 [this](const CallExpr& e) { Put(e.callee, Sequence{"(", e.arguments, ")"}); },
                 [this](const CastExpr& e) {
                   Put("((", e.type, Dimensions{e.dimensions}, ")", e.operand, ")");
                 },
                 [this](const IndexExpr& e) { Put(e.base, "[", e.index, "]"); },
                 [this](const MemberExpr& e) {
                   const bool of_type = std::holds_alternative<TypeExpr>(file_.exprs[e.base].node);
                   Put(e.base, of_type ? "::" : ".");
                   if (e.of) Put(e.of, "::");
                   Put(e.name, Arguments{e.arguments});
                 },
                 [this](const InitListExpr& e) { Put(Sequence{"{", e.elements, "}"}); },
                 [this](const SizeofExpr& e) { Put("sizeof(", e.operand, ")"); },
                 [this](const ErrorExpr&) { Put("<error>"); },
             },
             file_.exprs[id].node);
}

// ---- declarations

void Printer::PutPart(List<RegisterBinding> registers) {
  for (const RegisterBinding& binding : file_.registers[registers]) {
    Put(" register(");
    if (binding.profile) Put(binding.profile, ", ");
    if (binding.letter) out_ += fmt::format("{}{}", binding.letter, binding.number);
    if (binding.subcomponent) Put("[", binding.subcomponent, "]");
    Put(If(binding.letter && binding.space, ", "));
    if (!binding.letter || binding.space) out_ += fmt::format("space{}", binding.space);
    Put(")");
  }
}

void Printer::PutAttributes(List<Attr> attributes) {
  for (const Attr& attribute : file_.attrs[attributes]) {
    const bool has_parens = attribute.has_parens;
    Line("attribute ", attribute.name,
         Sequence{If(has_parens, "("), attribute.arguments, If(has_parens, ")")});
  }
}

void Printer::PutTemplate(List<TemplateParameter> parameters) {
  for (const TemplateParameter& parameter : file_.template_parameters[parameters]) {
    Line("template parameter ", Text(parameter.name), " : ", If(parameter.is_type, "typename"),
         With{"", parameter.type}, With{" = ", parameter.default_value});
  }
}

void Printer::PutVar(std::string_view kind, const VarDecl& var) {
  std::string packoffset;
  if (var.packoffset) {
    packoffset =
        fmt::format(" packoffset(c{}.{})", var.packoffset->reg, "xyzw"[var.packoffset->component]);
  }
  Line(kind, " ", Scope{var.out_of_line_of}, var.name, Dimensions{var.dimensions}, " : ", var.type,
       QualifierBits{var.qualifiers}, With{" bits ", var.bit_width},
       With{" semantic ", var.semantic.name}, var.registers, packoffset,
       If(var.has_state_block, " state block"), With{" = ", var.init});
  Below([&] {
    PutAttributes(var.attributes);
    PutDefinition(var.type);
  });
}

void Printer::PutFunction(const FunctionDecl& function) {
  Line(function.body ? "function " : "prototype ", Scope{function.out_of_line_of},
       Text(function.name), Arguments{function.template_arguments}, " : ", function.return_type,
       Dimensions{function.return_dimensions}, QualifierBits{function.qualifiers},
       If(function.is_const_method, " const method"), If(function.is_template, " template"),
       With{" semantic ", function.return_semantic.name});
  Below([&] {
    PutTemplate(function.template_parameters);
    PutAttributes(function.attributes);
    PutDefinition(function.return_type);
    PutDecls(function.parameters, "parameter");
    if (function.body) PutStmt(function.body);
  });
}

void Printer::PutStruct(const StructDecl& structure) {
  constexpr std::string_view kKinds[] = {"struct ", "class ", "interface "};
  Line(kKinds[static_cast<int>(structure.kind)], structure.name,
       Arguments{structure.template_arguments}, structure.bases,
       If(structure.is_template, " template"), If(!structure.is_definition, " declared only"));
  Below([&] {
    PutTemplate(structure.template_parameters);
    PutAttributes(structure.attributes);
    PutDecls(structure.members, "field");
  });
}

void Printer::PutEnum(const EnumDecl& decl) {
  Line("enum ", If(decl.is_class, "class "), decl.name, With{" : ", decl.underlying});
  Below([&] {
    for (const Enumerator& enumerator : file_.enumerators[decl.enumerators])
      Line("value ", enumerator.name, With{" = ", enumerator.value});
  });
}

void Printer::PutDecl(DeclId id, std::string_view variable) {
  std::visit(
      Overloaded{
          [&](const VarDecl& d) { PutVar(variable, d); },
          [&](const FunctionDecl& d) { PutFunction(d); },
          [&](const StructDecl& d) { PutStruct(d); },
          [&](const TypedefDecl& d) {
            Line("typedef ", d.name, Dimensions{d.dimensions}, " : ", d.type,
                 QualifierBits{d.qualifiers}, If(d.is_template, " template"));
            Below([&] {
              PutTemplate(d.template_parameters);
              PutDefinition(d.type);
            });
          },
          [&](const BufferDecl& d) {
            Line(d.kind == BufferKind::kCbuffer ? "cbuffer " : "tbuffer ", d.name, d.registers);
            Below([&] {
              PutAttributes(d.attributes);
              PutDecls(d.members, "member");
            });
          },
          [&](const NamespaceDecl& d) {
            Line("namespace ", d.name);
            Below([&] { PutDecls(d.members, "variable"); });
          },
          [&](const EnumDecl& d) { PutEnum(d); },
          [&](const UsingDecl& d) { Line("using ", If(d.is_namespace, "namespace "), d.name); },
      },
      file_.decls[id].node);
}

// ---- statements

void Printer::PutFor(const ForStmt& loop) {
  Line("for");
  Below([&] {
    if (loop.init) Line("init");
    PutBody(loop.init);
    if (loop.condition) Line("while ", loop.condition);
    if (loop.step) Line("step ", loop.step);
    PutStmt(loop.body);
  });
}

void Printer::PutStmt(StmtId id) {
  const Stmt& stmt = file_.stmts[id];
  PutAttributes(stmt.attributes);
  std::visit(
      Overloaded{
          [this](const BlockStmt& s) {
            Line("block");
            for (StmtId child : file_.stmt_lists[s.body]) PutBody(child);
          },
          [this](const DeclStmt& s) { PutDecls(s.decls, "variable"); },
          [this](const ExprStmt& s) { Line("expression ", s.expr); },
          [this](const IfStmt& s) {
            Line("if ", s.condition);
            PutBody(s.then);
            if (s.otherwise) Line("else");
            PutBody(s.otherwise);
          },
          [this](const ForStmt& s) { PutFor(s); },
          [this](const WhileStmt& s) {
            Line("while ", s.condition);
            PutBody(s.body);
          },
          [this](const DoStmt& s) {
            Line("do");
            PutBody(s.body);
            Line("while ", s.condition);
          },
          [this](const SwitchStmt& s) {
            Line("switch ", s.value);
            PutBody(s.body);
          },
          [this](const CaseStmt& s) { Line(s.value ? "case" : "default", With{" ", s.value}); },
          [this](const ReturnStmt& s) { Line("return", With{" ", s.value}); },
          [this](const BreakStmt&) { Line("break"); },
          [this](const ContinueStmt&) { Line("continue"); },
          [this](const DiscardStmt&) { Line("discard"); },
          [this](const EmptyStmt&) { Line("empty"); },
          [this](const ErrorStmt&) { Line("<error>"); },
      },
      stmt.node);
}

}  // namespace
}  // namespace clipc::ast

namespace clipc {

std::string PrintAst(const ast::File& file) { return ast::Printer(file).Print(); }

}  // namespace clipc
