// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "ir/evaluate_math.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

// Source: "HLSL Shader Model 6.4" and "HLSL Shader Model 6.6 Pack/Unpack Math Intrinsics" of the
// Direct3D specifications.
namespace clipc::ir {
namespace {

// Byte `i` of a word, with its sign if the bytes have signs.
std::int32_t ByteOf(Word word, std::size_t i, bool is_signed) {
  const auto byte = static_cast<std::uint8_t>(UintOf(word) >> 8 * i);
  return is_signed ? static_cast<std::int8_t>(byte) : byte;
}

Word SumOfProducts(std::span<const EvalArgument> arguments, bool is_signed) {
  std::uint32_t sum = UintOf(arguments[2].words[0]);
  for (std::size_t i = 0; i < 4; ++i) {
    sum += static_cast<std::uint32_t>(ByteOf(arguments[0].words[0], i, is_signed) *
                                      ByteOf(arguments[1].words[0], i, is_signed));
  }
  return is_signed ? BitsOf(static_cast<std::int32_t>(sum)) : Word{sum};
}

// The low bytes of four numbers, which are put between two bounds before.
Word Packed(const Word* numbers, std::int32_t least, std::int32_t most) {
  std::uint32_t bytes = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto number = std::clamp(static_cast<std::int32_t>(UintOf(numbers[i])), least, most);
    bytes |= (static_cast<std::uint32_t>(number) & 255) << 8 * i;
  }
  return bytes;
}

}  // namespace

bool PackedFunction(Intrinsic op, std::span<const EvalArgument> arguments, Word* result) {
  using enum Intrinsic;
  const Word* const first = arguments[0].words;
  switch (op) {
    case kDot4AddI8:
    case kDot4AddU8: result[0] = SumOfProducts(arguments, op == kDot4AddI8); return true;
    case kPackS8:
    case kPackU8: result[0] = Packed(first, INT32_MIN, INT32_MAX); return true;
    case kPackClampS8: result[0] = Packed(first, -128, 127); return true;
    case kPackClampU8: result[0] = Packed(first, 0, 255); return true;
    case kUnpackS8S16:
    case kUnpackS8S32:
      for (std::size_t i = 0; i < 4; ++i) result[i] = BitsOf(ByteOf(first[0], i, true));
      return true;
    case kUnpackU8U16:
    case kUnpackU8U32:
      for (std::size_t i = 0; i < 4; ++i)
        result[i] = static_cast<std::uint32_t>(ByteOf(first[0], i, false));
      return true;
    default: return false;
  }
}

}  // namespace clipc::ir
