// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include <fmt/format.h>

#include "link/interface.h"

namespace clipc::link {

std::uint32_t GlslType::Elements() const {
  std::uint64_t count = columns;
  for (const std::uint32_t dimension : dimensions)
    count = std::min<std::uint64_t>(count * dimension, kMaxElements + 1);
  return static_cast<std::uint32_t>(count);
}

std::string NameOf(const GlslType& type) {
  const ir::Scalar kind = type.scalar;
  std::string name;
  if (type.columns > 1) {
    name = fmt::format("{}mat{}x{}", kind == ir::Scalar::kDouble ? "d" : "", type.columns,
                       type.components);
    if (type.columns == type.components) name.resize(name.size() - 2);
  } else if (type.components > 1) {
    const std::string_view letter = kind == ir::Scalar::kFloat ? "" : ir::NameOf(kind);
    name = fmt::format("{}vec{}", letter.substr(0, 1), type.components);
  } else {
    name = ir::NameOf(kind);
  }
  for (const std::uint32_t dimension : type.dimensions) name += fmt::format("[{}]", dimension);
  return name;
}

std::optional<GlslType> GlslTypeOf(const ir::TypeTable& types, ir::TypeId id) {
  GlslType result;
  for (; types[id].kind == ir::TypeKind::kArray; id = types[id].element)
    result.dimensions.push_back(types[id].count);
  const ir::Type& type = types[id];
  if (!type.IsNumeric()) return std::nullopt;
  result.scalar = ir::BaseOf(type.scalar);
  // A matrix of one row or one column is a vector in GLSL.
  const bool is_vector = type.rows == 1 || type.columns == 1;
  result.components =
      is_vector ? static_cast<std::uint8_t>(type.rows * type.columns) : type.columns;
  result.columns = is_vector ? std::uint8_t{1} : type.rows;
  return result;
}

}  // namespace clipc::link
