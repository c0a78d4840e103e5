// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>

#include "legalize/legalizer.h"

// The elements that a target with Needs::constant_indices cannot choose by an index.
namespace clipc::legalize {

class Elements {
 public:
  explicit Elements(const Legalizer& legalizer);

  // The number of elements that an index which is not constant chooses from; 0 for an index that
  // the target accepts, and for an expression that is not an Index.
  std::uint32_t CountOf(ir::ExprId expr) const;

 private:
  bool IsOfLoops(ir::ExprId expr) const;

  const Legalizer& legalizer_;
  std::set<ir::VarId> loop_indices_;
};

// The comparison of parameter `i` of the helper function with `k`.
ir::ExprId IsElement(const ir::Program& program, HelperBody& body, std::size_t i, std::uint32_t k);

// Makes the calls in the shader's functions pass variables where they pass elements to out and
// inout parameters.
void LowerElementCalls(Legalizer& legalizer, const Elements& elements);
// Makes `expr` call helper functions in place of writing elements.
void LowerElementWrite(Legalizer& legalizer, const Elements& elements, ir::ExprId expr);

}  // namespace clipc::legalize
