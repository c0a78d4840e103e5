// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/intrinsics.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "ir/intrinsic_list.h"

namespace clipc::glsl {

using namespace ir;

namespace {

constexpr BuiltinFunction kBuiltinFunctions[] = {
    {Intrinsic::kAbs, "abs"},
    {Intrinsic::kAcos, "acos"},
    {Intrinsic::kAsin, "asin"},
    {Intrinsic::kAtan, "atan"},
    {Intrinsic::kAtan2, "atan"},
    {Intrinsic::kCeil, "ceil"},
    {Intrinsic::kClamp, "clamp", 0b110},
    {Intrinsic::kCos, "cos"},
    {Intrinsic::kCosh, "cosh", 0, true},
    {Intrinsic::kCross, "cross"},
    {Intrinsic::kDegrees, "degrees"},
    {Intrinsic::kDistance, "distance"},
    {Intrinsic::kExp, "exp"},
    {Intrinsic::kExp2, "exp2"},
    {Intrinsic::kFaceforward, "faceforward"},
    {Intrinsic::kFloor, "floor"},
    {Intrinsic::kFma, "fma"},
    {Intrinsic::kFrac, "fract"},
    {Intrinsic::kIsInf, "isinf", 0, true},
    {Intrinsic::kIsNan, "isnan", 0, true},
    {Intrinsic::kLength, "length"},
    {Intrinsic::kLerp, "mix", 0b100},
    {Intrinsic::kLog, "log"},
    {Intrinsic::kLog2, "log2"},
    {Intrinsic::kMax, "max", 0b10},
    {Intrinsic::kMin, "min", 0b10},
    {Intrinsic::kModf, "modf", 0, true},
    {Intrinsic::kNormalize, "normalize"},
    {Intrinsic::kPow, "pow"},
    {Intrinsic::kRadians, "radians"},
    {Intrinsic::kReflect, "reflect"},
    {Intrinsic::kRefract, "refract"},
    {Intrinsic::kRound, "roundEven", 0, true},
    {Intrinsic::kRsqrt, "inversesqrt"},
    {Intrinsic::kSign, "sign"},
    {Intrinsic::kSin, "sin"},
    {Intrinsic::kSinh, "sinh", 0, true},
    {Intrinsic::kSqrt, "sqrt"},
    {Intrinsic::kStep, "step", 0b01},
    {Intrinsic::kTan, "tan"},
    {Intrinsic::kTanh, "tanh", 0, true},
    {Intrinsic::kTrunc, "trunc", 0, true},
};

// The row of each intrinsic in kBuiltinFunctions, counted from 1; 0 where GLSL has no function.
constexpr auto kRowOf = [] {
  std::array<std::uint8_t, 256> rows{};
  for (std::size_t i = 0; i < std::size(kBuiltinFunctions); ++i) {
    rows[static_cast<std::size_t>(kBuiltinFunctions[i].op)] = static_cast<std::uint8_t>(i + 1);
  }
  return rows;
}();

}  // namespace

const BuiltinFunction* BuiltinOf(Intrinsic op, const Shape& shape, const Target& target) {
  const std::uint8_t row = kRowOf[static_cast<std::size_t>(op)];
  if (row == 0) return nullptr;
  const BuiltinFunction* found = &kBuiltinFunctions[row - 1];
  if (found->is_rounding && !target.Has(Feature::kRounding)) return nullptr;
  return shape.IsFloating() || target.Has(Feature::kUnsigned) ? found : nullptr;
}

}  // namespace clipc::glsl
