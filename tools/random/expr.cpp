// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/expr.h"

#include <cmath>
#include <cstdio>

namespace clipc::random {
namespace {

Level Above(Level level) { return static_cast<Level>(static_cast<int>(level) + 1); }

// An operator's name and how it binds.
struct Operator {
  const char* name;
  Level level;
};

Expr Binary(const Wanted& wanted, const Expr& left, const Operator& op, const Expr& right,
            const Range& range) {
  return {At(left, op.level) + " " + op.name + " " + At(right, Above(op.level)), op.level,
          wanted.kind, wanted.shape, range};
}

Expr MakeLiteral(Context& context, Kind kind, Shape shape) {
  constexpr double kFloats[] = {0, 1, 0.5, 2, -1, 0.25, 3, -0.5, 1.5, 4, -2, 0.75, -3.25};
  constexpr double kInts[] = {0, 1, 2, 3, 5, 7, 8, -1, -2, -5, 4};
  const auto one = [&] {
    switch (kind) {
      case Kind::kFloat: return Literal(kind, context.OneOf(kFloats));
      case Kind::kInt: return Literal(kind, context.OneOf(kInts));
      case Kind::kUint: {
        const bool is_wild = context.Chance(Feature::kWildInts, 10);
        return Literal(kind, is_wild ? 0xffffffff - context.Below(9) : context.Below(9));
      }
      case Kind::kBool: return Literal(kind, context.Below(2));
    }
    return Expr{};
  };
  if (shape.IsScalar()) return one();
  if (context.Pick({3, 1}) == 1) return Reshape(context, one(), shape);
  Expr all = one();
  std::string text = NameOf(kind, shape) + "(" + all.text;
  for (int i = 1; i < shape.Components(); ++i) {
    const Expr next = one();
    text += ", " + next.text;
    all.range = Union(all.range, next.range);
  }
  return {text + ")", Level::kPostfix, kind, shape, all.range};
}

Expr MakeRead(Context& context, Kind kind, Shape shape, int depth) {
  Kind from = kind;
  if (context.Chance(15)) from = context.OneOf(kKinds);
  const Place place = MakePlace(context, from, false, depth);
  if (!place.found) return MakeLiteral(context, kind, shape);
  const Expr value{place.text, Level::kPostfix, place.kind, place.shape, place.range};
  return Reshape(context, Convert(context, value, kind), shape);
}

// An operand of an operator whose other operand has that type: a type that converts to it by
// itself, with no loss.
Expr MakeOperand(const Wanted& wanted) {
  const auto& [context, kind, shape, depth] = wanted;
  Kind from = kind;
  if (context.Chance(12)) {
    from = static_cast<Kind>(context.Pick({1, 2, 2, 1}));
    const auto rank = [](Kind of) {
      return of == Kind::kFloat ? 3 : of == Kind::kUint ? 2 : of == Kind::kInt ? 1 : 0;
    };
    if (rank(from) > rank(kind)) from = kind;
  }
  Expr value = wanted.As(from, context.Chance(15) ? kScalar : shape).Operand();
  if (from == kind) return value;
  if (!CanConvert(value.range, from, kind)) value = Fit(context, value, VariableRange(from));
  value.range = Converted(value.range, from, kind);
  return value;
}

void MakeSmall(Context& context, Expr& a, Expr& b) {
  if (a.kind == Kind::kFloat) a = Fit(context, a, kSmallFloats);
  if (b.kind == Kind::kFloat) b = Fit(context, b, kSmallFloats);
}

Expr MakeFloatOperation(const Wanted& wanted) {
  Context& context = wanted.context;
  const std::size_t choice = context.Pick({4, 3, 4, 1, 1});
  Expr a = wanted.Operand();
  if (choice >= 3) {
    constexpr double kPowers[] = {2, 4, 0.5, -2};
    const double by = context.OneOf(kPowers);
    const Expr divisor = Literal(Kind::kFloat, by);
    const bool divides = choice == 3;
    Range range = Product(a.range, {1 / by, 1 / by, by > 1 || by < -1 ? 2 : 0});
    if (!divides) range = {-std::abs(by), std::abs(by), a.range.fraction};
    if (!IsExact(range)) return a;
    return Binary(wanted, a, {divides ? "/" : "%", Level::kProduct}, divisor, range);
  }
  Expr b = MakeOperand(wanted);
  const auto range = [&] {
    if (choice == 0) return Sum(a.range, b.range);
    return choice == 1 ? Sum(a.range, Negated(b.range)) : Product(a.range, b.range);
  };
  if (!IsExact(range())) MakeSmall(context, a, b);
  if (!IsExact(range()))
    b = Fit(context, MakeExpr(context, Kind::kFloat, wanted.shape, 0), kSmallFloats);
  constexpr Operator kOperators[] = {
      {"+", Level::kSum}, {"-", Level::kSum}, {"*", Level::kProduct}};
  if (context.Chance(50) && choice != 1) std::swap(a, b);
  return Binary(wanted, a, kOperators[choice], b, range());
}

bool MayHaveEffects(const Context& context) {
  return context.effects && context.Has(Feature::kSideEffects);
}

Expr MakeEffect(const Wanted& wanted);

Range BitsRange(Kind kind, const Range& a, const Range& b) {
  if (a.low < 0 || b.low < 0) return Wild(kind);
  double power = 1;
  while (power <= std::max(a.high, b.high)) power *= 2;
  return {0, power - 1};
}

Expr MakeIntegerOperation(const Wanted& wanted) {
  const auto& [context, kind, shape, depth] = wanted;
  constexpr Operator kOperators[] = {
      {"+", Level::kSum},     {"-", Level::kSum},    {"*", Level::kProduct}, {"&", Level::kAnd},
      {"|", Level::kOr},      {"^", Level::kXor},    {"<<", Level::kShift},  {">>", Level::kShift},
      {"/", Level::kProduct}, {"%", Level::kProduct}};
  const std::size_t choice = context.Pick({4, 3, 3, 2, 2, 2, 2, 2, 2, 2});
  const Operator& op = kOperators[choice];
  Expr a = wanted.Operand();
  if (choice >= 8) {
    const Expr any = MakeAnyDivisor(context, kind, shape);
    if (!any.text.empty()) return Binary(wanted, a, op, any, Wild(kind));
    const Expr b = MakeDivisor(context, kind, context.Chance(30) ? kScalar : shape, depth - 1);
    const Range range = choice == 8 ? a.range : a.range.low < 0 ? Range{-16, 16} : Range{0, 16};
    return Binary(wanted, a, op, b, range);
  }
  if (choice == 6 || choice == 7) {
    const Expr b = wanted.As(kind, context.Chance(30) ? kScalar : shape).Operand();
    return Binary(wanted, a, op, b,
                  choice == 6       ? Wild(kind)
                  : a.range.low < 0 ? a.range
                                    : Range{0, a.range.high});
  }
  Expr b = MakeOperand(wanted);
  Range range;
  switch (choice) {
    case 0: range = Integers(kind, a.range.low + b.range.low, a.range.high + b.range.high); break;
    case 1: range = Integers(kind, a.range.low - b.range.high, a.range.high - b.range.low); break;
    case 2: {
      const Range product = Product(a.range, b.range);
      range = Integers(kind, product.low, product.high);
      break;
    }
    default: range = BitsRange(kind, a.range, b.range);
  }
  if (choice != 1 && context.Chance(30)) std::swap(a, b);
  return Binary(wanted, a, op, b, range);
}

Expr MakeBoolOperation(const Wanted& wanted) {
  const auto& [context, boolean, shape, depth] = wanted;
  constexpr Operator kOperators[] = {{"<", Level::kRelation},    {">", Level::kRelation},
                                     {"<=", Level::kRelation},   {">=", Level::kRelation},
                                     {"==", Level::kEquality},   {"!=", Level::kEquality},
                                     {"&&", Level::kLogicalAnd}, {"||", Level::kLogicalOr}};
  // HLSL 2021 takes scalars only.
  const std::uint32_t logical = context.model >= 60 && !shape.IsScalar() ? 0 : 4;
  const std::size_t choice = context.Pick({2, 2, 2, 2, 2, 2, logical, logical});
  if (choice >= 6) {
    const Expr a = wanted.Operand();
    const Expr b =
        depth > 0 && MayHaveEffects(context) && context.Chance(50)
            ? Convert(context, MakeEffect({context, Kind::kInt, shape, depth - 1}), Kind::kBool)
            : wanted.Operand();
    return Binary(wanted, a, kOperators[choice], b, {0, 1});
  }
  const Kind kind = static_cast<Kind>(context.Pick({4, 3, 2, choice < 4 ? 0u : 1u}));
  const Wanted compared = wanted.As(kind, shape);
  const Expr a = compared.Operand(), b = MakeOperand(compared);
  return Binary(wanted, a, kOperators[choice], b, {0, 1});
}

Expr MakeOperation(const Wanted& wanted) {
  switch (wanted.kind) {
    case Kind::kFloat: return MakeFloatOperation(wanted);
    case Kind::kBool: return MakeBoolOperation(wanted);
    default: return MakeIntegerOperation(wanted);
  }
}

Expr MakeUnary(const Wanted& wanted) {
  const auto& [context, kind, shape, depth] = wanted;
  // The bits of a negative number, which the compiler makes one: GLSL reads `--2` as a decrement.
  const bool is_negative = kind == Kind::kInt && context.Chance(Feature::kWildInts, 10);
  const Expr a =
      is_negative
          ? Reshape(context, Convert(context, Literal(Kind::kUint, 0xfffffffe), kind), shape)
          : wanted.Operand();
  if (kind == Kind::kBool) return {"!" + At(a, Level::kUnary), Level::kUnary, kind, shape, a.range};
  const bool inverts = IsInteger(kind) && context.Chance(40);
  const std::string operand = At(a, Level::kUnary);
  const bool has_sign = operand[0] == '-';
  const Range negated = Negated(a.range);
  Range range = negated;
  if (kind == Kind::kInt) range = Integers(kind, negated.low - 1, negated.high);
  if (kind == Kind::kUint) range = Wild(kind);
  return {(inverts ? "~" : "-") + (has_sign ? "(" + operand + ")" : operand), Level::kUnary, kind,
          shape, range};
}

Expr MakeConversion(const Wanted& wanted) {
  const Kind from = wanted.context.OneOf(kKinds);
  return Convert(wanted.context, wanted.As(from, wanted.shape).Operand(), wanted.kind);
}

// float4(a, b.xy, c)
Expr MakeConstructor(const Wanted& wanted) {
  const auto& [context, kind, shape, depth] = wanted;
  if (shape.IsScalar()) return wanted.Operand();
  std::string text;
  Range range;
  int left = shape.Components();
  for (bool first = true; left > 0; first = false) {
    const int size = context.Between(1, std::min(left, 4));
    const Expr part = wanted.As(kind, {0, size}).Operand();
    range = first ? part.range : Union(range, part.range);
    text += (first ? "" : ", ") + Argument(part);
    left -= size;
  }
  return {NameOf(kind, shape) + "(" + text + ")", Level::kPostfix, kind, shape, range};
}

Expr MakeChoice(const Wanted& wanted) {
  const auto& [context, kind, shape, depth] = wanted;
  const bool by_component = context.model < 60 && !shape.IsScalar() && context.Chance(60);
  const Expr condition = wanted.As(Kind::kBool, by_component ? shape : kScalar).Operand();
  const Temporarily no_effects(context.effects,
                               context.effects && context.Has(Feature::kEffectsInChoices));
  const Expr a = wanted.Operand(), b = wanted.Operand();
  return {At(condition, Level::kLogicalOr) + " ? " + At(a, Level::kChoice) + " : " +
              At(b, Level::kChoice),
          Level::kChoice, kind, shape, Union(a.range, b.range)};
}

// (a = b), a++, (f(), a), (a /= b), (a = 3 - a)
Expr MakeEffect(const Wanted& wanted) {
  const auto& [context, kind, shape, depth] = wanted;
  const std::size_t choice = context.indices == Indices::kWriting ? context.Pick({0, 1, 0, 1, 2})
                                                                  : context.Pick({3, 4, 1, 1, 1});
  const bool mirrors = choice == 4 && kind != Kind::kBool;
  const Place place = [&] {
    // A place that is written down twice has constant indices.
    const Temporarily indices(context.indices, mirrors ? Indices::kConstant : context.indices);
    return MakePlace(context, kind, true, depth - 1);
  }();
  if (!place.found) return wanted.Operand();
  const bool is_wild = IsInteger(kind) && place.range.IsWithin(Wild(kind).low, Wild(kind).high) &&
                       place.range.high > 1e6;
  Expr value{place.text, Level::kPostfix, kind, place.shape, place.range};
  if (choice == 1 && is_wild) {
    const bool adds = context.Chance(50), before = context.Chance(50);
    const std::string sign = adds ? "++" : "--";
    value.text = before ? sign + place.text : place.text + sign;
    value.level = before ? Level::kUnary : Level::kPostfix;
    return Reshape(context, value, shape);
  }
  // A quotient, a remainder and a mirrored number stay in the range of the number.
  const bool divides = choice == 3 && IsInteger(kind) && MayCompound(context, place);
  const Expr right = [&] {
    if (divides) return MakeDivisor(context, kind, place.shape, depth - 1);
    if (!mirrors) return wanted.As(kind, place.shape).Operand(place.range);
    const Expr ends = Literal(kind, place.range.low + place.range.high);
    return Binary(wanted.As(kind, place.shape), ends, {"-", Level::kSum}, value, place.range);
  }();
  const char* op = !divides ? " = " : context.Chance(50) ? " %= " : " /= ";
  value.text = place.text + op + At(right, Level::kAssignment);
  value.level = Level::kAssignment;
  if (choice == 2) {
    const Expr last = wanted.Operand();
    return {value.text + ", " + At(last, Level::kAssignment), Level::kComma, kind, shape,
            last.range};
  }
  return Reshape(context, value, shape);
}

Expr MakeCalled(const Wanted& wanted) {
  const auto& [context, kind, shape, depth] = wanted;
  const Type type{kind, shape};
  if (!HasCall(context, type)) return MakeIntrinsic(wanted);
  return {MakeCall(context, type, depth), Level::kPostfix, kind, shape, VariableRange(kind)};
}

}  // namespace

std::string At(const Expr& expr, Level level) {
  return expr.level < level ? "(" + expr.text + ")" : expr.text;
}

std::string NameOf(Kind kind, Shape shape) { return NameOf({}, Type{kind, shape}); }

Expr Literal(Kind kind, double value) {
  char text[32];
  switch (kind) {
    case Kind::kFloat:
      std::snprintf(text, sizeof text, value == std::floor(value) ? "%.1f" : "%.9g", value);
      break;
    case Kind::kInt: std::snprintf(text, sizeof text, "%.0f", value); break;
    case Kind::kUint: std::snprintf(text, sizeof text, "%.0fu", value); break;
    case Kind::kBool: std::snprintf(text, sizeof text, value != 0 ? "true" : "false"); break;
  }
  int fraction = 0;
  while (std::ldexp(value, fraction) != std::floor(std::ldexp(value, fraction))) ++fraction;
  return {
      text, value < 0 ? Level::kUnary : Level::kPostfix, kind, kScalar, {value, value, fraction}};
}

Expr MakeExpr(Context& context, Kind kind, Shape shape, int depth) {
  const SpanOf span(context.choices);
  if (context.only_literals) return MakeLiteral(context, kind, shape);
  if (depth <= 0 || context.choices.IsSpent()) {
    return context.Pick({1, 2}) == 0 ? MakeLiteral(context, kind, shape)
                                     : MakeRead(context, kind, shape, 0);
  }
  const Wanted wanted{context, kind, shape, depth};
  switch (context.Pick({2, 8, 8, 2, 2, 3, 6, 3, 4, MayHaveEffects(context) ? 3u : 0u})) {
    case 0: return MakeLiteral(context, kind, shape);
    case 1: return MakeRead(context, kind, shape, depth - 1);
    case 2: return MakeOperation(wanted);
    case 3: return MakeUnary(wanted);
    case 4: return MakeConversion(wanted);
    case 5: return MakeConstructor(wanted);
    case 6: return MakeIntrinsic(wanted);
    case 7: return MakeChoice(wanted);
    case 8: return MakeCalled(wanted);
    default: return MakeEffect(wanted);
  }
}

Expr MakeIn(Context& context, Kind kind, Shape shape, const Range& range, int depth) {
  return Fit(context, MakeExpr(context, kind, shape, depth), range);
}

Expr MakeValue(Context& context, const Type& type, int depth) {
  return MakeIn(context, type.kind, type.shape, VariableRange(type.kind), depth);
}

Expr MakeDivisor(Context& context, Kind kind, Shape shape, int depth) {
  const Expr value = MakeIn(context, kind, shape, {0, 15}, depth);
  return Binary({context, kind, shape, depth}, value, {"+", Level::kSum}, Literal(kind, 2),
                {2, 17});
}

Expr MakeAnyDivisor(Context& context, Kind kind, Shape shape) {
  Expr value;
  if (context.only_literals || !context.Chance(Feature::kZeroDivisors, 30)) return value;
  std::vector<const Variable*> found;
  for (const Variable* variable : context.Visible()) {
    // A constant 0 is an error.
    const bool fits = variable->writable && variable->type.IsNumeric() &&
                      variable->type.kind == kind && context.MayUse(*variable, false);
    if (fits) found.push_back(variable);
  }
  if (found.empty()) return value;
  const Variable& variable = *context.OneOf(found);
  context.Use(variable, false);
  value = {variable.name, Level::kPostfix, kind, variable.type.shape, RangeOf(variable, kind)};
  return Reshape(context, value, shape);
}

Expr MakeIndex(Context& context, int count, int depth) {
  const bool may_write = depth > 0 && MayHaveEffects(context);
  const bool writes = context.indices == Indices::kWriting && may_write;
  if ((context.Pick({2, 1}) == 0 && !writes) || context.indices == Indices::kConstant)
    return Literal(Kind::kInt, context.Below(count));
  const Kind kind = context.Chance(40) ? Kind::kUint : Kind::kInt;
  const Range range{0, static_cast<double>(count - 1)};
  if (may_write && (writes || context.Chance(40)))
    return Fit(context, MakeEffect({context, kind, kScalar, depth}), range);
  return MakeIn(context, kind, kScalar, range, depth);
}

}  // namespace clipc::random
