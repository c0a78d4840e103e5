// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/split_arrays.h"

#include <algorithm>

#include "ir/access.h"

namespace clipc::glsl {

using namespace ir;

std::uint32_t SplitCount(const Program& program, const Target& target, VarId var) {
  constexpr std::uint64_t kMost = 1024;
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
  if (target.IsVulkan())
    return target.bindings.splits_arrays && !is_counted ? static_cast<std::uint32_t>(count) : 0;
  // OpenGL has no arrays without a size, which is reported by itself.
  const bool is_sampler = InfoOf(program.types[type].object).category == ObjectCategory::kSampler;
  return is_sampler ? static_cast<std::uint32_t>(std::max<std::uint64_t>(count, 1)) : 0;
}

ArrayElement SplitElementAt(const Program& program, const Target& target, ExprId expr) {
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
  if (array && SplitCount(program, target, array->var) > 0) element.array = array->var;
  return element;
}

}  // namespace clipc::glsl
