// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/split_arrays.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "ir/access.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

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
  resource.element_of = array;
  resource.element = element;
  resource.reg.number += element;
  if (resource.reg.descriptor) resource.reg.descriptor->binding += element;
  program.resources.push_back(resource);
  return program.resources.back().var;
}

}  // namespace

std::uint32_t SplitCount(const Program& program, ArraySplit split, VarId var) {
  constexpr std::uint64_t kMost = 1024;
  if (split == ArraySplit::kNone) return 0;
  // A parameter stands in functions that are called with objects of the shader in its place.
  if (program.vars[var].storage != Storage::kResource) return 0;
  std::uint64_t count = 1;
  TypeId type = program.vars[var].type;
  if (program.types[type].kind != TypeKind::kArray) return 0;
  for (; program.types[type].kind == TypeKind::kArray; type = program.types[type].element)
    count = std::min(count * program.types[type].count, kMost + 1);
  if (count > kMost) return 0;
  const bool is_counted = std::ranges::any_of(program.resources, [&](const Resource& resource) {
    return resource.counter_of && (resource.counter_of == var || resource.var == var);
  });
  if (split == ArraySplit::kAll) return is_counted ? 0 : static_cast<std::uint32_t>(count);
  // OpenGL has no arrays without a size, which is reported by itself.
  const bool is_sampler = InfoOf(program.types[type].object).category == ObjectCategory::kSampler;
  return is_sampler ? static_cast<std::uint32_t>(std::max<std::uint64_t>(count, 1)) : 0;
}

ArrayElement SplitElementAt(const Program& program, ArraySplit split, ExprId expr) {
  if (!As<Index>(program, expr) || TypeOf(program, expr).kind != TypeKind::kObject) return {};
  ArrayElement element;
  std::uint32_t stride = 1;
  while (const auto* index = As<Index>(program, expr)) {
    const auto* number = As<Literal>(program, index->index);
    if (!number || !index->base) return {};
    element.number += stride * static_cast<std::uint32_t>(number->bits);
    stride *= TypeOf(program, index->base).count;
    expr = index->base;
  }
  const auto* array = As<VarRef>(program, expr);
  if (array && SplitCount(program, split, array->var) > 0) element.array = array->var;
  return element;
}

void SplitArrays(Legalizer& legalizer) {
  Program& program = legalizer.program;
  const ArraySplit split = legalizer.needs.split_arrays;
  const bool has_arrays = std::ranges::any_of(program.resources, [&](const Resource& resource) {
    return SplitCount(program, split, resource.var) > 0;
  });
  if (!has_arrays) return;
  std::map<std::pair<std::uint32_t, std::uint32_t>, VarId> elements;
  for (const ExprId expr : program.exprs.ids()) {
    const ArrayElement element = SplitElementAt(program, split, expr);
    if (!element.array) continue;
    VarId& var = elements[{element.array.index, element.number}];
    if (!var) var = AddElement(program, element.array, element.number);
    program.exprs[expr].node = VarRef{var};
  }
}

}  // namespace clipc::legalize
