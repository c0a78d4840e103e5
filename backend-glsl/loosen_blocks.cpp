// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/loosen_blocks.h"

#include <vector>

#include "backend-glsl/legalize/es100/loops.h"
#include "backend-glsl/reach.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// By VarId: whether the variable is the index of a loop that the target has.
std::vector<char> LoopIndices(const Program& program, const Reached& reached) {
  std::vector<char> indices(program.vars.size());
  for (const FunctionId id : reached.functions) {
    const StmtId body = program.functions[id].body;
    const CountedLoops loops(program, body);
    ForEachStmt(program, body, [&](StmtId stmt) {
      CountedLoop loop;
      if (loops.WhyNot(stmt, loop).empty() && loop.counter) indices[loop.counter.index] = 1;
    });
  }
  return indices;
}

}  // namespace

void LoosenIndexedBlocks(Program& program, const Target& target) {
  if (target.Has(Feature::kFreeIndices) || !InfoOf(program.stage).draws_pixels) return;
  const Reached reached = Reach(program);
  const std::vector<char> loop_indices = LoopIndices(program, reached);
  for (const FunctionId id : reached.functions) {
    ForEachExpr(program, program.functions[id].body, [&](ExprId expr) {
      const auto* index = As<Index>(program, expr);
      const auto* ref = index ? As<VarRef>(program, index->base) : nullptr;
      if (!ref || program.vars[ref->var].storage != Storage::kUniform ||
          IsConstantIndex(program, index->index, {}) ||
          !IsConstantIndex(program, index->index, loop_indices))
        return;
      Cbuffer& cbuffer = program.cbuffers[program.vars[ref->var].cbuffer];
      if (cbuffer.declared) return;
      cbuffer.declared.emplace().is_loose = true;
    });
  }
}

}  // namespace clipc::glsl
