// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/shader_variant.h"

namespace clipc::runtime {

void CompactPlanes(const ShaderVariant& variant, const Float4* from, Float4* to) noexcept {
  for (std::uint8_t slot = 0; slot < variant.plane_count; ++slot)
    to[slot] = from[variant.planes[slot]];
}

void OrderByPlaneCount(const BoxPlan* plans, std::size_t count, std::uint32_t* order,
                       std::size_t (&first)[8]) noexcept {
  // A counting sort; culled objects have no bin.
  std::size_t sizes[7] = {};
  for (std::size_t i = 0; i < count; ++i) {
    if ((plans[i] & kCulled) == 0) ++sizes[VariantOf(plans[i]).plane_count];
  }
  std::size_t next[7];
  first[0] = 0;
  for (std::size_t k = 0; k < 7; ++k) {
    next[k] = first[k];
    first[k + 1] = first[k] + sizes[k];
  }
  for (std::size_t i = 0; i < count; ++i) {
    if ((plans[i] & kCulled) == 0)
      order[next[VariantOf(plans[i]).plane_count]++] = static_cast<std::uint32_t>(i);
  }
}

}  // namespace clipc::runtime
