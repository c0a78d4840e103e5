// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/random_values.h"

#include <algorithm>
#include <bit>

namespace clipc::draw {

std::uint64_t RandomValues::Next(ir::Scalar kind) {
  switch (ir::BaseOf(kind)) {
    case ir::Scalar::kBool: return Below(2);
    case ir::Scalar::kInt: return static_cast<std::uint32_t>(Int(options_.least_int));
    case ir::Scalar::kUint: return static_cast<std::uint32_t>(Int(std::max(options_.least_int, 0)));
    case ir::Scalar::kInt64:
      return static_cast<std::uint64_t>(std::int64_t{Int(options_.least_int)});
    case ir::Scalar::kUint64:
      return static_cast<std::uint64_t>(Int(std::max(options_.least_int, 0)));
    case ir::Scalar::kDouble: return ir::BitsOf(static_cast<double>(Float()));
    default: return ir::BitsOf(Float());
  }
}

int RandomValues::Int(int least) {
  const std::int64_t count = std::int64_t{options_.greatest_int} - least + 1;
  return static_cast<int>(least + std::int64_t{Below(count)});
}

float RandomValues::Float() {
  if (options_.quarters) return static_cast<float>(static_cast<int>(Below(33)) - 16) / 4;
  if (Below(4) == 0) return static_cast<float>(static_cast<int>(Below(5)) - 2);
  return static_cast<float>(Below(1u << 24)) * 0x1p-22f - 2.0f;
}

std::uint64_t UndefinedBits(const ir::ObjectRequest& request, double undefined, ir::Scalar kind,
                            std::size_t component) {
  std::uint64_t hash = ir::BitsOf(undefined);
  const auto mix = [&](std::uint64_t value) {
    hash = (std::rotl(hash, 25) ^ value) * 0x9e3779b97f4a7c15u;
  };
  mix(request.object.index), mix(request.object_element), mix(component);
  for (const std::uint64_t argument : request.words) mix(argument);
  // The value is from -8 to 8, and never 0.
  const double value = undefined * (static_cast<double>(hash >> 54) - 511.5) / 64;
  return ir::ConvertBits(ir::BitsOf(value), ir::Scalar::kDouble, ir::BaseOf(kind));
}

}  // namespace clipc::draw
