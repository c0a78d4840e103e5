// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "ir/program.h"

// Loops where the target lacks Feature::kFreeLoops. Appendix A of GLSL ES 1.00, section 4, has one
// form of them, whose index no other statement changes:
//
//   for (int i = constant; i < constant; i += constant)
namespace clipc::glsl {

// The parts of a loop that counts.
struct CountedLoop {
  ir::VarId index;
  ir::ExprId start;         // its first value
  ir::ExprId bound;         // the comparison with the last one
  ir::ExprId more;          // or none: a further condition, which a `break` checks
  bool is_declared = true;  // the index is declared in the loop's head
};

// The loops of one function.
class CountedLoops {
 public:
  // The program must not change while this lives.
  CountedLoops(const ir::Program& program, ir::StmtId body);

  // Why the loop is not of that form, nor is made one of it by LowerLoops: words that follow "this
  // loop". Empty when it is; then `loop` has its parts.
  std::string_view WhyNot(ir::StmtId stmt, CountedLoop& loop) const;

 private:
  std::string_view WhyNotAlone(ir::StmtId stmt, CountedLoop& loop) const;
  bool IsIndex(ir::ExprId expr, ir::VarId index) const;
  bool IsConstant(ir::ExprId expr) const;
  bool IsBound(ir::ExprId condition, ir::VarId index) const;
  bool IsStep(ir::ExprId step, ir::VarId index) const;

  const ir::Program& program_;
  // By VarId: references in the body, and those of them in loops that give the variable its value.
  std::vector<std::uint32_t> uses_, uses_in_loops_;
};

}  // namespace clipc::glsl
