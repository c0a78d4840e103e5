// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "base/arena.h"
#include "base/id.h"
#include "base/span.h"
#include "frontend/parse/ast.h"
#include "ir/program.h"

// What the checker knows of each declaration. Included by checker.h only.
namespace clipc::check {

struct Symbol;
struct Scope;
struct Buffer;
struct FunctionInfo;
using SymbolId = Id<Symbol>;
using ScopeId = Id<Scope>;
using BufferId = Id<Buffer>;
using FunctionInfoId = Id<FunctionInfo>;

enum class SymbolKind : std::uint8_t {
  kVariable,       // value: ir::VarId
  kField,          // value: the field's number in the struct whose scope it stands in
  kFunction,       // value: FunctionInfoId
  kType,           // value: ir::TypeId
  kEnumerator,     // value: the 32 bits of the number
  kNamespace,      // value: ScopeId
  kTemplateValue,  // value: the 32 bits of the number; owner: its ir::TypeId
};
enum class Resolution : std::uint8_t { kNone, kUnderWay, kDone };

// A name in a scope. Symbols of namespaces are numbered in the order of the text, which tells what
// a use may see.
struct Symbol {
  SymbolKind kind = SymbolKind::kVariable;
  Resolution resolution = Resolution::kNone;  // whether `value` is set
  bool is_const = false;
  bool is_leaked = false;  // the variable of a finished `for`, which fxc leaves visible
  Name name;
  ScopeId scope;     // none: local to a function
  SymbolId older;    // of the same name: in the same scope; for a local, the one it hides
  ast::DeclId decl;  // none: a template argument
  Span span;
  std::uint32_t value = ~0u;
  // A variable: the Buffer it is a member of; a leaked one: its ir::For. An enum: its ScopeId. An
  // enumerator: its enum.
  std::uint32_t owner = ~0u;
};

enum class ScopeKind : std::uint8_t { kNamespace, kStruct, kEnum, kTemplate };
struct Scope {
  ScopeKind kind = ScopeKind::kNamespace;
  ScopeId parent;
  Name name;
  std::uint32_t order =
      // what its members see of namespaces; kNamespace: each member sees what stands before it
      ~0u;
  ir::TypeId self;              // kStruct
  std::vector<ScopeId> nested;  // namespaces that `using` names, scopes of base structs
};

// A cbuffer or what becomes one: $Globals, a ConstantBuffer<T>.
struct Buffer {
  ast::DeclId decl;  // none: $Globals, $Params
  ir::CbufferKind kind = ir::CbufferKind::kCbuffer;
  ScopeId scope;
  std::uint32_t order = 0;
  std::vector<SymbolId> members = {};
  Resolution resolution = Resolution::kNone;  // reached, when not kNone
};

struct Parameter {
  ast::DeclId decl;
  ast::DeclId with_default;  // the declaration that gives a default, or none
  ir::TypeId type;
  ir::Storage storage = ir::Storage::kIn;
};

// What a struct is beside its fields.
struct StructInfo {
  ast::DeclId decl;
  ScopeId scope;
  std::vector<ir::TypeId> bases;
  std::vector<Name> fields;  // as in ir::Struct
  std::uint64_t components = 0;
  int depth = 1;  // of structs and arrays inside each other
};

// One overload: a declaration with the types it has in one instantiation and for one `this`.
struct FunctionInfo {
  ast::DeclId decl;  // the definition when there is one
  ScopeId scope;     // where its types and body are looked up
  std::uint32_t order = 0;
  std::uint32_t declared = 0;  // the first declaration's order
  bool is_resolved = false;
  bool is_broken = false;    // its signature has errors, which were reported
  bool is_instance = false;  // of a template
  bool changes_self = false;
  std::uint32_t required = 0;  // parameters without a default
  ir::TypeId return_type;
  List<Parameter> parameters;
  ir::TypeId self;          // a method's struct; none for functions and static methods
  ir::FunctionId function;  // none: not reached
};

}  // namespace clipc::check
