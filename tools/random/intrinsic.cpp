// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/random/expr.h"

namespace clipc::random {
namespace {

constexpr Range kUnit{-4, 4, 2};

Expr Call(const std::string& name, std::initializer_list<const Expr*> arguments, Kind kind,
          Shape shape, const Range& range) {
  std::string text = name + "(";
  for (const Expr* argument : arguments)
    text += (text.back() == '(' ? "" : ", ") + Argument(*argument);
  return {text + ")", Level::kPostfix, kind, shape, range};
}

Expr MakeRounding(Context& context, Shape shape, int depth) {
  constexpr const char* kNames[] = {"floor", "ceil", "round", "trunc"};
  const char* name = context.OneOf(kNames);
  const Expr a = MakeExpr(context, Kind::kFloat, shape, depth - 1);
  return Call(name, {&a}, Kind::kFloat, shape, RoundedDown(a.range));
}

Expr MakeLimited(Context& context, Kind kind, Shape shape, int depth) {
  const Expr a = MakeExpr(context, kind, shape, depth - 1);
  const Expr b = MakeExpr(context, kind, shape, depth - 1);
  switch (context.Pick({1, 1, 1})) {
    case 0: return Call("min", {&a, &b}, kind, shape, Least(a.range, b.range));
    case 1: return Call("max", {&a, &b}, kind, shape, Greatest(a.range, b.range));
    default: break;
  }
  // clamp's bounds are in order: which one wins otherwise is nobody's promise.
  const double low = context.Between(0, 4), size = context.Between(1, 9);
  const Expr least = Literal(kind, low), greatest = Literal(kind, low + size);
  return Call("clamp", {&a, &least, &greatest}, kind, shape,
              {std::clamp(a.range.low, low, low + size), std::clamp(a.range.high, low, low + size),
               a.range.fraction});
}

Expr MakeAbsolute(Context& context, Kind kind, Shape shape, int depth) {
  const Expr a = MakeExpr(context, kind, shape, depth - 1);
  if (a.range.low <= -0x1p31) return a;
  return Call("abs", {&a}, kind, shape, Absolute(a.range));
}

Expr MakeMad(Context& context, Kind kind, Shape shape, int depth) {
  Expr all[3];
  for (Expr& one : all) {
    one = MakeExpr(context, kind, shape, depth - 1);
    if (kind == Kind::kFloat) one = Fit(context, one, kSmallFloats);
  }
  const Range sum = Sum(Product(all[0].range, all[1].range), all[2].range);
  return Call("mad", {&all[0], &all[1], &all[2]}, kind, shape,
              kind == Kind::kFloat ? sum : Integers(kind, sum.low, sum.high));
}

// a + s * (b - a): every term is exact, whichever formula it is.
Expr MakeLerp(Context& context, Shape shape, int depth) {
  const Expr a = MakeIn(context, Kind::kFloat, shape, kSmallFloats, depth - 1);
  const Expr b = MakeIn(context, Kind::kFloat, shape, kSmallFloats, depth - 1);
  const Expr s =
      MakeIn(context, Kind::kFloat, context.Chance(40) ? kScalar : shape, {-2, 2, 2}, depth - 1);
  const Range range = Sum(a.range, Product(s.range, Sum(b.range, Negated(a.range))));
  return Call("lerp", {&a, &b, &s}, Kind::kFloat, shape, range);
}

Expr MakeStep(Context& context, Shape shape, int depth) {
  const Expr a = MakeExpr(context, Kind::kFloat, shape, depth - 1);
  const Expr b = MakeExpr(context, Kind::kFloat, shape, depth - 1);
  if (context.Chance(30)) {
    const Expr low = Literal(Kind::kFloat, context.Between(0, 2));
    const Expr high = Literal(Kind::kFloat, low.range.low + (context.Chance(50) ? 4 : 2));
    const Expr x = Fit(context, a, kSmallFloats);
    return Call("smoothstep", {&low, &high, &x}, Kind::kFloat, shape, {0, 1, 14});
  }
  return Call("step", {&a, &b}, Kind::kFloat, shape, {0, 1});
}

Expr MakeFraction(Context& context, Shape shape, int depth) {
  const Expr a = MakeExpr(context, Kind::kFloat, shape, depth - 1);
  if (context.Chance(50))
    return Call("saturate", {&a}, Kind::kFloat, shape, {0, 1, a.range.fraction});
  return Call("frac", {&a}, Kind::kFloat, shape, {0, 1, a.range.fraction});
}

Expr MakeLdexp(Context& context, Shape shape, int depth) {
  const Expr a = MakeIn(context, Kind::kFloat, shape, kSmallFloats, depth - 1);
  const Expr e = MakeIn(context, Kind::kInt, shape, {-3, 3}, depth - 1);
  Range range{a.range.low * 8, a.range.high * 8, a.range.fraction + 3};
  if (range.low > 0) range.low = 0;
  if (range.high < 0) range.high = 0;
  return Call("ldexp", {&a, &e}, Kind::kFloat, shape, range);
}

// dot, and the product of vectors and matrices.
Expr MakeProduct(Context& context, Kind kind, Shape shape, int depth) {
  const int inner = context.Between(1, 4);
  Shape left{shape.rows, inner}, right{inner, shape.columns};
  const bool is_dot = shape.IsScalar();
  if (is_dot) {
    left = right = {0, std::max(inner, 2)};
  } else if (!shape.IsMatrix()) {
    left = {0, inner};
    if (inner == 1 || context.Chance(50)) {
      left = {shape.columns, std::max(inner, 2)};
      right = {0, std::max(inner, 2)};
    }
  }
  Expr a = MakeExpr(context, kind, left, depth - 1);
  Expr b = MakeExpr(context, kind, right, depth - 1);
  if (kind == Kind::kFloat) {
    a = Fit(context, a, kSmallFloats);
    b = Fit(context, b, kSmallFloats);
  }
  Range range = Times(Product(a.range, b.range), 4);
  if (kind != Kind::kFloat) range = Integers(kind, range.low, range.high);
  range.low = std::min(range.low, 0.0), range.high = std::max(range.high, 0.0);
  const char* name = is_dot && context.Chance(60) ? "dot" : "mul";
  return Call(name, {&a, &b}, kind, shape, range);
}

// Functions of whole vectors and matrices.
Expr MakeGeometry(Context& context, Shape shape, int depth) {
  const Kind f = Kind::kFloat;
  if (shape.IsMatrix()) {
    const Expr m = MakeExpr(context, f, {shape.columns, shape.rows}, depth - 1);
    // The sum of a float1x1 and a float is a float, which has no transpose.
    if (shape.rows == 1 && shape.columns == 1) return m;
    return Call("transpose", {&m}, f, shape, m.range);
  }
  if (shape.IsScalar()) {
    const int size = context.Between(2, 4);
    const Expr m = MakeIn(context, f, {size, size}, kUnit, depth - 1);
    // Up to 24 products of four numbers of 2 fractional bits up to 4.
    return Call("determinant", {&m}, f, shape, {-24 * 256, 24 * 256, 2 * size});
  }
  const Expr a = MakeIn(context, f, shape, kUnit, depth - 1);
  const Expr b = MakeIn(context, f, shape, kUnit, depth - 1);
  if (shape.columns == 3 && context.Chance(40))
    return Call("cross", {&a, &b}, f, shape, {-32, 32, 4});
  if (context.Chance(50)) return Call("reflect", {&a, &b}, f, shape, {-516, 516, 6});
  const Expr c = MakeIn(context, f, shape, kUnit, depth - 1);
  return Call("faceforward", {&a, &b, &c}, f, shape, kUnit);
}

// A float that is surely not zero, so that nobody sees the sign of a zero.
Expr MakePositive(Context& context, Shape shape, int depth) {
  Expr a = MakeIn(context, Kind::kFloat, shape, kSmallFloats, depth);
  a = Call("abs", {&a}, Kind::kFloat, shape, Absolute(a.range));
  const Expr quarter = Literal(Kind::kFloat, 0.25);
  return {a.text + " + " + quarter.text, Level::kSum, Kind::kFloat, shape, {0.25, 16.25, 2}};
}

// asfloat(asint(x)) of a float without surprises.
Expr MakeBitsOfFloat(Context& context, Kind kind, Shape shape, int depth) {
  const Expr a = MakePositive(context, shape, depth - 1);
  const Expr bits = Call(context.Chance(50) ? "asuint" : "asint", {&a}, Kind::kInt, shape, {});
  return Call("asfloat", {&bits}, kind, shape, a.range);
}

Expr MakeBits(Context& context, Kind kind, Shape shape, int depth) {
  if (context.Chance(25)) {
    const Expr a = MakePositive(context, shape, depth - 1);
    return Call(kind == Kind::kInt ? "asint" : "asuint", {&a}, kind, shape,
                {0x1p23 * 120, 0x1p23 * 140});
  }
  const Expr a = MakeExpr(context, kind, shape, depth - 1);
  if (kind == Kind::kInt) return Call("asint", {&a}, kind, shape, a.range);
  const bool first = context.Chance(Feature::kFirstBits, 40);
  if (first && context.Chance(50)) return Call("firstbithigh", {&a}, kind, shape, Wild(kind));
  if (first) return Call("firstbitlow", {&a}, kind, shape, Wild(kind));
  if (context.Chance(50)) return Call("reversebits", {&a}, kind, shape, Wild(kind));
  return Call("countbits", {&a}, kind, shape, {0, 32});
}

Expr MakeSign(Context& context, Shape shape, int depth) {
  const Kind of = context.Chance(50) ? Kind::kFloat : Kind::kInt;
  const Expr a = MakeExpr(context, of, shape, depth - 1);
  return Call("sign", {&a}, Kind::kInt, shape, {-1, 1});
}

// any and all, of a value of any kind and shape.
Expr MakeAny(Context& context, Shape shape, int depth) {
  const Kind of = static_cast<Kind>(context.Pick({2, 2, 1, 4}));
  const Shape from{context.Chance(Feature::kMatrices, 30) ? context.Between(1, 4) : 0,
                   context.Between(1, 4)};
  const Expr a = MakeExpr(context, of, from, depth - 1);
  const Expr result = Call(context.Chance(50) ? "any" : "all", {&a}, Kind::kBool, kScalar, {0, 1});
  return Reshape(context, result, shape);
}

bool HasBits(const Context& context) {
  return context.Has(Feature::kWildInts) && context.model >= 50;
}

Expr MakeFloat(Context& context, Shape shape, int depth) {
  constexpr Kind kFloat = Kind::kFloat;
  switch (context.Pick({3, 3, 3, 2, 2, 2, 2, 1, 4, 3, 1})) {
    case 0: return MakeAbsolute(context, kFloat, shape, depth);
    case 1: return MakeLimited(context, kFloat, shape, depth);
    case 2: return MakeRounding(context, shape, depth);
    case 3: return MakeMad(context, kFloat, shape, depth);
    case 4: return MakeLerp(context, shape, depth);
    case 5: return MakeStep(context, shape, depth);
    case 6: return MakeFraction(context, shape, depth);
    case 7: return MakeLdexp(context, shape, depth);
    case 8: return MakeProduct(context, kFloat, shape, depth);
    case 9: return MakeGeometry(context, shape, depth);
    default: return MakeBitsOfFloat(context, kFloat, shape, depth);
  }
}

}  // namespace

Expr MakeIntrinsic(Context& context, Kind kind, Shape shape, int depth) {
  if (kind == Kind::kFloat) {
    Expr made = MakeFloat(context, shape, depth);
    return IsExact(made.range) ? made : MakeExpr(context, kind, shape, 0);
  }
  if (kind == Kind::kBool) return MakeAny(context, shape, depth);
  switch (context.Pick({2, 3, 1, 2, 2, HasBits(context) ? 2u : 0u})) {
    case 0:
      return kind == Kind::kInt ? MakeAbsolute(context, kind, shape, depth)
                                : MakeLimited(context, kind, shape, depth);
    case 1: return MakeLimited(context, kind, shape, depth);
    case 2: return MakeMad(context, kind, shape, depth);
    case 3:
      return kind == Kind::kInt ? MakeSign(context, shape, depth)
                                : MakeLimited(context, kind, shape, depth);
    case 4: return MakeProduct(context, kind, shape, depth);
    default: return MakeBits(context, kind, shape, depth);
  }
}

}  // namespace clipc::random
