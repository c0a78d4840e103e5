// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
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
  var.type = program.types[var.type].element;
  Resource resource = ResourceOf(program, array);
  resource.var = program.vars.Add(std::move(var));
  resource.reg.number += element;
  if (resource.reg.descriptor) resource.reg.descriptor->binding += element;
  program.resources.push_back(resource);
  return program.resources.back().var;
}

}  // namespace

void SplitSamplers(Legalizer& legalizer) {
  Program& program = legalizer.program;
  const bool has_arrays = std::ranges::any_of(program.resources, [&](const Resource& resource) {
    return program.types[program.vars[resource.var].type].kind == TypeKind::kArray;
  });
  if (legalizer.target.IsVulkan() || !has_arrays) return;
  std::map<std::pair<std::uint32_t, std::uint32_t>, VarId> elements;
  for (const ExprId expr : program.exprs.ids()) {
    const SamplerElement element = SamplerElementAt(program, expr);
    if (!element.array) continue;
    VarId& var = elements[{element.array.index, element.number}];
    if (!var) var = AddElement(program, element.array, element.number);
    program.exprs[expr].node = VarRef{var};
  }
}

}  // namespace clipc::glsl
