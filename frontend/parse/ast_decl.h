// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "frontend/parse/ast_expr.h"

// Declarations of the syntax tree.
namespace clipc::ast {

// The position of each qualifier in qualifier_bits.def.
namespace qualifier_position {
enum : std::uint32_t {
#define QUALIFIER(bit, spelling, word) bit,
#define PACKING(bit, text) bit,
#include "frontend/parse/qualifier_bits.def"
};
}  // namespace qualifier_position

// A set of the bits that qualifier_bits.def names: kConst, kStatic, ...
using Qualifiers = std::uint32_t;
enum Qualifier : Qualifiers {
#define QUALIFIER(bit, spelling, word) bit = 1u << qualifier_position::bit,
#define PACKING(bit, text) bit = 1u << qualifier_position::bit,
#include "frontend/parse/qualifier_bits.def"
};

struct Semantic {
  Name name;  // none: there is no semantic
  Span span;
};
// register(profile, c3[1], space2), each part but one optional. The letter is b, c, i, s, t or u.
struct RegisterBinding {
  // What a register has too much: text after its number or in the place of one, as in c1abc and
  // banana, or a number of the profile, as in register(ps[5], c1). fxc takes some of these.
  enum class Rest : std::uint8_t { kNone, kText, kProfileNumber };
  Span span;
  char letter = 0;  // lower case; 0 for register(space2)
  std::uint32_t number = 0;
  std::uint32_t space = 0;
  bool has_space = false;  // whether the space is written
  Name profile;            // vs_5_0 in register(vs_5_0, b0), which is for it only; or none
  ExprId subcomponent;     // 1 in c3[1]; or none
  Rest rest = Rest::kNone;
};
// The place of a member in its cbuffer, as in packoffset(c3.y).
struct PackOffset {
  Span span;
  std::uint32_t reg = 0;
  std::uint32_t component = 0;  // 0..3
};

// One declarator: a variable, a parameter, a field of a struct or a member of a cbuffer.
struct VarDecl {
  Name name;  // none: an unnamed parameter or bit-field
  Span name_span;
  TypeId type;
  List<ExprId> dimensions;  // outermost first; an id that is none: `[]`
  Qualifiers qualifiers = 0;
  Semantic semantic;
  List<RegisterBinding> registers;
  std::optional<PackOffset> packoffset;
  ExprId init;  // an expression, an InitListExpr, or none
  // Whether `= sampler_state {...}`, `{ Filter = ...; }` or `= compile vs_2_0 f()` was skipped.
  bool has_state_block = false;
  ExprId bit_width;  // 3 in the bit-field `uint a : 3;`, or none
  List<Attr> attributes;
  QualifiedName out_of_line_of;  // S in `int S::x = 1;`; otherwise its name is none
};
struct TemplateParameter {
  Span span;
  Name name;
  bool is_type = true;   // true: `typename T`; false: a value of `type`
  TypeId type;           // none for a type parameter
  ExprId default_value;  // a TypeExpr for a type parameter; or none
};
struct FunctionDecl {
  Name name;  // `operator+` for operators
  Span name_span;
  QualifiedName out_of_line_of;  // S in `float S::f() {...}`; otherwise its name is none
  TypeId return_type;
  List<ExprId> return_dimensions;
  Qualifiers qualifiers = 0;
  List<Attr> attributes;
  List<DeclId> parameters;  // VarDecls
  Semantic return_semantic;
  StmtId body;  // a BlockStmt; none for a prototype
  List<TemplateParameter> template_parameters;
  // The arguments of the specialisation `float f<float>(float x)`, or of the class in `T
  // S<T>::f()`.
  List<ExprId> template_arguments;
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
  List<ExprId> template_arguments;  // of the specialisation `template<> struct S<float> {...};`
  bool is_template = false;
  List<Attr> attributes;
};
struct TypedefDecl {
  Name name;
  Span name_span;
  TypeId type;
  List<ExprId> dimensions;
  Qualifiers qualifiers = 0;
  List<TemplateParameter> template_parameters;  // of `template<int N> using A = B<N>;`
  bool is_template = false;
};
enum class BufferKind : std::uint8_t { kCbuffer, kTbuffer };
struct BufferDecl {
  BufferKind kind;
  Name name;  // or none
  Span name_span;
  List<RegisterBinding> registers;
  // The VarDecls; also structs and functions, which HLSL puts in the scope around the buffer.
  List<DeclId> members;
  List<Attr> attributes;
};
struct NamespaceDecl {
  Name name;  // or none
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

}  // namespace clipc::ast
