// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Calls of the program's own functions.

#include "tools/random/expr.h"

namespace clipc::random {
namespace {

bool MayCall(const Context& context, const Function& function) {
  return (context.effects || !function.writes) && context.MayUseStatics(function.writes_statics) &&
         context.iterations * function.cost + context.cost <= kMostCost;
}

// The text of an argument; empty where there is none.
std::string MakeArgument(Context& context, const Parameter& parameter, int depth) {
  const Type& type = parameter.type;
  if (parameter.direction != Direction::kIn) {
    const Place place = MakePlaceOf(context, type, true);
    if (place.found) context.taken.push_back(place.text.substr(0, place.text.find_first_of(".[")));
    return place.text;
  }
  if (type.IsNumeric()) return Argument(MakeValue(context, type, depth));
  return MakeReadOf(context, type);
}

// The call, or nothing where an argument cannot be made.
std::string MakeCallOf(Context& context, const Function& function, int depth) {
  const std::size_t taken = context.taken.size();
  context.UseStatics(function.writes_statics);
  std::string text = function.name + "(";
  bool is_complete = true;
  // Outputs are made first, so that no inner call writes the same variables.
  std::vector<std::string> arguments(function.parameters.size());
  for (const bool outputs : {true, false}) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const Parameter& parameter = function.parameters[i];
      if ((parameter.direction != Direction::kIn) != outputs) continue;
      arguments[i] = MakeArgument(context, parameter, depth - 1);
      is_complete &= !arguments[i].empty();
    }
  }
  context.taken.resize(taken);
  if (!is_complete) return {};
  for (std::size_t i = 0; i < arguments.size(); ++i) text += (i > 0 ? ", " : "") + arguments[i];
  context.cost += context.iterations * function.cost;
  return text + ")";
}

std::vector<const Function*> Candidates(const Context& context, const Type& result, bool is_void) {
  std::vector<const Function*> found;
  for (const Function& function : context.functions) {
    if (function.is_void == is_void && (is_void || function.result == result) &&
        MayCall(context, function))
      found.push_back(&function);
  }
  return found;
}

}  // namespace

bool HasCall(const Context& context, const Type& result) {
  return !Candidates(context, result, false).empty();
}

std::string MakeCall(Context& context, const Type& result, int depth) {
  const std::vector<const Function*> found = Candidates(context, result, false);
  if (found.empty()) return {};
  const Function& function = *context.OneOf(found);
  std::string call = MakeCallOf(context, function, depth);
  if (function.writes) context.writes_globals = true;
  if (!call.empty()) return call;
  return Zero(context.structs, result);
}

std::string MakeVoidCall(Context& context, int depth) {
  const std::vector<const Function*> found = Candidates(context, {}, true);
  if (found.empty()) return {};
  const Function& function = *context.OneOf(found);
  if (function.writes) context.writes_globals = true;
  return MakeCallOf(context, function, depth);
}

}  // namespace clipc::random
