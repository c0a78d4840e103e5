// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

#include "frontend/check/out_of_line.h"
#include "frontend/check/symbols.h"
#include "frontend/parse/ast.h"
#include "frontend/resolve/resolve_objects.h"
#include "ir/program.h"

// What the checker knows of the text's types and of the variables outside of functions.
namespace clipc::check {

// The structs and enums of the text.
struct Structs {
  std::deque<StructInfo> infos;  // by StructId
  // The types that are defined inside another declaration, by DeclId.
  std::unordered_map<std::uint32_t, SymbolId> symbols;
  // The values of enums, as far as they are known, by the SymbolId of the enum.
  std::unordered_map<std::uint32_t, std::vector<std::uint32_t>> enum_values;
  // The specialisations `template<> struct S<float> {..}`, by the SymbolId of the template.
  std::unordered_map<std::uint32_t, std::vector<ast::DeclId>> specialisations;
  bool IsSpecialisation(SymbolId symbol, ast::DeclId decl) const {
    const auto found = specialisations.find(symbol.index);
    return found != specialisations.end() &&
           std::ranges::find(found->second, decl) != found->second.end();
  }
};

// The variables outside functions.
struct Globals {
  struct Ordered {
    std::uint32_t order;  // the place of the declaration, from OrderOf
    VarId var;
  };
  Arena<Buffer> buffers;
  BufferId buffer;         // the buffer $Globals
  BufferId params_buffer;  // the buffer $Params; none before the first `uniform` parameter
  // The static variables and the resources that something reached uses.
  std::vector<Ordered> reached, resources;
  std::unordered_map<std::uint32_t, Register> registers;              // by VarId of a resource
  StructRegisters struct_registers;                                   // of uniform structs
  std::unordered_map<std::uint32_t, std::string> formats;             // by VarId of an image
  std::unordered_map<std::uint32_t, std::uint32_t> attachments;       // by VarId of a subpass input
  std::unordered_map<std::uint32_t, std::uint32_t> counter_bindings;  // by VarId of a buffer
  // The components of initial values, by VarId of a member of a buffer.
  std::unordered_map<std::uint32_t, std::vector<std::uint64_t>> initial;
  OutOfLine out_of_line;
  std::vector<bool> const_vars;  // by VarId
  std::vector<VarId> patches;    // parameters that are patches
  // The `const` global variables whose values stood where a constant is needed.
  std::vector<SymbolId> used_as_constants;
  // The static variables of functions that get their values where they are declared:
  // static_local.h.
  struct Late {
    VarId var, flag;
    StmtId stmt;  // the If around the assignments to both
    FunctionId function;
    bool may_repeat;  // whether the declaration is in a loop or switch
  };
  std::vector<Late> late;
};

}  // namespace clipc::check
