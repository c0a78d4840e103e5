// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/random/statement.h"

#include <algorithm>

namespace clipc::random {
namespace {

constexpr int kMostIterations = 64;
constexpr int kDepth = 3;  // of expressions

bool IsWild(const Place& place) { return IsInteger(place.kind) && place.range.high > 1e6; }

std::string Indent(const Context& context) {
  return std::string(static_cast<std::size_t>(context.indent), ' ');
}

std::string Line(const Context& context, const std::string& text) {
  return Indent(context) + text + ";\n";
}

// A value for the place, now and then of another kind or shape, which is converted without a cast.
Expr MakeConvertible(Context& context, const Place& place) {
  if (!context.Chance(20)) {
    return MakeIn(context, place.kind, place.shape, place.range, kDepth);
  }
  const Kind kind = context.OneOf(kKinds);
  Shape shape = place.shape;
  if (context.Chance(30)) {
    shape = kScalar;
  } else if (!shape.IsMatrix() && context.Chance(30)) {
    shape.columns = context.Between(shape.columns, 4);
  }
  Range range =
      IsWild(place) || place.kind == Kind::kBool ? VariableRange(Kind::kUint) : place.range;
  if (kind == Kind::kUint) range.low = 0;
  return MakeIn(context, kind, shape, range, kDepth);
}

std::string MakeAssignment(Context& context) {
  const Kind kind = context.OneOf(kKinds);
  const bool is_pure = context.Chance(30);
  const Temporarily effects(context.effects, context.effects && !is_pure);
  const Place place = MakePlace(context, kind, true, 2);
  if (!place.found) return {};
  // A value without effects may read the assigned variable, which is read before it is written.
  if (is_pure) context.EndExpression();
  return Line(context, place.text + " = " + Argument(MakeConvertible(context, place)));
}

// `p op= value`, and then p is put back into its range.
std::string MakeCompound(Context& context) {
  const Kind kind = static_cast<Kind>(context.Pick({4, 3, 2}));
  // A place that is put back is written twice, so its indices are constants.
  const auto indices =
      kind == Kind::kFloat ? Indices::kConstant : static_cast<Indices>(context.Pick({2, 1, 1}));
  const bool computes = indices != Indices::kConstant;
  const Place place = [&] {
    const Temporarily chosen(context.indices, indices);
    return MakePlace(context, kind, true, 2);
  }();
  if (!place.found) return {};
  if (computes && !MayCompound(context, place)) return MakeAssignment(context);
  const Shape shape = context.Chance(25) ? kScalar : place.shape;
  const auto fit = [&](const Range& range) {
    if (IsWild(place)) return std::string();
    Expr now{place.text, Level::kPostfix, kind, place.shape, range};
    now = Fit(context, now, place.range);
    return now.text == place.text ? std::string()
                                  : Line(context, place.text + " = " + Argument(now));
  };
  if (kind == Kind::kFloat) {
    constexpr const char* kOperators[] = {" += ", " -= ", " *= ", " /= "};
    const std::size_t choice = context.Pick({3, 2, 3, 1});
    Expr value = MakeIn(context, kind, shape, {-16, 16, 2}, kDepth);
    if (choice == 3) value = Literal(kind, context.Chance(50) ? 4 : 0.5);
    Range range = Sum(place.range, value.range);
    if (choice == 1) range = Sum(place.range, Negated(value.range));
    if (choice >= 2) range = Product(place.range, {-16, 16, 2});
    return Line(context, place.text + kOperators[choice] + Argument(value)) + fit(range);
  }
  constexpr const char* kOperators[] = {
      " += ", " -= ", " *= ", " &= ", " |= ", " ^= ", " /= ", " %= ", " <<= ", " >>= "};
  // A quotient and a remainder stay in the range of the number.
  const std::uint32_t other = computes && !IsWild(place) ? 0 : 2;
  const std::size_t choice =
      context.Pick({other, other, other, other, other, other, 1, 4, other / 2, other / 2});
  const bool divides = choice == 6 || choice == 7;
  Expr value;
  if (divides && IsWild(place)) value = MakeAnyDivisor(context, kind, shape);
  if (value.text.empty())
    value = divides ? MakeDivisor(context, kind, shape, kDepth)
                    : MakeExpr(context, kind, shape, kDepth);
  return Line(context, place.text + kOperators[choice] + Argument(value)) +
         (divides ? "" : fit(Wild(kind)));
}

// A variable of all 32 bits, whose name `name` becomes.
std::string MakeWild(Context& context, const Type& type, const std::string& value,
                     std::string& name) {
  name = context.FreshName("v");
  context.Add({name, type, true, Holds::kWild});
  return Line(context, Declaration(context.structs, type, name) + " = " + value);
}

// An increment, of a new variable where there is none for it, and often a variable for its value.
std::string MakeIncrement(Context& context) {
  if (!context.Has(Feature::kWildInts)) return MakeAssignment(context);
  const Kind kind = context.Chance(50) ? Kind::kInt : Kind::kUint;
  Place place = MakePlace(context, kind, true, 1);
  std::string before, name;
  if (!place.found || !IsWild(place)) {
    context.EndExpression();
    place.shape = MakeShape(context);
    const std::string value = Argument(MakeExpr(context, kind, place.shape, 2));
    before = MakeWild(context, {kind, place.shape}, value, place.text);
  }
  const char* sign = context.Chance(50) ? "++" : "--";
  const std::string text = context.Chance(50) ? sign + place.text : place.text + sign;
  if (context.Chance(40)) return before + Line(context, text);
  return before + MakeWild(context, {kind, place.shape}, text, name);
}

std::string MakeDeclaration(Context& context) {
  const Type type = MakeType(context);
  const bool is_const = context.Chance(10);
  const bool is_wild =
      type.structure < 0 && IsInteger(type.kind) && context.Chance(Feature::kWildInts, 50);
  const std::string value = MakeInitial(context, type, kDepth);
  // Names that hide others do so from their own declaration on.
  std::string name = context.FreshName("v");
  if (context.Has(Feature::kOddNames) && context.scopes.size() > 2 && context.Chance(15)) {
    const auto& outer = context.scopes[context.scopes.size() - 2];
    const auto& here = context.scopes.back();
    if (!outer.empty()) {
      const Variable& hidden = context.OneOf(outer);
      if (hidden.holds != Holds::kCounter && value.find(hidden.name) == std::string::npos &&
          std::ranges::find(here, hidden.name, &Variable::name) == here.end())
        name = hidden.name;
    }
  }
  context.Add({name, type, !is_const, is_wild ? Holds::kWild : Holds::kVariable});
  const bool may_be_late = context.model >= 60 && !clipc::InfoOf(context.stage).draws_pixels;
  const bool is_static = may_be_late && context.Chance(Feature::kLateStatics, 10);
  // What a call writes, the next one may read.
  context.writes_globals |= is_static;
  return Line(context, (is_static ? "static " : "") + std::string(is_const ? "const " : "") +
                           Declaration(context.structs, type, name) + " = " + value);
}

std::string MakeBlock(Context& context, int most, int depth) {
  const ScopeOf scope(context);
  const std::string statements = [&] {
    const Temporarily deeper(context.indent, context.indent + 2);
    return MakeStatements(context, most, depth);
  }();
  return "{\n" + statements + Indent(context) + "}";
}

std::string MakeBody(Context& context, int depth) { return MakeBlock(context, 3, depth - 1); }

std::string Condition(Context& context, int depth = kDepth) {
  return MakeExpr(context, Kind::kBool, kScalar, depth).text;
}

std::string MakeIf(Context& context, int depth) {
  constexpr const char* kAttributes[] = {"", "", "[branch] ", "[flatten] "};
  std::string text = Indent(context) + context.OneOf(kAttributes) + "if (" + Condition(context) +
                     ") " + MakeBody(context, depth);
  if (context.Chance(40)) text += " else " + MakeBody(context, depth);
  return text + "\n";
}

std::string MakeFor(Context& context, int depth) {
  const int iterations = context.Between(1, 4);
  constexpr const char* kAttributes[] = {"", "", "[unroll] ", "[loop] "};
  const std::string attribute = context.OneOf(kAttributes);
  const Kind kind = context.Chance(30) ? Kind::kUint : Kind::kInt;
  const ScopeOf scope(context);
  const std::string name = "i" + std::to_string(context.names++);
  std::string head = NameOf(kind) + " " + name;
  const std::string most = Literal(kind, iterations).text;
  switch (context.Pick({3, 1, 1})) {
    case 0: head += " = 0; " + name + " < " + most + "; ++" + name; break;
    case 1: head += " = " + most + "; " + name + "-- > 0; "; break;
    default: {
      const Temporarily no_effects(context.effects, false);
      const Expr bound = MakeIn(context, kind, kScalar, {0, static_cast<double>(iterations)}, 2);
      head += " = 0; " + name + " < " + At(bound, Level::kShift) + "; " + name + "++";
    }
  }
  context.Add({name, {kind, kScalar}, false, Holds::kCounter, iterations - 1.0});
  const Temporarily inner(context.loops, context.loops + 1);
  const Temporarily continues(context.has_continue, true);
  const Temporarily nested(context.iterations, context.iterations * iterations);
  return Indent(context) + attribute + "for (" + head + ") " + MakeBody(context, depth) + "\n";
}

std::string MakeWhile(Context& context, int depth) {
  const int iterations = context.Between(1, 3);
  const ScopeOf scope(context);
  const std::string name = "w" + std::to_string(context.names++);
  const std::string declared = Line(context, "int " + name + " = " + std::to_string(iterations));
  const bool is_do = context.Chance(40);
  std::string condition = is_do ? "--" + name + " > 0" : name + "-- > 0";
  if ((!is_do || context.Has(Feature::kDoExits)) && context.Chance(50)) {
    const Temporarily no_effects(context.effects, false);
    condition += " && " + At(MakeExpr(context, Kind::kBool, kScalar, 2), Level::kEquality);
  }
  const Temporarily inner(context.loops, context.loops + 1);
  const Temporarily continues(context.has_continue, true);
  const Temporarily nested(context.iterations, context.iterations * iterations);
  const Temporarily exits(context.has_exit,
                          context.has_exit && (!is_do || context.Has(Feature::kDoExits)));
  const std::string body = MakeBody(context, depth);
  if (is_do) return declared + Indent(context) + "do " + body + " while (" + condition + ");\n";
  return declared + Indent(context) + "while (" + condition + ") " + body + "\n";
}

std::string MakeSwitch(Context& context, int depth) {
  const Kind kind = context.Chance(30) ? Kind::kUint : Kind::kInt;
  const Expr selector = MakeIn(context, kind, kScalar, {0, 5}, kDepth);
  const std::string head = Indent(context) + "switch (" + selector.text + ") {\n";
  const std::string end = Indent(context) + "}\n";
  const Temporarily labelled(context.indent, context.indent + 2);
  const Temporarily continues(context.has_continue, context.model >= 60);
  std::string text;
  const int cases = context.Between(1, 3);
  const int with_default = context.Between(0, cases);
  int value = 0;
  for (int i = 0; i < cases; ++i) {
    for (int labels = context.Between(1, 2); labels > 0; --labels)
      text += Indent(context) + "case " + Literal(kind, value++).text + ":\n";
    if (i == with_default) text += Indent(context) + "default:\n";
    const Temporarily deeper(context.indent, context.indent + 2);
    text += Indent(context) + MakeBody(context, depth) + "\n" + Line(context, "break");
  }
  return head + text + end;
}

std::string MakeJump(Context& context) {
  std::string jump;
  if (clipc::InfoOf(context.stage).draws_pixels && context.Chance(20)) {
    jump = "discard";
  } else if (!context.has_exit) {
    if (!context.has_continue) return MakeAssignment(context);
    jump = "continue";
  } else if (context.loops > 0 && context.Chance(60)) {
    jump = context.Chance(50) || !context.has_continue ? "break" : "continue";
  } else if (!context.function && clipc::InfoOf(context.stage).runs_in_groups) {
    return MakeAssignment(context);  // the others would wait for it
  } else if (!context.function || context.function->is_void) {
    const bool is_void = context.function || clipc::InfoOf(context.stage).emits_vertices;
    jump = is_void ? "return" : "return result";
  } else {
    const Type& type = context.function->result;
    jump = "return " +
           (type.IsNumeric() ? MakeValue(context, type, kDepth).text : Zero(context.structs, type));
  }
  return Indent(context) + "if (" + Condition(context) + ") " + jump + ";\n";
}

std::string MakeCopy(Context& context) {
  std::vector<Type> types;
  for (const Variable* variable : context.Visible()) {
    if (!variable->type.IsNumeric() && variable->writable) types.push_back(variable->type);
  }
  if (types.empty()) return MakeAssignment(context);
  const Type type = context.OneOf(types);
  const Place to = MakePlaceOf(context, type, true);
  if (!to.found) return MakeAssignment(context);
  if (type.IsStruct() && HasCall(context, type) && context.Chance(50))
    return Line(context, to.text + " = " + MakeCall(context, type, kDepth));
  context.EndExpression();
  const Place from = MakePlaceOf(context, type, false);
  return Line(context, to.text + " = " + from.text);
}

// modf(x, p), the only function that writes an argument and does not round.
std::string MakeWriting(Context& context) {
  const Shape shape{0, context.Between(1, 4)};
  const Place to = MakePlaceOf(context, {Kind::kFloat, shape}, true);
  const Place rest = MakePlaceOf(context, {Kind::kFloat, shape}, true);
  if (!to.found || !rest.found || to.text == rest.text) return MakeCompound(context);
  const Expr value = MakeValue(context, {Kind::kFloat, shape}, kDepth);
  return Line(context, to.text + " = modf(" + Argument(value) + ", " + rest.text + ")");
}

std::string MakeStatement(Context& context, int depth) {
  const SpanOf span(context.choices);
  context.EndExpression();
  context.cost += context.iterations;
  const bool nests = depth > 0 && context.cost < kMostCost / 2;
  const bool loops =
      nests && context.Has(Feature::kLoops) && context.iterations * 4 <= kMostIterations;
  const std::uint32_t nest = nests ? 2 : 0, loop = loops ? 2 : 0;
  const bool may_jump = nests && context.scopes.size() > 2;
  switch (context.Pick(
      {6, 6, 4, nest, loop, loop / 2, nest / 2, 2, may_jump ? 1u : 0u, nest / 2, 2, 1, 1})) {
    case 0: return MakeAssignment(context);
    case 1: return MakeDeclaration(context);
    case 2: return MakeCompound(context);
    case 3: return MakeIf(context, depth);
    case 4: return MakeFor(context, depth);
    case 5: return MakeWhile(context, depth);
    case 6: return MakeSwitch(context, depth);
    case 7: {
      const std::string call = MakeVoidCall(context, kDepth);
      return call.empty() ? MakeAssignment(context) : Line(context, call);
    }
    case 8: return MakeJump(context);
    case 9: return Indent(context) + MakeBody(context, depth) + "\n";
    case 10: return MakeIncrement(context);
    case 11: return MakeCopy(context);
    default: return MakeWriting(context);
  }
}

}  // namespace

std::string MakeStatements(Context& context, int most, int depth) {
  std::string text;
  Repeat(context.choices, most, 80, [&](int) { text += MakeStatement(context, depth); });
  return text;
}

}  // namespace clipc::random
