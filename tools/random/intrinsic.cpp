// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cmath>

#include "tools/random/expr.h"

namespace clipc::random {
namespace {

constexpr Range kUnit{-4, 4, 2};

Expr Call(const Wanted& wanted, const std::string& name,
          std::initializer_list<const Expr*> arguments, const Range& range) {
  std::string text = name + "(";
  for (const Expr* argument : arguments)
    text += (text.back() == '(' ? "" : ", ") + Argument(*argument);
  return {text + ")", Level::kPostfix, wanted.kind, wanted.shape, range};
}

Expr MakeRounding(const Wanted& wanted) {
  constexpr const char* kNames[] = {"floor", "ceil", "round", "trunc"};
  const char* name = wanted.context.OneOf(kNames);
  const Expr a = wanted.Operand();
  return Call(wanted, name, {&a}, RoundedDown(a.range));
}

Expr MakeLimited(const Wanted& wanted) {
  Context& context = wanted.context;
  const bool may_nest = wanted.shape.IsScalar() || context.Has(Feature::kNestedLimits);
  const Wanted operand{context, wanted.kind, wanted.shape, may_nest ? wanted.depth : 0};
  const Expr a = operand.Operand(), b = operand.Operand();
  switch (context.Pick({1, 1, 1})) {
    case 0: return Call(wanted, "min", {&a, &b}, Least(a.range, b.range));
    case 1: return Call(wanted, "max", {&a, &b}, Greatest(a.range, b.range));
    default: break;
  }
  // clamp's bounds are in order: which one wins otherwise is nobody's promise.
  const double low = context.Between(0, 4), size = context.Between(1, 9);
  const Expr least = Literal(wanted.kind, low), greatest = Literal(wanted.kind, low + size);
  return Call(wanted, "clamp", {&a, &least, &greatest},
              {std::clamp(a.range.low, low, low + size), std::clamp(a.range.high, low, low + size),
               a.range.fraction});
}

Expr MakeAbsolute(const Wanted& wanted) {
  const Expr a = wanted.Operand();
  return a.range.low <= -0x1p31 ? a : Call(wanted, "abs", {&a}, Absolute(a.range));
}

Expr MakeMad(const Wanted& wanted) {
  const bool is_float = wanted.kind == Kind::kFloat;
  Expr all[3];
  for (Expr& one : all) {
    one = wanted.Operand();
    if (is_float) one = Fit(wanted.context, one, kSmallFloats);
  }
  const Range sum = Sum(Product(all[0].range, all[1].range), all[2].range);
  return Call(wanted, "mad", {&all[0], &all[1], &all[2]},
              is_float ? sum : Integers(wanted.kind, sum.low, sum.high));
}

// a + s * (b - a): every term is exact, whichever formula it is.
Expr MakeLerp(const Wanted& wanted) {
  const Expr a = wanted.Operand(kSmallFloats), b = wanted.Operand(kSmallFloats);
  const Shape shape = wanted.Chance(40) ? kScalar : wanted.shape;
  const Expr s = wanted.As(Kind::kFloat, shape).Operand({-2, 2, 2});
  const Range range = Sum(a.range, Product(s.range, Sum(b.range, Negated(a.range))));
  return Call(wanted, "lerp", {&a, &b, &s}, range);
}

Expr MakeStep(const Wanted& wanted) {
  const Expr a = wanted.Operand(), b = wanted.Operand();
  if (!wanted.Chance(30)) return Call(wanted, "step", {&a, &b}, {0, 1});
  const Expr low = Literal(Kind::kFloat, wanted.context.Between(0, 2));
  const Expr high = Literal(Kind::kFloat, low.range.low + (wanted.Chance(50) ? 4 : 2));
  const Expr x = Fit(wanted.context, a, kSmallFloats);
  return Call(wanted, "smoothstep", {&low, &high, &x}, {0, 1, 14});
}

Expr MakeFraction(const Wanted& wanted) {
  const Expr a = wanted.Operand();
  return Call(wanted, wanted.Chance(50) ? "saturate" : "frac", {&a}, {0, 1, a.range.fraction});
}

Expr MakeLdexp(const Wanted& wanted) {
  const Expr a = wanted.Operand(kSmallFloats);
  const Expr e = wanted.As(Kind::kInt, wanted.shape).Operand({-3, 3});
  return Call(
      wanted, "ldexp", {&a, &e},
      {std::min(a.range.low * 8, 0.0), std::max(a.range.high * 8, 0.0), a.range.fraction + 3});
}

// dot, and the product of vectors and matrices.
Expr MakeProduct(const Wanted& wanted) {
  const auto& [context, kind, shape, depth] = wanted;
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
  Expr a = wanted.As(kind, left).Operand();
  Expr b = wanted.As(kind, right).Operand();
  if (kind == Kind::kFloat) {
    a = Fit(context, a, kSmallFloats);
    b = Fit(context, b, kSmallFloats);
  }
  Range range = Times(Product(a.range, b.range), 4);
  if (kind != Kind::kFloat) range = Integers(kind, range.low, range.high);
  range.low = std::min(range.low, 0.0), range.high = std::max(range.high, 0.0);
  return Call(wanted, is_dot && context.Chance(60) ? "dot" : "mul", {&a, &b}, range);
}

// Functions of whole vectors and matrices.
Expr MakeGeometry(const Wanted& wanted) {
  const Shape shape = wanted.shape;
  if (shape.IsMatrix()) {
    const Expr m = wanted.As(Kind::kFloat, {shape.columns, shape.rows}).Operand();
    // The sum of a float1x1 and a float is a float, which has no transpose.
    if (shape.rows == 1 && shape.columns == 1) return m;
    return Call(wanted, "transpose", {&m}, m.range);
  }
  if (shape.IsScalar()) {
    const int size = wanted.context.Between(2, 4);
    const Expr m = wanted.As(Kind::kFloat, {size, size}).Operand(kUnit);
    // Up to 24 products of four numbers of 2 fractional bits up to 4.
    return Call(wanted, "determinant", {&m}, {-24 * 256, 24 * 256, 2 * size});
  }
  const Expr a = wanted.Operand(kUnit), b = wanted.Operand(kUnit);
  if (shape.columns == 3 && wanted.Chance(40)) return Call(wanted, "cross", {&a, &b}, {-32, 32, 4});
  if (wanted.Chance(50)) return Call(wanted, "reflect", {&a, &b}, {-516, 516, 6});
  const Expr c = wanted.Operand(kUnit);
  return Call(wanted, "faceforward", {&a, &b, &c}, kUnit);
}

// A float that is surely not zero, so that nobody sees the sign of a zero.
Expr MakePositive(const Wanted& wanted) {
  const Wanted positive = wanted.As(Kind::kFloat, wanted.shape);
  Expr a = positive.Operand(kSmallFloats);
  a = Call(positive, "abs", {&a}, Absolute(a.range));
  const Expr quarter = Literal(Kind::kFloat, 0.25);
  return {a.text + " + " + quarter.text, Level::kSum, Kind::kFloat, wanted.shape, {0.25, 16.25, 2}};
}

// asfloat(asint(x)) of a float without surprises.
Expr MakeBitsOfFloat(const Wanted& wanted) {
  const Expr a = MakePositive(wanted);
  const Wanted integer = wanted.As(Kind::kInt, wanted.shape);
  const Expr bits = Call(integer, wanted.Chance(50) ? "asuint" : "asint", {&a}, {});
  return Call(wanted, "asfloat", {&bits}, a.range);
}

Expr MakeBits(const Wanted& wanted) {
  const Range wild = Wild(wanted.kind);
  if (wanted.Chance(25)) {
    const Expr a = MakePositive(wanted);
    return Call(wanted, wanted.kind == Kind::kInt ? "asint" : "asuint", {&a},
                {0x1p23 * 120, 0x1p23 * 140});
  }
  const Expr a = wanted.Operand();
  if (wanted.kind == Kind::kInt) return Call(wanted, "asint", {&a}, a.range);
  const bool first = wanted.context.Chance(Feature::kFirstBits, 40);
  if (first) return Call(wanted, wanted.Chance(50) ? "firstbithigh" : "firstbitlow", {&a}, wild);
  if (wanted.Chance(50)) return Call(wanted, "reversebits", {&a}, wild);
  return Call(wanted, "countbits", {&a}, {0, 32});
}

Expr MakeSign(const Wanted& wanted) {
  const Kind of = wanted.Chance(50) ? Kind::kFloat : Kind::kInt;
  const Expr a = wanted.As(of, wanted.shape).Operand();
  return Call(wanted, "sign", {&a}, {-1, 1});
}

// any and all, of a value of any kind and shape.
Expr MakeAny(const Wanted& wanted) {
  Context& context = wanted.context;
  const Kind of = static_cast<Kind>(context.Pick({2, 2, 1, 4}));
  const Shape from{context.Chance(Feature::kMatrices, 30) ? context.Between(1, 4) : 0,
                   context.Between(1, 4)};
  const Expr a = wanted.As(of, from).Operand();
  const Wanted one = wanted.As(Kind::kBool, kScalar);
  return Reshape(context, Call(one, context.Chance(50) ? "any" : "all", {&a}, {0, 1}),
                 wanted.shape);
}

bool HasBits(const Context& context) {
  return context.Has(Feature::kWildInts) && context.model >= 50;
}

Expr MakeFloat(const Wanted& wanted) {
  switch (wanted.context.Pick({3, 3, 3, 2, 2, 2, 2, 1, 4, 3, 1})) {
    case 0: return MakeAbsolute(wanted);
    case 1: return MakeLimited(wanted);
    case 2: return MakeRounding(wanted);
    case 3: return MakeMad(wanted);
    case 4: return MakeLerp(wanted);
    case 5: return MakeStep(wanted);
    case 6: return MakeFraction(wanted);
    case 7: return MakeLdexp(wanted);
    case 8: return MakeProduct(wanted);
    case 9: return MakeGeometry(wanted);
    default: return MakeBitsOfFloat(wanted);
  }
}

}  // namespace

Expr MakeIntrinsic(const Wanted& wanted) {
  const auto& [context, kind, shape, depth] = wanted;
  if (kind == Kind::kFloat) {
    Expr made = MakeFloat(wanted);
    return IsExact(made.range) ? made : MakeExpr(context, kind, shape, 0);
  }
  if (kind == Kind::kBool) return MakeAny(wanted);
  switch (context.Pick({2, 3, 1, 2, 2, HasBits(context) ? 2u : 0u})) {
    case 0: return kind == Kind::kInt ? MakeAbsolute(wanted) : MakeLimited(wanted);
    case 1: return MakeLimited(wanted);
    case 2: return MakeMad(wanted);
    case 3: return kind == Kind::kInt ? MakeSign(wanted) : MakeLimited(wanted);
    case 4: return MakeProduct(wanted);
    default: return MakeBits(wanted);
  }
}

}  // namespace clipc::random
