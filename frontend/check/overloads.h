// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/name.h"
#include "frontend/check/symbols.h"

namespace clipc::check {

// Functions, overload sets and instances of templates.
struct Overloads {
  explicit Overloads(const Names& names) {
    constexpr std::string_view kOperator = "operator";
    for (std::uint32_t i = 0; i < names.size(); ++i) {
      const std::string_view text = names[Name{i}];
      if (text.starts_with(kOperator) && text != kOperator)
        operators.emplace(text.substr(kOperator.size()), Name{i});
    }
  }
  // The function, as objects of type `self` have it when it is a method; none before its first use.
  FunctionInfoId Known(SymbolId symbol, ir::TypeId self) const {
    const auto found = of_symbol.find(KeyOf(symbol, self));
    return found == of_symbol.end() ? FunctionInfoId{} : found->second;
  }
  static std::uint64_t KeyOf(SymbolId symbol, ir::TypeId self) {
    return std::uint64_t{symbol.index} << 32 | self.index;
  }
  FunctionInfo& operator[](FunctionInfoId id) { return infos[id.index]; }
  const FunctionInfo& operator[](FunctionInfoId id) const { return infos[id.index]; }
  std::span<Parameter> operator[](List<Parameter> list) { return parameters[list]; }
  std::span<const Parameter> operator[](List<Parameter> list) const { return parameters[list]; }

  std::unordered_map<std::string_view, Name> operators;  // "+" for operator+, of those in the file
  std::deque<FunctionInfo> infos;
  Pool<Parameter> parameters;
  std::unordered_map<std::uint32_t, bool> changes_self;                      // by a method's DeclId
  std::unordered_map<std::uint64_t, FunctionInfoId> of_symbol;               // by SymbolId and self
  std::unordered_map<std::uint64_t, std::vector<FunctionInfoId>> overloads;  // by SymbolId and self
  std::unordered_map<std::uint32_t, std::vector<ast::DeclId>> out_of_line;   // by Name
  std::unordered_map<std::string, std::uint32_t> instances;  // by decl, scope, arguments
  std::vector<FunctionInfoId> waiting;                       // reached, bodies not checked
  struct CallEdge {
    ir::FunctionId caller, callee;
    Span span;
  };
  std::vector<CallEdge> calls;
};

}  // namespace clipc::check
