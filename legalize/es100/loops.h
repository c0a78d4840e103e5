// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "ir/counted_loop.h"

// The loops of a target with Needs::constant_loops. Appendix A of GLSL ES 1.00, section 4, has
// one form of them, whose index no other statement changes:
//
//   for (int i = constant; i < constant; i += constant)
namespace clipc::legalize {

// The loops of one function.
class CountedLoops {
 public:
  // The program must not change while this lives.
  CountedLoops(const ir::Program& program, ir::StmtId body);

  // Returns the reason why the loop is not of that form and LowerLoops cannot make it so: words
  // that follow "this loop". Returns an empty text if it is or can be made so, with its parts in
  // `loop`, and for a statement that is not a loop.
  std::string_view WhyNot(ir::StmtId stmt, ir::CountedLoop& loop) const;

 private:
  const ir::Program& program_;
  // The number of references to each variable, by VarId: in the body, and in counted loops that
  // have the variable as their index without declaring it.
  std::vector<std::uint32_t> uses_, uses_in_loops_;
};

// The reason why the loop is not of that form, whatever uses its index outside of it.
std::string_view WhyNotAlone(const ir::Program& program, ir::StmtId stmt, ir::CountedLoop& loop);

// Whether the expression is a constant-index-expression (GLSL ES 1.00, appendix A, 5): made of
// constants and of the indices of counted loops, `loop_indices` by VarId.
bool IsConstantIndex(const ir::Program& program, ir::ExprId expr,
                     std::span<const char> loop_indices);

}  // namespace clipc::legalize
