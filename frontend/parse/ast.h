// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "base/arena.h"
#include "base/id.h"
#include "base/names.h"
#include "base/span.h"
#include "frontend/lex/token.h"

// What was written: one node per construct of the source, names unresolved, nothing converted.
// Parentheses are not kept (the tree shows them). No path from a root is longer than kMaxDepth
// nodes, so walking a tree may recurse.
namespace clipc::ast {

inline constexpr int kMaxDepth = 1000;

struct Expr;
struct Stmt;
struct Decl;
struct Type;
using ExprId = Id<Expr>;
using StmtId = Id<Stmt>;
using DeclId = Id<Decl>;
using TypeId = Id<Type>;

// a::b::c, or ::c.
struct QualifiedName {
  Name name;
  List<Name> scopes;  // `a`, `b`
  bool from_global = false;
};

// ---- types

// A type as written: a (possibly templated) name, or a struct defined on the spot.
struct Type {
  Span span;
  QualifiedName
      // `float4`, `vector`, `Texture2D`, `ns::S`; `unsigned int` and `dword` arrive as `uint`
      name;
  List<ExprId> arguments;  // of <...>: types arrive as TypeExpr, `T[4]` as IndexExpr of one
  DeclId
      // `struct {...} x;` or `enum E {...} x;`; then name is the struct's, maybe none
      struct_definition;
  bool has_arguments = false;  // tells `Texture2D` from `Texture2D<>`
  TypeId outer;                // A<int> in `A<int>::T`, where the name is T; none otherwise
};

// ---- expressions

struct Literal {
  LiteralKind kind;
  std::uint64_t
      bits;  // integer value; bool 0 or 1; float kinds: a double's bits; string: Name index
};
struct NameExpr {
  QualifiedName name;
  List<ExprId> arguments;  // explicit template arguments: f<float>
};
// A type where an expression may stand: the callee of float4(...), a template argument, sizeof's
// operand.
struct TypeExpr {
  TypeId type;
};
enum class UnaryOp : std::uint8_t {
  kPlus,
  kMinus,
  kNot,
  kComplement,
  kPreIncrement,
  kPreDecrement,
  kPostIncrement,
  kPostDecrement
};
struct UnaryExpr {
  UnaryOp op;
  ExprId operand;
};
enum class BinaryOp : std::uint8_t {
  kMul,
  kDiv,
  kMod,
  kAdd,
  kSub,
  kShiftLeft,
  kShiftRight,
  kLess,
  kGreater,
  kLessEqual,
  kGreaterEqual,
  kEqual,
  kNotEqual,
  kBitAnd,
  kBitXor,
  kBitOr,
  kLogicalAnd,
  kLogicalOr,
  kComma
};
struct BinaryExpr {
  BinaryOp op;
  ExprId left, right;
  Span op_span;
};
// left = right, or left op= right.
struct AssignExpr {
  std::optional<BinaryOp> op;
  ExprId left, right;
};
struct ConditionalExpr {
  ExprId condition, when_true, when_false;
};
// f(a), float4(a, b) (callee is a TypeExpr), o.m(a) (callee is a MemberExpr).
struct CallExpr {
  ExprId callee;
  List<ExprId> arguments;
};
// (T)e, (T[3])e.
struct CastExpr {
  TypeId type;
  List<ExprId> dimensions;
  ExprId operand;
};
struct IndexExpr {
  ExprId base, index;
};
// base.name: a field, a swizzle or a method; the checker tells. Also S<int>::x, where base is a
// TypeExpr.
struct MemberExpr {
  ExprId base;
  Name name;
  Span name_span;
  List<ExprId> arguments;  // explicit template arguments: buffer.Load<float4>(0)
};
// {a, {b, c}}; a trailing comma is allowed.
struct InitListExpr {
  List<ExprId> elements;
};
struct SizeofExpr {
  ExprId operand;  // a TypeExpr or any expression
};
// Where the parser reported an error.
struct ErrorExpr {};

struct Expr {
  Span span;
  std::variant<Literal, NameExpr, TypeExpr, UnaryExpr, BinaryExpr, AssignExpr, ConditionalExpr,
               CallExpr, CastExpr, IndexExpr, MemberExpr, InitListExpr, SizeofExpr, ErrorExpr>
      node;
};

// ---- attributes: [name], [name(arguments)], [[ns::name(arguments)]]

struct Attr {
  Span span;  // with the brackets
  Name name;
  Span name_span;
  List<ExprId> arguments;
  bool has_parens = false;
};

// ---- statements

struct BlockStmt {
  List<StmtId> body;
};
struct DeclStmt {
  List<DeclId> decls;  // variables of one declaration, or one struct, typedef, `using` or prototype
};
struct ExprStmt {
  ExprId expr;
};
struct IfStmt {
  ExprId condition;
  StmtId then, otherwise;  // otherwise may be none
};
struct ForStmt {
  StmtId init;            // DeclStmt, ExprStmt or none
  ExprId condition;       // or none
  DeclId condition_decl;  // for (; int x = f(); ) is not HLSL; kept none
  ExprId step;            // or none
  StmtId body;
};
struct WhileStmt {
  ExprId condition;
  StmtId body;
};
struct DoStmt {
  StmtId body;
  ExprId condition;
};
// body is a BlockStmt whose statements include CaseStmts as labels.
struct SwitchStmt {
  ExprId value;
  StmtId body;
};
// `case value:`, or `default:` when value is none. A label only; the statements follow it in the
// block.
struct CaseStmt {
  ExprId value;
};
struct ReturnStmt {
  ExprId value;  // or none
};
struct BreakStmt {};
struct ContinueStmt {};
struct DiscardStmt {};
struct EmptyStmt {};
struct ErrorStmt {};

struct Stmt {
  Span span;
  List<Attr> attributes;
  std::variant<BlockStmt, DeclStmt, ExprStmt, IfStmt, ForStmt, WhileStmt, DoStmt, SwitchStmt,
               CaseStmt, ReturnStmt, BreakStmt, ContinueStmt, DiscardStmt, EmptyStmt, ErrorStmt>
      node;
};

// ---- declarations

// Bits of Qualifiers.
enum Qualifier : std::uint32_t {
  kConst = 1u << 0,
  kStatic = 1u << 1,
  kUniform = 1u << 2,
  kExtern = 1u << 3,
  kVolatile = 1u << 4,
  kInline = 1u << 5,
  kIn = 1u << 6,
  kOut = 1u << 7,  // inout sets both
  kRowMajor = 1u << 8,
  kColumnMajor = 1u << 9,
  kPackRowMajor =
      1u << 10,  // #pragma pack_matrix(row_major) is in force here (not a written qualifier)
  kNoInterpolation = 1u << 11,
  kLinear = 1u << 12,
  kCentroid = 1u << 13,
  kNoPerspective = 1u << 14,
  kSample = 1u << 15,
  kPrecise = 1u << 16,
  kShared = 1u << 17,
  kGroupShared = 1u << 18,
  kSnorm = 1u << 19,
  kUnorm = 1u << 20,
  kGloballyCoherent = 1u << 21,
  kExport = 1u << 22,
  kTemplateParameterDefault = 1u << 23,
  kPackColumnMajor = 1u << 24,  // #pragma pack_matrix(column_major) is in force here
};
using Qualifiers = std::uint32_t;

struct Semantic {
  Name name;  // none: no semantic
  Span span;
};
// register(profile?, c3[1], space2). Letters b c t s u i.
struct RegisterBinding {
  Span span;
  char letter = 0;  // lower case; 0 for register(space2) alone
  std::uint32_t number = 0;
  std::uint32_t space = 0;
  Name profile;         // register(vs_5_0, b0): holds only for that profile
  ExprId subcomponent;  // c3[1], rare; none otherwise
};
// packoffset(c3.y)
struct PackOffset {
  Span span;
  std::uint32_t reg = 0;
  std::uint32_t component = 0;  // 0..3
};

// A variable, parameter, struct field or cbuffer member: one declarator.
struct VarDecl {
  Name name;  // none: an unnamed parameter
  Span name_span;
  TypeId type;
  List<ExprId> dimensions;  // outermost first; an id that is none: `[]`
  Qualifiers qualifiers = 0;
  Semantic semantic;
  List<RegisterBinding> registers;
  std::optional<PackOffset> packoffset;
  ExprId init;  // an expression, an InitListExpr, or none
  bool has_state_block =
      false;  // `= sampler_state {...}`, `{ Filter = ...; }`, `= compile vs_2_0 f()`: skipped
  ExprId bit_width;  // of a bit-field `uint a : 3;`, or none
  List<Attr> attributes;
  QualifiedName out_of_line_of;  // S in `int S::x = 1;`; name none otherwise
};
struct TemplateParameter {
  Span span;
  Name name;
  bool is_type = true;  // `typename T`; otherwise a value of `type`
  TypeId type;
  ExprId default_value;  // a TypeExpr for a type parameter; or none
};
struct FunctionDecl {
  Name name;  // `operator+` for operators
  Span name_span;
  QualifiedName out_of_line_of;  // S in `float S::f() {...}`; name none otherwise
  TypeId return_type;
  List<ExprId> return_dimensions;
  Qualifiers qualifiers = 0;
  List<Attr> attributes;
  List<DeclId> parameters;  // VarDecls
  Semantic return_semantic;
  StmtId body;  // a BlockStmt; none: a prototype
  List<TemplateParameter> template_parameters;
  List<ExprId>
      // of a specialisation `float f<float>(float x)`, or of the class in `T S<T>::f()`
      template_arguments;
  bool is_template = false;
  bool is_const_method = false;
};
enum class StructKind : std::uint8_t { kStruct, kClass, kInterface };
struct StructDecl {
  StructKind kind;
  Name name;  // or none
  Span name_span;
  List<TypeId> bases;
  List<DeclId> members;       // VarDecls, FunctionDecls, nested types
  bool is_definition = true;  // false: a forward declaration `struct S;`
  List<TemplateParameter> template_parameters;
  List<ExprId> template_arguments;  // of a specialisation: `template<> struct S<float> {...};`
  bool is_template = false;
  List<Attr> attributes;
};
struct TypedefDecl {
  Name name;
  Span name_span;
  TypeId type;
  List<ExprId> dimensions;
  Qualifiers qualifiers = 0;
};
enum class BufferKind : std::uint8_t { kCbuffer, kTbuffer };
struct BufferDecl {
  BufferKind kind;
  Name name;  // or none
  Span name_span;
  List<RegisterBinding> registers;
  List<DeclId>
      members;  // VarDecls; also structs and functions, which HLSL puts in the enclosing scope
  List<Attr> attributes;
};
struct NamespaceDecl {
  Name name;
  Span name_span;
  List<DeclId> members;
};
struct Enumerator {
  Name name;
  Span span;
  ExprId value;  // or none
};
struct EnumDecl {
  Name name;  // or none
  Span name_span;
  bool is_class = false;
  TypeId underlying;  // or none
  List<Enumerator> enumerators;
};
// `using namespace a::b;`, or `using a::b;`. `using T = float4;` is a TypedefDecl.
struct UsingDecl {
  QualifiedName name;
  bool is_namespace = true;
};

struct Decl {
  Span span;
  std::variant<VarDecl, FunctionDecl, StructDecl, TypedefDecl, BufferDecl, NamespaceDecl, EnumDecl,
               UsingDecl>
      node;
};

// A parsed translation unit. Technique, pass and state blocks were skipped; the names of the
// functions that techniques compile as vertex shaders are kept as hints for "entry point not
// found".
struct File {
  Names names;
  Arena<Expr> exprs;
  Arena<Stmt> stmts;
  Arena<Decl> decls;
  Arena<Type> types;
  Pool<ExprId> expr_lists;
  Pool<StmtId> stmt_lists;
  Pool<DeclId> decl_lists;
  Pool<TypeId> type_lists;
  Pool<Name> name_lists;
  Pool<Attr> attrs;
  Pool<RegisterBinding> registers;
  Pool<Enumerator> enumerators;
  Pool<TemplateParameter> template_parameters;
  std::vector<DeclId> top_level;
  std::vector<Name> technique_vertex_shaders;
};

}  // namespace clipc::ast
