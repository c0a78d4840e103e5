// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/not_copied.h"
#include "frontend/parse/attributes.h"
#include "frontend/parse/parse_options.h"
#include "frontend/parse/qualifiers.h"
#include "frontend/parse/tree_builder.h"

// The recursive-descent parser of Parse(). Its grammar functions call each other across all
// subjects, so they are one class; its bases are layers, each without knowledge of the next:
// TokenCursor, Lookahead, TreeBuilder.
//
// A Parse function starts at the first token of the construct that it is named after. A comment
// that is only an example shows the text that the function reads.
namespace clipc::ast {

class Parser : private TreeBuilder {
 public:
  Parser(Tokens&& tokens, Diagnostics& diagnostics, FunctionBodies bodies,
         const EffectParts& effect);
  File Run();

 private:
  // The place of a declaration.
  enum class Scope : std::uint8_t { kGlobal, kStruct, kBuffer, kLocal };
  using Decls = Collector<DeclId>;

  // The part of a declaration before its declarators.
  struct Specifiers {
    std::size_t start = 0;
    List<Attr> attributes;
    Qualifiers qualifiers = 0;
    TypeId type;
  };
  struct TemplateHeader {
    bool present = false;
    List<TemplateParameter> parameters;
  };

  // A part of the text: during the life of the object `>` ends template arguments, or is an
  // operator again as inside of brackets.
  class Bracketed : NotCopied {
   public:
    explicit Bracketed(Parser& parser, bool greater_ends = false)
        : parser_(parser), outer_(std::exchange(parser.greater_ends_, greater_ends)) {}
    ~Bracketed() { parser_.greater_ends_ = outer_; }

   private:
    Parser& parser_;
    bool outer_;
  };

  // ---- types, qualifiers and attributes (type.cpp)
  // Parses a type; `may_define` allows `struct {...}`.
  TypeId ParseType(bool may_define);
  TypeId ParseNamedType();
  TypeId ParseTaggedType(bool may_define);
  Name ParseUnsigned();
  QualifiedName ParseQualifiedName();
  List<ExprId> ParseTemplateArguments();
  ExprId ParseTemplateArgument();
  bool AtTypeArgument() const;
  ExprId ParseTypeOperand(Qualifiers qualifiers = 0);
  Qualifiers ParseQualifiers(Collector<Attr>* attributes);
  List<Attr> ParseAttributes();
  // Warns, once for each name, of an attribute that does nothing.
  void NoteAttribute(const Attr& attribute);
  // Reports clip planes among the attributes of a declaration that is not a function, and Vulkan's
  // attributes that have no effect on it. `what` names the declaration: "a field".
  void CheckAttributes(List<Attr> attributes, AttributeOwner owner, std::string_view what);
  // Reports attributes that the statement which follows them does not take, and two that contradict
  // each other.
  void CheckStatementAttributes(List<Attr> list);
  void CheckQualifiers(Qualifiers qualifiers, QualifierOwner owner, Span span);
  void ParseAttributes(Collector<Attr>& attributes);
  void ParseAttributeList(Collector<Attr>& attributes);
  bool ParseAttribute(Collector<Attr>& attributes, std::size_t start);
  List<ExprId> ParseDimensions();

  // ---- declarations (decl.cpp)
  bool AtOutsideStatement() const;
  void ParseOutsideStatements();
  void ParseMembers(Decls& decls, Scope scope, std::size_t open);
  void ParseOrSkipDeclaration(Decls& decls, Scope scope);
  void ParseDeclaration(Decls& decls, Scope scope);
  bool ParseKeywordDeclaration(Decls& decls, Scope scope);
  Specifiers ParseSpecifiers(std::string_view expected);
  bool ParseTypedSpecifiers(Specifiers& specifiers, std::string_view expected);
  void ParseSpecified(Decls& decls, Scope scope, const TemplateHeader& header);
  bool ParseTypeOnly(Decls& decls, const Specifiers& specifiers);
  void ParseVariables(Decls& decls, Scope scope, const Specifiers& specifiers);
  void ParseBuffer(Decls& decls, const Specifiers& specifiers);
  void ParseNamespace(Decls& decls);
  void ParseTypedef(Decls& decls);
  void ParseUsing(Decls& decls, const TemplateHeader& header);
  void ParseStaticAssert();
  bool ReportGlslWord();
  void ExpectSemicolon(std::string_view after);

  // ---- functions and templates (function.cpp)
  void ParseTemplate(Decls& decls, Scope scope);
  TemplateParameter ParseTemplateParameter();
  bool AtFunctionDeclarator() const;
  void ParseFunction(Decls& decls, Scope scope, const Specifiers& specifiers,
                     const TemplateHeader& header);
  bool ParseLocalFunction(const Specifiers& specifiers);
  StmtId ParseFunctionBody();
  bool AtDeclaratorScope() const;
  List<ExprId> ParseDeclaratorScope(QualifiedName& scope);
  void ParseFunctionName(FunctionDecl& function);
  Name ParseOperatorName();
  List<DeclId> ParseParameters();
  void ParseParameter(Decls& decls);

  // ---- structs and enums (struct.cpp)
  DeclId ParseStruct(const TemplateHeader& header);
  void ParseEndOfType(DeclId definition);
  Name NameOfType(DeclId definition) const;
  List<TypeId> ParseBases();
  DeclId ParseEnum();
  List<Enumerator> ParseEnumerators();

  // ---- declarators (declarator.cpp)
  // Reads the current token as the name of `node`, and declares it.
  template <typename Node>
  void TakeName(Node& node, Meaning meaning) {
    node.name_span = Here();
    node.name = Next().name();
    Declare(node.name, meaning);
  }
  // Parses the name of a `what`, "variable"; reports and returns false if there is none.
  bool ParseDeclaratorName(Name& name, Span& span, std::string_view what);
  VarDecl MakeVar(const Specifiers& specifiers) const;
  void ParseDeclaratorTail(VarDecl& var, Scope scope);
  void ParseColonParts(VarDecl& var);
  void ParseColonPart(VarDecl& var, Collector<RegisterBinding>& registers);
  void ParseInitializer(VarDecl& var, Scope scope);
  ExprId ParseInitValue();
  ExprId ParseInitList();
  RegisterBinding ParseRegister();
  bool ParseRegisterOperand(RegisterBinding& binding);
  std::optional<PackOffset> ParsePackOffset();
  bool ParsePackOffsetOperand(PackOffset& offset);
  Semantic ParseSemantic();

  // ---- the effects framework (effect.cpp)
  void ParseTechnique();
  void SkipAnnotation();
  bool AtStateBlock() const;
  bool AtStates() const;
  void SkipEffectBlock();
  void SkipEffectValue();
  void NoteCompile();
  void ParseEntryCall(std::size_t function);

  // ---- statements (stmt.cpp)
  StmtId ParseStatement();
  StmtId ParseUnattributed(std::size_t start);
  StmtId ParseBlock();
  StmtId ParseIf(std::size_t start);
  StmtId ParseFor();
  StmtId ParseWhile();
  StmtId ParseDo();
  StmtId ParseSwitch();
  StmtId ParseCase();
  StmtId ParseReturn();
  StmtId ParseSimple();
  StmtId ParseDeclOrExpr();
  StmtId ParseBody(std::string_view of);
  // What is in the parentheses after `if`, `while` or `switch`.
  struct Condition {
    ExprId value;
    StmtId declared;  // the declaration of `if (float x = f())`, whose value is x; or none
  };
  bool AtConditionDeclaration() const;
  Condition ParseCondition(std::string_view of);
  StmtId AfterDeclaration(std::size_t start, const Condition& condition, StmtId stmt);

  // ---- expressions (expr.cpp)
  ExprId ParseExpression();
  ExprId ParseAssignment();
  ExprId ParseConditional();
  // Parses operators that bind at least as tightly as `min_precedence`.
  ExprId ParseBinary(int min_precedence);
  ExprId ParseUnary();
  ExprId ParsePrefix(std::optional<UnaryOp> op);
  ExprId ParseCast();
  ExprId ParseSizeof();
  ExprId ParsePostfix(ExprId base, std::size_t start);
  ExprId ParseMember(ExprId base, std::size_t start);
  ExprId ParseInBrackets(TokenKind close);
  ExprId MissingExpr();
  ExprId ParsePrimary();
  ExprId ParseParenthesized();
  ExprId ParseString();
  ExprId ParseNameOrType();
  ExprId ParseMemberOfTemplate(const NameExpr& name, std::size_t start);
  List<ExprId> ParseArguments();

  FunctionBodies bodies_;
  EffectParts effect_;
  EffectVariable variable_;             // the ranges of the declarator that is being parsed
  bool list_has_effect_value_ = false;  // in the initialiser that is being parsed
  bool has_entry_call_ = false;         // EffectParts::entry_call was found
  bool greater_ends_ = false;           // in template arguments: `>` is not an operator
  bool outside_reported_ = false;       // a statement outside of functions was reported
  // Whether the definition of a function was found inside a function: a `}` is missing, and all
  // blocks end here.
  bool leaving_function_ = false;
  std::vector<bool> noted_attributes_;  // by Name
  // By Name: the stages for which it is in File::technique_shaders, a bit each.
  std::vector<std::uint8_t> technique_stages_;
};

}  // namespace clipc::ast
