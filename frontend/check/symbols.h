// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "base/arena.h"
#include "base/id.h"
#include "base/span.h"
#include "frontend/parse/ast.h"
#include "frontend/resolve/names.h"
#include "frontend/rules/names.h"
#include "frontend/signature/names.h"
#include "frontend/typing/names.h"

// The checker's records of declarations. In namespace check the types and functions of the program,
// and the rules about them, have their plain names; the types of the syntax tree begin with
// `ast::`.
namespace clipc::check {

using namespace ir;
using namespace resolve;
using namespace rules;
using namespace signature;
using namespace typing;

struct Symbol;
struct Scope;
struct Buffer;
struct FunctionInfo;
using SymbolId = Id<Symbol>;
using ScopeId = Id<Scope>;
using BufferId = Id<Buffer>;
using FunctionInfoId = Id<FunctionInfo>;

// The kind of a symbol. The comment after a kind gives the meaning of Symbol::value.
enum class SymbolKind : std::uint8_t {
  kVariable,       // an ir::VarId
  kField,          // the number of the field in the struct whose scope has the symbol
  kFunction,       // not used
  kType,           // an ir::TypeId
  kEnumerator,     // the number of the enumerator in its enum
  kNamespace,      // a ScopeId
  kTemplateValue,  // the 32 bits of the value
};
enum class Resolution : std::uint8_t { kNone, kUnderWay, kDone };

// A name in a scope. Symbols of namespaces are numbered in the order of the text, which decides
// which of them a use can see.
struct Symbol {
  SymbolKind kind = SymbolKind::kVariable;
  Resolution resolution = Resolution::kNone;  // whether `value` is set
  bool is_const = false;                      // whether it is a uniform declared `const`
  bool is_leaked = false;  // a variable of a finished `for`, which fxc leaves visible
  Name name;
  ScopeId scope;     // none for a local of a function
  SymbolId older;    // the symbol of this name before it in the scope; the local that it hides
  ast::DeclId decl;  // none for a template argument
  Span span;
  std::uint32_t value = ~0u;
  // The index of the Buffer that a variable is a member of, of the ir::For of a leaked variable, of
  // the Scope of a type that is an enum, of the Symbol of an enumerator's enum, of the ir::Type of
  // a template value.
  std::uint32_t owner = ~0u;

  void Resolve(std::uint32_t to) {
    value = to;
    resolution = Resolution::kDone;
  }
};

enum class ScopeKind : std::uint8_t { kNamespace, kStruct, kEnum, kTemplate };
struct Scope {
  ScopeKind kind = ScopeKind::kNamespace;
  ScopeId parent;
  Name name;
  // The order before which members see the symbols of namespaces. The members of a namespace do not
  // use it: each sees the symbols before itself.
  std::uint32_t order = ~0u;
  TypeId self;                  // the type of a struct
  std::vector<ScopeId> nested;  // namespaces that `using` names, scopes of base structs
};

// A cbuffer, or $Globals, $Params or a ConstantBuffer<T>, which become cbuffers.
struct Buffer {
  ast::DeclId decl = {};  // none for $Globals and $Params
  CbufferKind kind = CbufferKind::kCbuffer;
  ScopeId scope;
  std::uint32_t order = 0;
  std::vector<SymbolId> members = {};
  Resolution resolution = Resolution::kNone;  // kNone until the buffer is reached
};

struct Parameter {
  ast::DeclId decl;
  ast::DeclId with_default;  // the declaration with the default argument, or none
  TypeId type;
  Storage storage = Storage::kIn;
  SymbolId enumeration = {};  // the enum that the type is; none for other types
};

// A bit-field, which is a part of a field: uint a : 3 and uint b : 5 are one field `a_b`.
struct BitField {
  Name name;            // none: it is only room
  std::uint32_t field;  // the number of the field, as a Symbol has it
  TypeId type;          // int or uint, which is that of the field
  int first;            // the number of its lowest bit
  int width;            // 1..32
};

// A bit-field of a value: `word` is the field that it is a part of.
struct BitAccess {
  ExprId word;
  BitField bits;
};

// The checker's record of a struct besides its ir::Struct.
struct StructInfo {
  ast::DeclId decl;
  ScopeId scope;
  std::vector<TypeId> bases;
  std::vector<Name> fields;         // in the order of ir::Struct::fields
  std::vector<BitField> bits;       // in the order of the text
  bool holds_bits = false;          // whether it or a struct in it has bit-fields
  bool holds_objects = false;       // whether it or a struct in it has textures and the like
  std::uint64_t components = 0;     // the number in a value of this type; a bit-field is one
  std::uint64_t fields_of_all = 0;  // the number of fields, those of the fields' structs included
  int depth = 1;                    // the levels of structs and arrays in it
};

// One overload: a declaration with the types that it has in one instance and for one `this`.
struct FunctionInfo {
  ast::DeclId decl;            // the definition when there is one
  ScopeId scope;               // where the names of its types and body are looked up
  std::uint32_t order = 0;     // the symbols before it are what those names see
  std::uint32_t declared = 0;  // the order of the first declaration
  bool is_resolved = false;    // whether the signature is known
  bool is_broken = false;      // whether the signature has errors, which were reported
  bool is_instance = false;    // whether it is an instance of a template
  bool changes_self = false;   // whether the method may change its object
  std::uint32_t required = 0;  // the number of parameters without a default
  TypeId return_type;
  List<Parameter> parameters;
  TypeId self;          // the struct of a method; none for functions and static methods
  FunctionId function;  // none until the function is reached
};

}  // namespace clipc::check
