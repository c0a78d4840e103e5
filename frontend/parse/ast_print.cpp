// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Declarations and statements.
#include "frontend/parse/ast_print.h"

#include "base/overloaded.h"
#include "frontend/parse/ast_printer.h"

namespace clipc::ast {
namespace {

struct QualifierText {
  Qualifiers bits;
  std::string_view text;
};
constexpr QualifierText kQualifierTexts[] = {
    {kExport, "export"},
    {kExtern, "extern"},
    {kInline, "inline"},
    {kStatic, "static"},
    {kShared, "shared"},
    {kGroupShared, "groupshared"},
    {kUniform, "uniform"},
    {kVolatile, "volatile"},
    {kPrecise, "precise"},
    {kConst, "const"},
    {kIn, "in"},
    {kOut, "out"},
    {kNoInterpolation, "nointerpolation"},
    {kLinear, "linear"},
    {kCentroid, "centroid"},
    {kNoPerspective, "noperspective"},
    {kSample, "sample"},
    {kRowMajor, "row_major"},
    {kColumnMajor, "column_major"},
    {kPackRowMajor, "pack_row_major"},
    {kPackColumnMajor, "pack_column_major"},
    {kSnorm, "snorm"},
    {kUnorm, "unorm"},
    {kGloballyCoherent, "globallycoherent"},
};

}  // namespace

void Printer::PutQualifiers(Qualifiers qualifiers) {
  for (const auto& [bits, text] : kQualifierTexts) {
    if (qualifiers & bits) Put(" {}", text);
  }
}

void Printer::PutRegisters(List<RegisterBinding> registers) {
  for (const RegisterBinding& binding : file_.registers[registers]) {
    out_ += " register(";
    if (binding.profile) Put("{}, ", Text(binding.profile));
    if (binding.letter) Put("{}{}", binding.letter, binding.number);
    if (binding.subcomponent) {
      out_ += '[';
      PutExpr(binding.subcomponent);
      out_ += ']';
    }
    if (binding.letter && binding.space) out_ += ", ";
    if (!binding.letter || binding.space) Put("space{}", binding.space);
    out_ += ')';
  }
}

void Printer::PutAttributes(List<Attr> attributes) {
  for (const Attr& attribute : file_.attrs[attributes]) {
    StartLine();
    Put("attribute {}", Text(attribute.name));
    if (attribute.has_parens) PutList(attribute.arguments, "(", ")");
    EndLine();
  }
}

void Printer::PutTemplate(List<TemplateParameter> parameters) {
  for (const TemplateParameter& parameter : file_.template_parameters[parameters]) {
    StartLine();
    Put("template parameter {} : ", Text(parameter.name));
    if (parameter.is_type)
      out_ += "typename";
    else
      PutType(parameter.type);
    if (parameter.default_value) {
      out_ += " = ";
      PutExpr(parameter.default_value);
    }
    EndLine();
  }
}

void Printer::PutVar(std::string_view kind, const VarDecl& var) {
  StartLine();
  Put("{} ", kind);
  if (var.out_of_line_of.name) {
    Put(var.out_of_line_of);
    out_ += "::";
  }
  Put("{}", var.name ? Text(var.name) : "<unnamed>");
  PutDimensions(var.dimensions);
  out_ += " : ";
  PutType(var.type);
  PutQualifiers(var.qualifiers);
  if (var.bit_width) {
    out_ += " bits ";
    PutExpr(var.bit_width);
  }
  if (var.semantic.name) Put(" semantic {}", Text(var.semantic.name));
  PutRegisters(var.registers);
  if (var.packoffset)
    Put(" packoffset(c{}.{})", var.packoffset->reg, "xyzw"[var.packoffset->component]);
  if (var.has_state_block) out_ += " state block";
  if (var.init) {
    out_ += " = ";
    PutExpr(var.init);
  }
  EndLine();
  ++indent_;
  PutAttributes(var.attributes);
  --indent_;
}

void Printer::PutFunction(const FunctionDecl& function) {
  StartLine();
  out_ += function.body ? "function " : "prototype ";
  if (function.out_of_line_of.name) {
    Put(function.out_of_line_of);
    out_ += "::";
  }
  out_ += Text(function.name);
  if (!function.template_arguments.empty()) PutTemplateArguments(function.template_arguments);
  out_ += " : ";
  PutType(function.return_type);
  PutDimensions(function.return_dimensions);
  PutQualifiers(function.qualifiers);
  if (function.is_const_method) out_ += " const method";
  if (function.is_template) out_ += " template";
  if (function.return_semantic.name) Put(" semantic {}", Text(function.return_semantic.name));
  EndLine();
  ++indent_;
  PutTemplate(function.template_parameters);
  PutAttributes(function.attributes);
  PutInlineType(function.return_type);
  PutDecls(function.parameters, "parameter");
  if (function.body) PutStmt(function.body);
  --indent_;
}

void Printer::PutStruct(const StructDecl& structure) {
  constexpr std::string_view kKinds[] = {"struct", "class", "interface"};
  StartLine();
  Put("{} {}", kKinds[static_cast<int>(structure.kind)],
      structure.name ? Text(structure.name) : "<unnamed>");
  if (!structure.template_arguments.empty()) PutTemplateArguments(structure.template_arguments);
  bool first = true;
  for (TypeId base : file_.type_lists[structure.bases]) {
    out_ += first ? " : " : ", ";
    first = false;
    PutType(base);
  }
  if (structure.is_template) out_ += " template";
  if (!structure.is_definition) out_ += " declared only";
  EndLine();
  ++indent_;
  PutTemplate(structure.template_parameters);
  PutAttributes(structure.attributes);
  PutDecls(structure.members, "field");
  --indent_;
}

void Printer::PutBuffer(const BufferDecl& buffer) {
  StartLine();
  Put("{} {}", buffer.kind == BufferKind::kCbuffer ? "cbuffer" : "tbuffer",
      buffer.name ? Text(buffer.name) : "<unnamed>");
  PutRegisters(buffer.registers);
  EndLine();
  ++indent_;
  PutAttributes(buffer.attributes);
  PutDecls(buffer.members, "member");
  --indent_;
}

void Printer::PutEnum(const EnumDecl& decl) {
  StartLine();
  Put("enum {}{}", decl.is_class ? "class " : "", decl.name ? Text(decl.name) : "<unnamed>");
  if (decl.underlying) {
    out_ += " : ";
    PutType(decl.underlying);
  }
  EndLine();
  ++indent_;
  for (const Enumerator& enumerator : file_.enumerators[decl.enumerators]) {
    StartLine();
    Put("value {}", Text(enumerator.name));
    if (enumerator.value) {
      out_ += " = ";
      PutExpr(enumerator.value);
    }
    EndLine();
  }
  --indent_;
}

// The struct that a declaration defines in passing.
void Printer::PutInlineType(TypeId id) {
  if (!id || !file_.types[id].struct_definition) return;
  PutDecl(file_.types[id].struct_definition, "field");
}

void Printer::PutDecls(List<DeclId> decls, std::string_view variable) {
  for (DeclId id : file_.decl_lists[decls]) PutDecl(id, variable);
}

void Printer::PutDecl(DeclId id, std::string_view variable) {
  std::visit(Overloaded{
                 [&](const VarDecl& d) {
                   PutVar(variable, d);
                   ++indent_;
                   PutInlineType(d.type);
                   --indent_;
                 },
                 [&](const FunctionDecl& d) { PutFunction(d); },
                 [&](const StructDecl& d) { PutStruct(d); },
                 [&](const TypedefDecl& d) {
                   StartLine();
                   Put("typedef {}", Text(d.name));
                   PutDimensions(d.dimensions);
                   out_ += " : ";
                   PutType(d.type);
                   PutQualifiers(d.qualifiers);
                   EndLine();
                   ++indent_;
                   PutInlineType(d.type);
                   --indent_;
                 },
                 [&](const BufferDecl& d) { PutBuffer(d); },
                 [&](const NamespaceDecl& d) {
                   StartLine();
                   Put("namespace {}\n", d.name ? Text(d.name) : "<unnamed>");
                   ++indent_;
                   PutDecls(d.members, "variable");
                   --indent_;
                 },
                 [&](const EnumDecl& d) { PutEnum(d); },
                 [&](const UsingDecl& d) {
                   StartLine();
                   Put("using {}", d.is_namespace ? "namespace " : "");
                   Put(d.name);
                   EndLine();
                 },
             },
             file_.decls[id].node);
}

// ---- statements

void Printer::PutLine(std::string_view text, ExprId expr) {
  StartLine();
  out_ += text;
  if (expr) {
    out_ += ' ';
    PutExpr(expr);
  }
  EndLine();
}

void Printer::PutBody(StmtId id) {
  if (!id) return;
  ++indent_;
  PutStmt(id);
  --indent_;
}

void Printer::PutFor(const ForStmt& loop) {
  PutLine("for");
  ++indent_;
  if (loop.init) {
    PutLine("init");
    PutBody(loop.init);
  }
  if (loop.condition) PutLine("while", loop.condition);
  if (loop.step) PutLine("step", loop.step);
  PutStmt(loop.body);
  --indent_;
}

void Printer::PutStmt(StmtId id) {
  const Stmt& stmt = file_.stmts[id];
  PutAttributes(stmt.attributes);
  std::visit(
      Overloaded{
          [this](const BlockStmt& s) {
            PutLine("block");
            for (StmtId child : file_.stmt_lists[s.body]) PutBody(child);
          },
          [this](const DeclStmt& s) { PutDecls(s.decls, "variable"); },
          [this](const ExprStmt& s) { PutLine("expression", s.expr); },
          [this](const IfStmt& s) {
            PutLine("if", s.condition);
            PutBody(s.then);
            if (s.otherwise) PutLine("else");
            PutBody(s.otherwise);
          },
          [this](const ForStmt& s) { PutFor(s); },
          [this](const WhileStmt& s) {
            PutLine("while", s.condition);
            PutBody(s.body);
          },
          [this](const DoStmt& s) {
            PutLine("do");
            PutBody(s.body);
            PutLine("while", s.condition);
          },
          [this](const SwitchStmt& s) {
            PutLine("switch", s.value);
            PutBody(s.body);
          },
          [this](const CaseStmt& s) { s.value ? PutLine("case", s.value) : PutLine("default"); },
          [this](const ReturnStmt& s) { PutLine("return", s.value); },
          [this](const BreakStmt&) { PutLine("break"); },
          [this](const ContinueStmt&) { PutLine("continue"); },
          [this](const DiscardStmt&) { PutLine("discard"); },
          [this](const EmptyStmt&) { PutLine("empty"); },
          [this](const ErrorStmt&) { PutLine("<error>"); },
      },
      stmt.node);
}

std::string Printer::Print() {
  for (DeclId id : file_.top_level) PutDecl(id, "variable");
  for (Name name : file_.technique_vertex_shaders) Put("technique compiles {}\n", Text(name));
  return std::move(out_);
}

}  // namespace clipc::ast

namespace clipc {

std::string PrintAst(const ast::File& file) { return ast::Printer(file).Print(); }

}  // namespace clipc
