// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/swizzle_index.h"

#include <vector>

#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::rules {

void IndexWholeVector(Program& program, ExprId target) {
  const auto* index = As<Index>(program, target);
  const auto* found = index ? As<Swizzle>(program, index->base) : nullptr;
  if (!found) return;
  const Swizzle swizzle = *found;
  const ExprId number = index->index;
  Builder at(program, program.exprs[number].span);
  std::vector<ExprId> components;
  for (int i = 0; i < swizzle.count; ++i) components.push_back(at.Int(swizzle.components[i]));
  const TypeId type = program.types.Vector(Scalar::kInt, swizzle.count);
  program.exprs[target].node = Index{swizzle.base, at.At(at.ConstructOf(type, components), number)};
}

}  // namespace clipc::rules
