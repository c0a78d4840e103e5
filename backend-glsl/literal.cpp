// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/literal.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "base/shortest_text.h"
#include "ir/scalar.h"

namespace clipc::glsl {
namespace {

Text Number(std::string text, bool is_negative) {
  return {std::move(text), is_negative ? Binding::kMinus : Binding::kPostfix};
}

template <typename Float>
std::string Decimal(Float value) {
  // Most numbers of shaders are 0, 1 and 2, which take a tenth of the time so.
  if (value >= 0 && value < 10 && !std::signbit(value) &&
      value == static_cast<Float>(static_cast<int>(value)))
    return {static_cast<char>('0' + static_cast<int>(value)), '.', '0'};
  std::string text = ShortestText(value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

Text FloatText(std::uint64_t bits, const Target& target) {
  const float value = ir::FloatOf(bits);
  if (std::isfinite(value)) return Number(Decimal(value), std::signbit(value));
  if (target.Has(Feature::kBitCasts) && target.Of(Feature::kBitCasts).extension.empty()) {
    char hex[16];
    const auto result = std::to_chars(hex, hex + sizeof hex, static_cast<std::uint32_t>(bits), 16);
    return {"uintBitsToFloat(0x" + std::string(hex, result.ptr) + "u)"};
  }
  const char* text = std::isnan(value) ? "0.0 / 0.0" : value > 0 ? "1.0 / 0.0" : "-1.0 / 0.0";
  return {text, Binding::kProduct};
}

Text DoubleText(std::uint64_t bits) {
  const double value = ir::DoubleOf(bits);
  if (std::isfinite(value)) return Number(Decimal(value) + "lf", std::signbit(value));
  const char* text = std::isnan(value) ? "0.0lf / 0.0lf"
                     : value > 0       ? "1.0lf / 0.0lf"
                                       : "-1.0lf / 0.0lf";
  return {text, Binding::kProduct};
}

Text IntText(std::int32_t value, const Target& target) {
  if (value != std::numeric_limits<std::int32_t>::min())
    return Number(std::to_string(value), value < 0);
  // GLSL reads -2147483648 as the negation of a number that is not an int.
  if (target.Has(Feature::kUnsigned)) return {"int(0x80000000u)"};
  return {"-2147483647 - 1", Binding::kSum};
}

}  // namespace

Text LiteralText(std::uint64_t bits, ir::Scalar kind, const Target& target) {
  switch (ir::BaseOf(kind)) {
    case ir::Scalar::kBool: return {bits != 0 ? "true" : "false"};
    case ir::Scalar::kInt: return IntText(ir::IntOf(bits), target);
    case ir::Scalar::kUint:
      if (!target.Has(Feature::kUnsigned)) return IntText(ir::IntOf(bits), target);
      return {std::to_string(ir::UintOf(bits)) + "u"};
    case ir::Scalar::kInt64: {
      const auto value = static_cast<std::int64_t>(bits);
      return Number(std::to_string(value) + "l", value < 0);
    }
    case ir::Scalar::kUint64: return {std::to_string(bits) + "ul"};
    case ir::Scalar::kDouble: return DoubleText(bits);
    default: return FloatText(bits, target);
  }
}

Text MaskText(std::uint32_t bits) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string text = "0x";
  for (int shift = bits > 0xFFFF ? 28 : 12; shift >= 0; shift -= 4)
    text += kDigits[bits >> shift & 15];
  text += 'u';
  return {std::move(text)};
}

}  // namespace clipc::glsl
