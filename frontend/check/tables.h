// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "base/kept_blocks.h"
#include "frontend/check/out_of_line.h"
#include "frontend/check/symbols.h"
#include "frontend/parse/ast.h"
#include "frontend/resolve/resolve_objects.h"
#include "ir/program.h"

// What the checker knows of the text's types and of the variables outside of functions.
namespace clipc::check {

// The structs and enums of the text.
struct Structs {
  std::deque<StructInfo, KeptAllocator<StructInfo>> infos;  // by StructId
  // The types that are defined inside another declaration, by DeclId.
  KeptMap<std::uint32_t, SymbolId> symbols;
  // The values of enums, as far as they are known, by the SymbolId of the enum.
  KeptMap<std::uint32_t, KeptVector<std::int64_t>> enum_values;
  // The specialisations `template<> struct S<float> {..}`, by the SymbolId of the template.
  KeptMap<std::uint32_t, KeptVector<ast::DeclId>> specialisations;
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
  KeptVector<Ordered> reached, resources;
  KeptMap<std::uint32_t, Register> registers;              // by VarId of a resource
  StructRegisters struct_registers;                        // of uniform structs
  KeptMap<std::uint32_t, std::string> formats;             // by VarId of an image
  KeptMap<std::uint32_t, std::uint32_t> attachments;       // by VarId of a subpass input
  KeptMap<std::uint32_t, std::uint32_t> counter_bindings;  // by VarId of a buffer
  // The components of initial values, by VarId of a member of a buffer.
  KeptMap<std::uint32_t, std::vector<std::uint64_t>> initial;
  OutOfLine out_of_line;
  KeptVector<bool> const_vars;  // by VarId
  KeptVector<VarId> patches;    // parameters that are patches
  // The `const` global variables whose values stood where a constant is needed.
  KeptVector<SymbolId> used_as_constants;
  // The static variables of functions that get their values where they are declared:
  // static_local.h.
  struct Late {
    VarId var, flag;
    StmtId stmt;  // the If around the assignments to both
    FunctionId function;
    bool may_repeat;  // whether the declaration is in a loop or switch
  };
  KeptVector<Late> late;
  // The statements at the beginning of `main` that give static variables their first values, once
  // these are in the program.
  std::vector<StmtId> first_values;
};

}  // namespace clipc::check
