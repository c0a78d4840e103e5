// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/values/probe.h"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace clipc::values {
namespace {

enum class Kind { kFloat, kInteger, kDouble, kLong };

// The values that a probe expects, as bits.
struct Expected {
  Kind kind = Kind::kFloat;
  std::vector<std::uint64_t> values;
  std::uint64_t ulps = 0;

  std::size_t Size() const { return kind == Kind::kDouble || kind == Kind::kLong ? 8 : 4; }
};

Expected TakeExpected(Scanner& line) {
  Expected expected;
  if (line.Take("f64")) {
    expected.kind = Kind::kDouble;
  } else if (line.Take("u64") || line.Take("i64")) {
    expected.kind = Kind::kLong;
  } else if (line.Take("u32") || line.Take("i32")) {
    expected.kind = Kind::kInteger;
  } else if (!line.Take("f32") && !line.Take("rgba") && !line.Take("r")) {
    throw std::runtime_error("unknown probe `" + std::string(line.rest()) + "`");
  }
  line.ExpectMark('(');
  do {
    switch (expected.kind) {
      case Kind::kFloat:
        expected.values.push_back(
            std::bit_cast<std::uint32_t>(static_cast<float>(line.TakeNumber())));
        break;
      case Kind::kDouble:
        expected.values.push_back(std::bit_cast<std::uint64_t>(line.TakeNumber()));
        break;
      case Kind::kInteger:
        expected.values.push_back(static_cast<std::uint32_t>(line.TakeInteger()));
        break;
      case Kind::kLong: expected.values.push_back(line.TakeInteger()); break;
    }
  } while (line.TakeMark(','));
  line.ExpectMark(')');
  if (const auto ulps = line.TakeWord()) expected.ulps = *ulps;
  return expected;
}

// Whether two floats, whose bits lie in `Bits`, are so many steps apart at most.
template <typename Float, typename Bits>
bool AreNear(std::uint64_t a, std::uint64_t b, std::uint64_t ulps) {
  const auto x = std::bit_cast<Float>(static_cast<Bits>(a));
  const auto y = std::bit_cast<Float>(static_cast<Bits>(b));
  if (std::isnan(x) || std::isnan(y)) return std::isnan(x) && std::isnan(y);
  // The bits of negative numbers grow downwards.
  constexpr Bits kSign = Bits{1} << (8 * sizeof(Bits) - 1);
  const auto ordered = [](std::uint64_t bits) {
    const auto value = static_cast<Bits>(bits);
    return (value & kSign) != 0 ? kSign - (value - kSign) : kSign + value;
  };
  const Bits first = ordered(a), second = ordered(b);
  return (first > second ? first - second : second - first) <= ulps;
}

bool IsEqual(const Expected& expected, std::uint64_t value, std::uint64_t bits) {
  switch (expected.kind) {
    case Kind::kFloat: return AreNear<float, std::uint32_t>(value, bits, expected.ulps);
    case Kind::kDouble: return AreNear<double, std::uint64_t>(value, bits, expected.ulps);
    case Kind::kInteger:
    case Kind::kLong: break;
  }
  return value == bits;
}

std::string TextOf(Kind kind, std::uint64_t bits) {
  char text[64];
  switch (kind) {
    case Kind::kFloat:
      std::snprintf(text, sizeof text, "%.9g",
                    std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
      break;
    case Kind::kDouble:
      std::snprintf(text, sizeof text, "%.17g", std::bit_cast<double>(bits));
      break;
    case Kind::kInteger:
    case Kind::kLong:
      std::snprintf(text, sizeof text, "0x%llx", static_cast<unsigned long long>(bits));
      break;
  }
  return text;
}

std::string TextOf(Kind kind, const std::vector<std::uint64_t>& values) {
  std::string text;
  for (const std::uint64_t value : values) text += (text.empty() ? "" : ", ") + TextOf(kind, value);
  return "(" + text + ")";
}

// The elements that a probe names: (x), (x, y), (x, y, layer) or (left, top, right, bottom).
struct Region {
  std::size_t left = 0, top = 0, right = 1, bottom = 1, layer = 0;
};

Region TakeRegion(Scanner& line) {
  const std::vector<double> list = line.TakeList();
  if (list.empty() || list.size() > 4) throw std::runtime_error("no place in a probe");
  const auto at = [&](std::size_t i) { return static_cast<std::size_t>(list[i]); };
  Region region{at(0), list.size() > 1 ? at(1) : 0};
  region.right = list.size() == 4 ? at(2) : region.left + 1;
  region.bottom = list.size() == 4 ? at(3) : region.top + 1;
  if (list.size() == 3) region.layer = at(2);
  return region;
}

}  // namespace

std::string DifferenceOf(const Resource& resource, Scanner& line) {
  const Region region = TakeRegion(line);
  const Expected expected = TakeExpected(line);
  const std::vector<std::uint8_t> bytes = resource.Read();
  const ResourceText& text = resource.text();
  const bool is_buffer = text.dimension == Dimension::kBuffer;
  const std::size_t pitch = std::size_t{text.width} * text.TexelSize();
  const std::size_t first = region.layer * pitch * (is_buffer ? 1 : text.height);
  const std::size_t size = expected.Size();
  for (std::size_t y = region.top; y < region.bottom; ++y) {
    for (std::size_t x = region.left; x < region.right; ++x) {
      const std::size_t at = first + y * pitch + x * size * expected.values.size();
      if (at + size * expected.values.size() > bytes.size()) return "outside of the resource";
      std::vector<std::uint64_t> values(expected.values.size());
      bool is_equal = true;
      for (std::size_t i = 0; i < values.size(); ++i) {
        std::memcpy(&values[i], bytes.data() + at + i * size, size);
        is_equal = is_equal && IsEqual(expected, expected.values[i], values[i]);
      }
      if (is_equal) continue;
      return "at (" + std::to_string(x) + ", " + std::to_string(y) + "): is " +
             TextOf(expected.kind, values) + ", the test has " +
             TextOf(expected.kind, expected.values);
    }
  }
  return {};
}

}  // namespace clipc::values
