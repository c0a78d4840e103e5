// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/diagnostics.h"
#include "frontend/lex/token.h"
#include "frontend/parse/ast.h"
#include "frontend/parse/keywords.h"

// The recursive-descent parser behind Parse(). It never goes back: where HLSL is ambiguous (cast or
// parentheses, template arguments or less-than, declaration or expression), it looks ahead a
// bounded number of tokens and asks what the names mean so far. Included by parse*.cpp only.
namespace clipc::ast {

// `=`, `+=` and so on.
constexpr bool IsAssignment(TokenKind kind) {
  return kind >= TokenKind::kEqual && kind <= TokenKind::kGreaterGreaterEqual;
}

// Where a declaration stands.
enum class Scope : std::uint8_t { kGlobal, kStruct, kBuffer, kLocal };

class Parser {
 public:
  Parser(Tokens tokens, Diagnostics& diagnostics);
  File Run();

 private:
  // What an identifier stands for at this point of the text.
  enum class Meaning : std::uint8_t {
    kUnknown,
    kValue,
    kFunction,
    kFunctionTemplate,
    kType,
    kNamespace
  };

  // One level of recursion. `weight` is how many tree nodes it can put on a path; not ok: the limit
  // was reported.
  class Nesting {
   public:
    explicit Nesting(Parser& parser, int weight = 1);
    ~Nesting();
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    bool ok() const { return ok_; }

   private:
    Parser& parser_;
    int weight_;
    bool ok_;
  };

  // Inside brackets, `>` is an operator again.
  class Bracketed {
   public:
    explicit Bracketed(Parser& parser, bool greater_ends = false)
        : parser_(parser), outer_(std::exchange(parser.greater_ends_, greater_ends)) {}
    ~Bracketed() { parser_.greater_ends_ = outer_; }
    Bracketed(const Bracketed&) = delete;
    Bracketed& operator=(const Bracketed&) = delete;

   private:
    Parser& parser_;
    bool outer_;
  };

  // Names declared while it lives are forgotten afterwards.
  class NameScope {
   public:
    explicit NameScope(Parser& parser) : parser_(parser), mark_(parser.undo_.size()) {}
    ~NameScope();
    NameScope(const NameScope&) = delete;
    NameScope& operator=(const NameScope&) = delete;

   private:
    Parser& parser_;
    std::size_t mark_;
  };

  // Gathers the children of one node on a stack shared by all nodes of a kind.
  template <typename T>
  class Collector {
   public:
    explicit Collector(std::vector<T>& stack) : stack_(stack), mark_(stack.size()) {}
    ~Collector() {
      if (!finished_) Drop();
    }
    Collector(const Collector&) = delete;
    Collector& operator=(const Collector&) = delete;
    void Add(T value) { stack_.push_back(std::move(value)); }
    std::size_t size() const { return stack_.size() - mark_; }
    T last() const { return stack_.back(); }
    void RemoveLast() { stack_.pop_back(); }
    // Moves what was gathered to `pool`; an outer Collector may go on afterwards.
    List<T> Finish(Pool<T>& pool) {
      List<T> list;
      if (size() > 0) list = pool.Add(std::span<const T>(stack_.data() + mark_, size()));
      Drop();
      finished_ = true;
      return list;
    }

   private:
    void Drop() { stack_.erase(stack_.begin() + static_cast<std::ptrdiff_t>(mark_), stack_.end()); }

    bool finished_ = false;
    std::vector<T>& stack_;
    std::size_t mark_;
  };

  // What stands before a declarator.
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

  // ---- tokens (parse.cpp)
  const Token& Peek() const { return tokens_[pos_]; }
  const Token& Peek(std::size_t ahead) const {
    return tokens_[std::min(pos_ + ahead, tokens_.size() - 1)];
  }
  bool At(TokenKind kind) const { return Peek().kind == kind; }
  bool AtEnd() const { return At(TokenKind::kEnd); }
  const Token& Next() { return AtEnd() ? tokens_[pos_] : tokens_[pos_++]; }
  bool Accept(TokenKind kind) {
    if (!At(kind) || AtEnd()) return false;
    ++pos_;
    return true;
  }
  Span Here() const { return Peek().span(); }
  Span PreviousSpan() const;
  // From the token at `start` to the last one consumed.
  Span SpanFrom(std::size_t start) const {
    return start >= pos_ ? Here() : Cover(tokens_[start].span(), tokens_[pos_ - 1].span());
  }
  Word WordOf(const Token& token) const {
    return token.kind == TokenKind::kIdentifier ? words_[token.name().index].word : Word::kNone;
  }
  Word WordAt() const { return WordOf(Peek()); }
  Word WordAt(std::size_t ahead) const { return WordOf(Peek(ahead)); }
  const WordInfo& InfoOfName(Name name) const { return words_[name.index]; }
  bool AtWord(Word word) const { return WordAt() == word; }
  // At an identifier that can be the name of something.
  bool AtName(std::size_t ahead = 0) const {
    const Token& token = Peek(ahead);
    return token.kind == TokenKind::kIdentifier && !IsReserved(words_[token.name().index].word);
  }
  std::string_view Text(Name name) const { return file_.names[name]; }
  void SplitGreater();
  void RemovePragmas();
  Qualifiers PackingHere();

  // ---- names (parse.cpp)
  Name Intern(std::string_view text);
  void Declare(Name name, Meaning meaning);
  Meaning MeaningOf(Name name) const;
  bool IsTypeName(std::size_t ahead) const;

  // ---- errors and recovery (parse_error.cpp)
  std::string Describe(std::size_t ahead = 0) const;
  void Unexpected(std::string_view expected);
  template <typename... Args>
  Diagnostic* Error(Span where, const diag::Kind<Args...>& kind,
                    const std::type_identity_t<Args>&... args);
  void Abort();
  bool Expect(TokenKind kind, std::string_view expected);
  bool ExpectClose(TokenKind close, std::size_t open);
  bool ExpectSemicolon(std::string_view after);
  std::string PreviousText() const;
  bool AtDeclarationWord() const;
  void SkipBalanced();
  void SkipToClose(TokenKind close, bool past_semicolons = false);
  void SyncStatement();
  void SyncDeclaration(Scope scope);

  // ---- looking ahead (parse_lookahead.cpp); positions are relative to the current token, 0 means "no"
  std::size_t SkipTemplateArguments(std::size_t ahead) const;
  std::size_t SkipBrackets(std::size_t ahead) const;
  std::size_t SkipTypeName(std::size_t ahead) const;
  std::size_t SkipQualifiers(std::size_t ahead) const;
  bool IsQualifier(std::size_t ahead) const;
  bool IsCast() const;
  bool IsDeclaration() const;
  bool IsTemplateUse(Name name, std::size_t less) const;
  bool IsMemberTemplateUse(std::size_t less) const;
  bool StartsType(std::size_t ahead) const;
  bool StructEndsHere() const;

  // ---- types, qualifiers, attributes (parse_type.cpp)
  TypeId ParseType(bool may_define);
  TypeId AddType(Type type, std::uint32_t height_of_definition = 0);
  TypeId ParseNamedType();
  TypeId ParseTaggedType(bool may_define);
  Name ParseUnsigned();
  QualifiedName ParseQualifiedName();
  List<ExprId> ParseTemplateArguments();
  ExprId ParseTemplateArgument();
  bool AtTypeArgument() const;
  ExprId ParseTypeOperand();
  Qualifiers ParseQualifiers(Collector<Attr>* attributes);
  void ParseAttributes(Collector<Attr>& attributes);
  void ParseAttributeList(Collector<Attr>& attributes);
  bool ParseAttribute(Collector<Attr>& attributes, std::size_t start);
  List<ExprId> ParseDimensions();

  // ---- declarations (parse_decl.cpp)
  using Decls = Collector<DeclId>;
  void ParseTopLevel();
  bool AtOutsideStatement() const;
  void ParseOutsideStatements();
  void ParseMembers(Decls& decls, Scope scope, std::size_t open);
  void ParseDeclaration(Decls& decls, Scope scope);
  bool ParseKeywordDeclaration(Decls& decls, Scope scope);
  Specifiers ParseSpecifiers(std::string_view expected);
  void ParseSpecified(Decls& decls, Scope scope, const TemplateHeader& header);
  bool ParseTypeOnly(Decls& decls, const Specifiers& specifiers);
  void ParseVariables(Decls& decls, Scope scope, const Specifiers& specifiers);
  void ParseBuffer(Decls& decls, const Specifiers& specifiers);
  void ParseNamespace(Decls& decls);
  void ParseTypedef(Decls& decls);
  void ParseUsing(Decls& decls);
  void ParseStaticAssert();

  // ---- functions (parse_function.cpp)
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

  // ---- structs and enums (parse_struct.cpp)
  DeclId ParseStruct(const TemplateHeader& header);
  void ParseEndOfType(DeclId definition);
  std::string DescribeType(DeclId definition) const;
  List<TypeId> ParseBases();
  DeclId ParseEnum();
  List<Enumerator> ParseEnumerators();

  // ---- declarators (parse_declarator.cpp)
  bool ParseDeclaratorName(Name& name, Span& span, std::string_view expected);
  void ParseDeclaratorTail(VarDecl& var, Scope scope);
  void ParseColonPart(VarDecl& var, Collector<RegisterBinding>& registers);
  void ParseInitializer(VarDecl& var);
  ExprId ParseInitValue();
  ExprId ParseInitList();
  RegisterBinding ParseRegister();
  bool ParseRegisterOperand(RegisterBinding& binding);
  std::optional<PackOffset> ParsePackOffset();
  bool ParsePackOffsetOperand(PackOffset& offset);
  Semantic ParseSemantic();

  // ---- the effects framework (parse_effect.cpp)
  void ParseTechnique();
  void SkipAnnotation();
  bool AtStateBlock() const;
  void SkipEffectBlock();
  void SkipEffectValue();
  void NoteCompile();

  // ---- statements (parse_stmt.cpp)
  using Stmts = Collector<StmtId>;
  StmtId ParseStatement();
  StmtId ParseUnattributed(std::size_t start);
  StmtId ParseBlock();
  StmtId ParseIf(std::size_t start);
  StmtId ParseFor();
  StmtId ParseForInit();
  StmtId ParseWhile();
  StmtId ParseDo();
  StmtId ParseSwitch();
  StmtId ParseCase();
  StmtId ParseReturn();
  StmtId ParseSimple();
  StmtId ParseDeclStatement();
  StmtId ParseExprStatement();
  StmtId ParseBody(std::string_view of);
  ExprId ParseCondition(std::string_view of);
  StmtId AddStmt(std::size_t start, decltype(Stmt::node) node);

  // ---- expressions (parse_expr.cpp)
  ExprId ParseExpression();
  ExprId ParseAssignment();
  ExprId ParseConditional();
  static constexpr int kAdditivePrecedence = 9;
  ExprId ParseBinary(int min_precedence);
  ExprId ParseUnary();
  ExprId ParsePrefix(UnaryOp op);
  ExprId ParseCast();
  ExprId ParseSizeof();
  ExprId ParsePostfix(ExprId base, std::size_t start);
  ExprId ParseMember(ExprId base, std::size_t start);
  ExprId ParsePrimary();
  ExprId ParseParenthesized();
  ExprId ParseLiteral();
  ExprId ParseString();
  ExprId ParseNameOrType();
  ExprId ParseMemberOfTemplate(const NameExpr& name, std::size_t start);
  List<ExprId> ParseArguments();
  ExprId AddExpr(std::size_t start, decltype(Expr::node) node);
  // Nodes on one path of an expression or type; the rest of kMaxDepth is left to the statements
  // above it.
  static constexpr std::uint32_t kMaxHeight = kMaxDepth / 2 - 20;
  bool CheckHeight(std::uint32_t height, Span span);
  ExprId ErrorExprHere();
  std::uint32_t HeightOf(const decltype(Expr::node)& node) const;
  std::uint32_t HeightOf(List<ExprId> list) const;
  std::uint32_t HeightOf(ExprId id) const { return id ? heights_[id.index] : 0; }
  std::uint32_t HeightOf(TypeId id) const { return id ? type_heights_[id.index] : 0; }

  template <typename Node>
  DeclId AddDecl(std::size_t start, Node node) {
    return file_.decls.Add(Decl{SpanFrom(start), std::move(node)});
  }

  Diagnostics& diagnostics_;
  File file_;
  std::vector<Token> tokens_;
  std::size_t pos_ = 0;
  bool panic_ =
      false;  // an error was reported and the parser has not found its feet again: report nothing
  bool aborted_ = false;           // a limit was reached: the rest of the text is not read
  bool outside_reported_ = false;  // a statement outside a function is reported once
  // A function definition was found inside a function: a `}` is missing, and all blocks end here.
  bool leaving_function_ = false;

  struct PackingChange {
    std::size_t position;
    bool row_major;
  };
  std::vector<PackingChange> packing_;
  std::size_t next_packing_ = 0;
  Qualifiers current_packing_ = 0;

  std::vector<WordInfo> words_;    // by Name
  std::vector<Meaning> meanings_;  // by Name, in the current scope
  std::vector<Meaning>
      beyond_;  // by Name: declared as a type or template in some scope, maybe not this one
  std::vector<bool> technique_names_;
  std::vector<std::pair<Name, Meaning>> undo_;

  bool greater_ends_ = false;  // in template arguments: `>` is no operator
  int nesting_ = 0;
  int depth_ = 0;
  int deepest_ = 0;                          // the largest depth_ since it was last set
  std::vector<std::uint16_t> heights_;       // by Expr: nodes on its longest path
  std::vector<std::uint32_t> type_heights_;  // by Type: the same
  std::uint32_t tallest_ = 0;                // the largest of heights_ since it was last set

  std::vector<ExprId> expr_stack_;
  std::vector<StmtId> stmt_stack_;
  std::vector<DeclId> decl_stack_;
  std::vector<TypeId> type_stack_;
  std::vector<Name> name_stack_;
  std::vector<Attr> attr_stack_;
  std::vector<RegisterBinding> register_stack_;
  std::vector<Enumerator> enumerator_stack_;
  std::vector<TemplateParameter> template_parameter_stack_;
};

template <typename... Args>
Diagnostic* Parser::Error(Span where, const diag::Kind<Args...>& kind,
                          const std::type_identity_t<Args>&... args) {
  if (panic_ || aborted_) return nullptr;
  panic_ = true;
  Diagnostic& report = diagnostics_.Report(where, kind, args...);
  if (diagnostics_.TooManyErrors()) Abort();
  return &report;
}

}  // namespace clipc::ast
