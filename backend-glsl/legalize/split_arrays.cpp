// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/split_arrays.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "backend-glsl/legalize/legalize.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// The resource of a variable.
const Resource& ResourceOf(const Program& program, VarId var) {
  return *std::ranges::find(program.resources, var, &Resource::var);
}

VarId AddElement(Program& program, VarId array, std::uint32_t element) {
  Var var = program.vars[array];
  var.name += "_" + std::to_string(element);
  var.type = program.types.Innermost(var.type);
  Resource resource = ResourceOf(program, array);
  resource.var = program.vars.Add(std::move(var));
  resource.reg.number += element;
  if (resource.reg.descriptor) resource.reg.descriptor->binding += element;
  program.resources.push_back(resource);
  return program.resources.back().var;
}

}  // namespace

void SplitArrays(Legalizer& legalizer) {
  Program& program = legalizer.program;
  const Target& target = legalizer.target;
  const bool has_arrays = std::ranges::any_of(program.resources, [&](const Resource& resource) {
    return SplitCount(program, target, resource.var) > 0;
  });
  if (!has_arrays) return;
  std::map<std::pair<std::uint32_t, std::uint32_t>, VarId> elements;
  for (const ExprId expr : program.exprs.ids()) {
    const ArrayElement element = SplitElementAt(program, target, expr);
    if (!element.array) continue;
    VarId& var = elements[{element.array.index, element.number}];
    if (!var) var = AddElement(program, element.array, element.number);
    program.exprs[expr].node = VarRef{var};
  }
}

}  // namespace clipc::glsl
