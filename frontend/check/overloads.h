// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "base/arena.h"
#include "base/kept_blocks.h"
#include "base/name.h"
#include "frontend/check/out_of_line.h"
#include "frontend/check/symbols.h"

namespace clipc::check {

// The functions, overload sets and instances of templates.
struct Overloads {
  explicit Overloads(const Names& names) {
    constexpr std::string_view kOperator = "operator";
    for (std::uint32_t i = 0; i < names.size(); ++i) {
      const std::string_view text = names[Name{i}];
      if (text.starts_with(kOperator) && text != kOperator)
        operators.emplace(text.substr(kOperator.size()), Name{i});
    }
  }
  // The function of a symbol, for objects of type `self` if it is a method; none before its
  // overload set was asked for.
  FunctionInfoId Known(SymbolId symbol, TypeId self) const {
    const auto found = of_symbol.find(KeyOf(symbol, self));
    return found == of_symbol.end() ? FunctionInfoId{} : found->second;
  }
  static std::uint64_t KeyOf(SymbolId symbol, TypeId self) {
    return std::uint64_t{symbol.index} << 32 | self.index;
  }
  FunctionInfo& operator[](FunctionInfoId id) { return infos[id]; }
  const FunctionInfo& operator[](FunctionInfoId id) const { return infos[id]; }
  std::span<Parameter> operator[](List<Parameter> list) { return parameters[list]; }
  std::span<const Parameter> operator[](List<Parameter> list) const { return parameters[list]; }

  // The names of the operators that the file declares: "operator+" by "+".
  KeptMap<std::string_view, Name> operators;
  Arena<FunctionInfo> infos;
  Pool<Parameter> parameters;
  // The functions of symbols, by KeyOf.
  KeptMap<std::uint64_t, FunctionInfoId> of_symbol;
  // The overload sets, by KeyOf the newest symbol of the name.
  KeptMap<std::uint64_t, KeptVector<FunctionInfoId>> overloads;
  OutOfLine out_of_line;
  // The specialisations `template<> int f<int>(int x)`, which have no name of their own, by the
  // Name of the template.
  KeptMap<std::uint32_t, KeptVector<SymbolId>> specialisations;
  // Whether a method changes its object, by DeclId.
  KeptMap<std::uint32_t, bool> changes_self;
  // The instances of templates, each the index of a TypeId or FunctionInfoId, by declaration, scope
  // and arguments.
  KeptMap<std::string, std::uint32_t> instances;
  bool has_too_many_instances = false;  // which was reported
  // The functions that are reached, in the order in which their bodies are checked.
  KeptVector<FunctionInfoId> waiting;
  struct CallEdge {
    FunctionId caller, callee;
    Span span;
  };
  KeptVector<CallEdge> calls;
  // The calls, on members of constant buffers, of methods that may change their objects.
  struct UniformCall {
    FunctionId method;
    VarId uniform;
    Span span;
  };
  KeptVector<UniformCall> uniform_calls;
  // The functions that may reach their ends without a `return`, which JudgeEnds judges.
  struct OpenEnd {
    FunctionId function;
    Span name;
  };
  KeptVector<OpenEnd> open_ends;
};

}  // namespace clipc::check
