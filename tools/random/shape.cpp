// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Expressions changed to lie in another range or to have another type.
#include <algorithm>
#include <cmath>

#include "tools/random/expr.h"

namespace clipc::random {
namespace {

// `name(value, a, b)`, for a function that works component by component.
Expr Called(const char* name, const Expr& value, const std::string& rest, const Range& range) {
  return {std::string(name) + "(" + Argument(value) + rest + ")", Level::kPostfix, value.kind,
          value.shape, range};
}

Expr Clamped(Context& context, const Expr& value, const Range& range) {
  const std::string low = Literal(value.kind, range.low).text;
  const std::string high = Literal(value.kind, range.high).text;
  Range fits{std::clamp(value.range.low, range.low, range.high),
             std::clamp(value.range.high, range.low, range.high), value.range.fraction};
  if (context.Chance(30)) {
    const Expr least = Called("max", value, ", " + low, {});
    return Called("min", least, ", " + high, fits);
  }
  return Called("clamp", value, ", " + low + ", " + high, fits);
}

Expr FitFloat(Context& context, Expr value, const Range& range) {
  if (value.range.fraction > range.fraction) {
    constexpr const char* kRound[] = {"floor", "round", "trunc", "ceil"};
    value = Called(context.OneOf(kRound), value, "", RoundedDown(value.range));
    if (value.range.IsWithin(range.low, range.high)) return value;
  }
  const double power = std::exp2(std::floor(std::log2(std::min(-range.low, range.high))));
  const std::size_t choice = context.Pick({3, 1, 1});
  if (choice == 1 && range.low <= 0 && range.high >= 1)
    return Called("frac", value, "", {0, 1, value.range.fraction});
  if (choice == 2 && power >= 1) {
    const std::string divisor = Literal(Kind::kFloat, power).text;
    const Range fits{-power, power, value.range.fraction};
    if (context.Chance(50)) return Called("fmod", value, ", " + divisor, fits);
    return {At(value, Level::kProduct) + " % " + divisor, Level::kProduct, value.kind, value.shape,
            fits};
  }
  return Clamped(context, value, range);
}

Expr FitInteger(Context& context, const Expr& value, const Range& range) {
  const std::size_t choice = context.Pick({1, 2, 1});
  if (choice == 1 && range.low <= 0) {
    double mask = 1;
    while (mask * 2 - 1 <= range.high) mask *= 2;
    return {At(value, Level::kAnd) + " & " + Literal(value.kind, mask - 1).text,
            Level::kAnd,
            value.kind,
            value.shape,
            {0, mask - 1}};
  }
  if (choice == 2 && (value.kind == Kind::kUint ? range.low == 0 : range.low <= -range.high)) {
    return {At(value, Level::kProduct) + " % " + Literal(value.kind, range.high + 1).text,
            Level::kProduct,
            value.kind,
            value.shape,
            {value.kind == Kind::kUint ? 0 : -range.high, range.high}};
  }
  return Clamped(context, value, range);
}

std::string RandomSwizzle(Context& context, int from, int to) {
  const char* letters = context.Chance(25) ? "rgba" : "xyzw";
  std::string text = ".";
  for (int i = 0; i < to; ++i) text += letters[context.Below(from)];
  return text;
}

std::string RandomMatrixSwizzle(Context& context, Shape from, int to) {
  const bool from_one = context.Chance(40);
  std::string text = ".";
  for (int i = 0; i < to; ++i) {
    const int row = context.Between(0, from.rows - 1);
    const int column = context.Between(0, from.columns - 1);
    text += from_one ? "_" + std::to_string(row + 1) + std::to_string(column + 1)
                     : "_m" + std::to_string(row) + std::to_string(column);
  }
  return text;
}

Expr Cast(Context& context, const Expr& value, Kind kind, Shape shape) {
  const std::string name = NameOf(kind, shape);
  // A constructor takes as many components as it makes.
  if (value.shape.Components() == shape.Components() && context.Chance(50))
    return {name + "(" + Argument(value) + ")", Level::kPostfix, kind, shape, value.range};
  return {"(" + name + ")" + At(value, Level::kUnary), Level::kUnary, kind, shape, value.range};
}

bool IsNumber(const Expr& value) {
  return !value.text.empty() && value.text[0] >= '0' && value.text[0] <= '9';
}

std::string Swizzled(const Expr& value, const std::string& swizzle) {
  return (IsNumber(value) ? "(" + value.text + ")" : At(value, Level::kPostfix)) + swizzle;
}

Expr ReshapeMatrix(Context& context, const Expr& value, Shape shape) {
  Expr result = value;
  result.level = Level::kPostfix;
  if (shape.IsMatrix()) {
    if (shape.rows <= value.shape.rows && shape.columns <= value.shape.columns)
      return Cast(context, value, value.kind, shape);
    result.shape = shape;
    if (shape.rows == value.shape.columns && shape.columns == value.shape.rows) {
      result.text = "transpose(" + Argument(value) + ")";
      return result;
    }
    return Reshape(context, Reshape(context, value, kScalar), shape);
  }
  if (context.Chance(40)) {
    result.text = Swizzled(value, RandomMatrixSwizzle(context, value.shape, shape.columns));
    result.shape = shape;
    return result;
  }
  const std::string row = std::to_string(context.Between(0, value.shape.rows - 1));
  result.text = Swizzled(value, "[" + row + "]");
  result.shape = {0, value.shape.columns};
  return Reshape(context, result, shape);
}

}  // namespace

Expr Fit(Context& context, Expr value, const Range& range) {
  if (value.range.IsWithin(range.low, range.high) && value.range.fraction <= range.fraction)
    return value;
  switch (value.kind) {
    case Kind::kFloat: return FitFloat(context, std::move(value), range);
    case Kind::kBool: return value;
    default: return FitInteger(context, value, range);
  }
}

Expr Reshape(Context& context, Expr value, Shape shape) {
  if (value.shape == shape) return value;
  if (value.shape.IsMatrix()) return ReshapeMatrix(context, value, shape);
  if (shape.IsMatrix()) {
    if (value.shape.IsScalar() || value.shape.Components() == shape.Components())
      return {"(" + NameOf(value.kind, shape) + ")" + At(value, Level::kUnary), Level::kUnary,
              value.kind, shape, value.range};
    return Reshape(context, Reshape(context, value, kScalar), shape);
  }
  const int columns = value.shape.columns;
  if (columns == 1 && context.Chance(50)) return Cast(context, value, value.kind, shape);
  if (shape.columns < columns && context.Chance(25)) return Cast(context, value, value.kind, shape);
  value.text = Swizzled(value, RandomSwizzle(context, columns, shape.columns));
  value.level = Level::kPostfix;
  value.shape = shape;
  return value;
}

Expr Convert(Context& context, Expr value, Kind kind) {
  const Kind from = value.kind;
  if (from == kind) return value;
  const bool to_integer = kind == Kind::kInt || kind == Kind::kUint;
  if (from == Kind::kFloat && to_integer && context.model < 60 &&
      context.Chance(Feature::kWideConversions, 10)) {
    value.text = At(value, Level::kProduct) + " * 1073741824.0";
    value.level = Level::kProduct;
    Expr wild = Cast(context, value, kind, value.shape);
    wild.range = Wild(kind);
    return wild;
  }
  if (!CanConvert(value.range, from, kind))
    value = Fit(context, value, from == Kind::kFloat ? Range{0, 128, 6} : VariableRange(from));
  const Range range = Converted(value.range, from, kind);
  Expr converted = Cast(context, value, kind, value.shape);
  converted.range = range;
  return converted;
}

}  // namespace clipc::random
