// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "rewrite/distances.h"

#include <algorithm>

#include <fmt/format.h>

namespace clipc::rewrite {

std::vector<DistanceParameter> DistanceParameters(const PlaneForm& form, const std::string& prefix,
                                                  std::size_t count) {
  const std::string_view semantic =
      form.lowering == Lowering::kDiscard ? kPlaneDistance : "SV_ClipDistance";
  std::vector<DistanceParameter> parameters;
  for (std::size_t first = 0; first < count; first += 4) {
    const std::size_t width = std::min<std::size_t>(count - first, 4);
    const std::size_t number = first / 4;
    parameters.push_back(
        {first, width,
         form.location ? fmt::format("[[vk::location({})]] ", *form.location + number) : "",
         width == 1 ? "float" : fmt::format("float{}", width),
         fmt::format("{}distances{}", prefix, number), fmt::format(" : {}{}", semantic, number)});
  }
  return parameters;
}

}  // namespace clipc::rewrite
