// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "tools/random/context.h"

// Expressions of generated programs.
namespace clipc::random {

// The precedence of an expression, as in C.
enum class Level : std::uint8_t {
  kComma,
  kAssignment,
  kChoice,
  kLogicalOr,
  kLogicalAnd,
  kOr,
  kXor,
  kAnd,
  kEquality,
  kRelation,
  kShift,
  kSum,
  kProduct,
  kUnary,
  kPostfix
};

struct Expr {
  std::string text;
  Level level = Level::kPostfix;
  Kind kind = Kind::kFloat;
  Shape shape;
  Range range;
};

// The text of an expression, in parentheses unless it binds at least as strongly as `level`.
std::string At(const Expr& expr, Level level);
inline std::string Argument(const Expr& expr) { return At(expr, Level::kAssignment); }

// `value` as a literal of that kind: "-0.25", "3u", "true".
Expr Literal(Kind kind, double value);
std::string NameOf(Kind kind, Shape shape);

// A random expression of that type, of at most `depth` levels. Floats are exact (range.h).
Expr MakeExpr(Context& context, Kind kind, Shape shape, int depth);
// An expression as MakeExpr makes it, with values in `range`.
Expr MakeIn(Context& context, Kind kind, Shape shape, const Range& range, int depth);
// An expression as MakeExpr makes it, with values that a variable may hold.
Expr MakeValue(Context& context, const Type& type, int depth);
// An int or uint in [2, 17], which may divide any other.
Expr MakeDivisor(Context& context, Kind kind, Shape shape, int depth);
// Now and then a variable that may be 0, whose quotients and remainders may be any number; an empty
// text otherwise.
Expr MakeAnyDivisor(Context& context, Kind kind, Shape shape);
// An int or uint in [0, count).
Expr MakeIndex(Context& context, int count, int depth);

// The value, changed where it has to be to lie in `range`.
Expr Fit(Context& context, Expr value, const Range& range);
// Gives the value another type, by a swizzle, a constructor or a cast.
Expr Reshape(Context& context, Expr value, Shape shape);
Expr Convert(Context& context, Expr value, Kind kind);

// A request for a random expression: its type, and the number of levels that it may have.
struct Wanted {
  Context& context;
  Kind kind;
  Shape shape;
  int depth;

  Wanted As(Kind other_kind, Shape other_shape) const {
    return {context, other_kind, other_shape, depth};
  }
  // An expression of the same type with one level less; `range` bounds its values.
  Expr Operand() const { return MakeExpr(context, kind, shape, depth - 1); }
  Expr Operand(const Range& range) const { return MakeIn(context, kind, shape, range, depth - 1); }
  bool Chance(std::uint32_t percent) const { return context.Chance(percent); }
};

// intrinsic.cpp: a call of a function of HLSL whose result is exact.
Expr MakeIntrinsic(const Wanted& wanted);
// soft.cpp: a float expression with functions that round.
std::string MakeSoft(Context& context, int columns, int depth);
// call.cpp: a call of a function of the program that returns that type, or nothing.
bool HasCall(const Context& context, const Type& result);
std::string MakeCall(Context& context, const Type& result, int depth);
std::string MakeVoidCall(Context& context, int depth);

// place.cpp: a variable or a part of one.
struct Place {
  std::string text;
  Kind kind = Kind::kFloat;
  Shape shape;
  Range range;
  bool found = false;
};
// A place of that kind, in any shape.
Place MakePlace(Context& context, Kind kind, bool writes, int depth);
// A place of exactly that type; not found where no variable has one.
Place MakePlaceOf(Context& context, const Type& type, bool writes);
// The text of a place of that type that may be read, or of a zero where no variable has one.
std::string MakeReadOf(Context& context, const Type& type);
// Whether `place op= value` is a statement that the program may have.
bool MayCompound(const Context& context, const Place& place);

}  // namespace clipc::random
