// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Types, initial values, static variables and functions.
#include <algorithm>

#include "tools/random/statement.h"

namespace clipc::random {
namespace {

constexpr int kMostComponents = 64;

// The components of a value one after another, as HLSL's lists in braces take them: a vector may
// stand for its components.
std::string Components(Context& context, const Type& type, int depth) {
  if (type.IsNumeric()) {
    const bool is_whole = !type.shape.IsMatrix() && context.Chance(50);
    if (is_whole) return Argument(MakeValue(context, type, depth));
    std::string text;
    for (int i = 0; i < type.shape.Components(); ++i) {
      text += (i > 0 ? ", " : "") +
              Argument(MakeValue(context, {type.kind, kScalar}, std::min(depth, 1)));
    }
    return text;
  }
  const bool braces = context.Chance(40);
  std::string text = braces ? "{" : "";
  const auto add = [&](const Type& part) {
    text += (text.empty() || text == "{" ? "" : ", ") + Components(context, part, depth);
  };
  if (type.IsArray()) {
    for (int i = 0; i < type.sizes[0]; ++i) add(type.Element());
  } else {
    for (const Field& field : context.structs[type.structure].fields) add(field.type);
  }
  return text + (braces ? "}" : "");
}

std::string MakeBodyOf(Context& context, const Function& function) {
  std::string text;
  for (const Parameter& parameter : function.parameters) {
    if (parameter.direction != Direction::kOut) continue;
    const Type& type = parameter.type;
    context.EndExpression();
    text +=
        "  " + parameter.name + " = " +
        (type.IsNumeric() ? Argument(MakeValue(context, type, 2)) : Zero(context.structs, type)) +
        ";\n";
  }
  for (const Parameter& parameter : function.parameters) {
    if (parameter.direction == Direction::kOut) context.Add({parameter.name, parameter.type});
  }
  text += MakeStatements(context, 4, 2);
  context.EndExpression();
  if (function.is_void) return text;
  const Type& type = function.result;
  const std::string value =
      type.IsNumeric() ? MakeValue(context, type, 3).text : MakeReadOf(context, type);
  return text + "  return " + value + ";\n";
}

// A type that a parameter or a result may have.
Type MakePassedType(Context& context) {
  if (!context.structs.empty() && context.Chance(20)) {
    Type type;
    type.structure = static_cast<int>(context.Below(context.structs.size()));
    return type;
  }
  return {context.OneOf(kKinds), MakeShape(context)};
}

}  // namespace

Shape MakeShape(Context& context) {
  if (!context.Has(Feature::kMatrices) || context.Pick({3, 1}) == 0)
    return {0, context.Between(1, 4)};
  return {context.Between(1, 4), context.Between(1, 4)};
}

Type MakeType(Context& context) {
  Type type{static_cast<Kind>(context.Pick({4, 3, 2, 1})), MakeShape(context)};
  if (!context.structs.empty() && context.Chance(20))
    type.structure = static_cast<int>(context.Below(context.structs.size()));
  const std::size_t dimensions = context.Pick({6, 2, 1});
  for (std::size_t i = 0; i < dimensions; ++i) type.sizes.push_back(context.Between(1, 4));
  if (type.sizes.size() > 1 && type.shape.IsMatrix() && !context.Has(Feature::kMatrixGrids))
    type.sizes.pop_back();
  while (ComponentsOf(context.structs, type) > kMostComponents) {
    if (type.IsArray()) {
      type.sizes.erase(type.sizes.begin());
    } else {
      type.structure = -1;
    }
  }
  return type;
}

std::string MakeInitial(Context& context, const Type& type, int depth) {
  if (type.IsNumeric() && !context.Chance(20)) {
    return Argument(MakeValue(context, type, depth));
  }
  if (!type.IsNumeric() && !context.only_literals) {
    if (context.Pick({1, 1}) == 1) {
      const Place place = MakePlaceOf(context, type, false);
      if (place.found) return place.text;
    }
    if (type.IsStruct() && HasCall(context, type) && context.Chance(40))
      return MakeCall(context, type, depth);
    if (type.IsStruct() && context.Chance(40)) return Zero(context.structs, type);
  }
  std::string text = Components(context, type, std::min(depth, 2));
  return text.starts_with('{') && text.find('}') == text.size() - 1 ? text : "{" + text + "}";
}

std::string MakeStatic(Context& context) {
  const SpanOf span(context.choices);
  const Type type = MakeType(context);
  const bool is_const = context.Chance(30);
  const std::string name = context.FreshName("s");
  const Temporarily literals(context.only_literals, !context.Has(Feature::kConstantFunctions));
  const std::string value = MakeInitial(context, type, is_const ? 1 : 2);
  context.Add({name, type, !is_const});
  return std::string("static ") + (is_const ? "const " : "") +
         Declaration(context.structs, type, name) + " = " + value + ";\n";
}

std::string MakeFunction(Context& context) {
  const SpanOf span(context.choices);
  Function function;
  function.name = "f" + std::to_string(context.names++);
  function.is_void = context.Chance(25);
  if (!function.is_void) function.result = MakePassedType(context);
  const ScopeOf scope(context);
  std::string head;
  Repeat(context.choices, 3, 60, [&](int) {
    Parameter parameter{context.FreshName("p"), MakePassedType(context)};
    constexpr const char* kDirections[] = {"", "out ", "inout "};
    parameter.direction = static_cast<Direction>(context.Pick({3, context.effects ? 1u : 0u, 1}));
    const auto direction = static_cast<std::size_t>(parameter.direction);
    function.writes |= parameter.direction != Direction::kIn;
    const char* spelled = parameter.direction == Direction::kIn && context.Chance(20)
                              ? "in "
                              : kDirections[direction];
    head += (head.empty() ? "" : ", ") + std::string(spelled) +
            Declaration(context.structs, parameter.type, parameter.name);
    if (parameter.direction != Direction::kOut) context.Add({parameter.name, parameter.type});
    function.parameters.push_back(parameter);
  });
  const Temporarily outer_cost(context.cost, 0);
  const Temporarily quiet(context.writes_globals, false);
  const Temporarily here(context.function, static_cast<const Function*>(&function));
  const std::string body = MakeBodyOf(context, function);
  function.writes |= context.writes_globals;
  function.writes_statics = context.writes_globals;
  function.cost = context.cost + 1;
  context.functions.push_back(function);
  return (function.is_void ? "void" : NameOf(context.structs, function.result)) + " " +
         function.name + "(" + head + ") {\n" + body + "}\n";
}

}  // namespace clipc::random
