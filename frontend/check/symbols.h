// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "base/arena.h"
#include "base/id.h"
#include "base/span.h"
#include "frontend/parse/ast.h"
#include "frontend/rules/rules.h"

// What the checker knows about each declaration. In this room the program's types and functions,
// and the rules about them, go by their plain names; those of the syntax tree begin with `ast::`.
namespace clipc::check {

using namespace ir;
using namespace rules;

struct Symbol;
struct Scope;
struct Buffer;
struct FunctionInfo;
using SymbolId = Id<Symbol>;
using ScopeId = Id<Scope>;
using BufferId = Id<Buffer>;
using FunctionInfoId = Id<FunctionInfo>;

// The comment after a kind says what Symbol::value is.
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
  bool is_const = false;                      // a uniform variable that is declared `const`
  bool is_leaked = false;  // the variable of a finished `for`, which fxc leaves visible
  Name name;
  ScopeId scope;   // none for a local of a function
  SymbolId older;  // the symbol of that name before it in the scope; the local that this one hides
  ast::DeclId decl;  // none for a template argument
  Span span;
  std::uint32_t value = ~0u;
  // A variable: the Buffer that it is a member of; a leaked one: its ir::For. A type: the ScopeId
  // of an enum. An enumerator: the SymbolId of its enum. A template value: its ir::TypeId.
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
  // The members see the symbols of namespaces before this one. Those of a namespace do not use it:
  // each sees the symbols before itself.
  std::uint32_t order = ~0u;
  TypeId self;                  // the type of a struct
  std::vector<ScopeId> nested;  // namespaces that `using` names, scopes of base structs
};

// A cbuffer, or what becomes one: $Globals, $Params, a ConstantBuffer<T>.
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
};

// What the checker knows about a struct besides its ir::Struct.
struct StructInfo {
  ast::DeclId decl;
  ScopeId scope;
  std::vector<TypeId> bases;
  std::vector<Name> fields;      // in the order of ir::Struct::fields
  std::uint64_t components = 0;  // of a value of this type
  int depth = 1;                 // how deep structs and arrays nest in it
};

// One overload: a declaration with the types that it has in one instance and for one `this`.
struct FunctionInfo {
  ast::DeclId decl;            // the definition when there is one
  ScopeId scope;               // where the names of its types and body are looked up
  std::uint32_t order = 0;     // of what they see
  std::uint32_t declared = 0;  // the order of the first declaration
  bool is_resolved = false;    // whether the signature is known
  bool is_broken = false;      // the signature has errors, which were reported
  bool is_instance = false;    // of a template
  bool changes_self = false;   // the method may change its object
  std::uint32_t required = 0;  // the number of parameters without a default
  TypeId return_type;
  List<Parameter> parameters;
  TypeId self;          // the struct of a method; none for functions and static methods
  FunctionId function;  // none until the function is reached
};

}  // namespace clipc::check
