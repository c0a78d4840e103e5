// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Functions that round. Each is called where it is far from what it cannot do (poles, the ends of
// its domain) and where its slope is at most about 30, on exact arguments; results are multiplied
// by small constants, and their sizes are added. So the errors that Vulkan allows these functions
// stay about as large, and one tolerance (kSoftUlps) holds for all programs.
#include "tools/random/expr.h"

namespace clipc::random {
namespace {

std::string Float(Context& context, int columns, const Range& range, int depth) {
  return Argument(MakeIn(context, Kind::kFloat, {0, columns}, range, depth));
}

std::string Positive(Context& context, int columns, int depth) {
  return "abs(" + Float(context, columns, {-16, 16, 2}, depth) + ") + 0.5";
}

std::string MakeFunction(Context& context, int columns, int depth) {
  const auto in = [&](double low, double high) {
    return Float(context, columns, {low, high, 4}, depth);
  };
  const auto positive = [&] { return Positive(context, columns, depth); };
  constexpr const char* kAny[] = {"sin", "cos", "atan", "tanh", "radians"};
  constexpr const char* kOfSmall[] = {"exp", "exp2", "sinh", "cosh"};
  constexpr const char* kOfPositive[] = {"sqrt", "rsqrt", "log", "log2", "log10", "rcp"};
  switch (context.Pick({4, 3, 4, 2, 2, 2, 1, 2})) {
    case 0: return std::string(context.OneOf(kAny)) + "(" + in(-8, 8) + ")";
    case 1: return std::string(context.OneOf(kOfSmall)) + "(" + in(-3, 3) + ")";
    case 2: {
      std::string name = context.OneOf(kOfPositive);
      if (context.Chance(10)) name = "sqrt";
      return name + "(" + positive() + ")";
    }
    case 3: return "pow(" + positive() + ", " + in(-2, 2) + ")";
    case 4: return "(" + in(-16, 16) + ") / (" + positive() + ")";
    case 5: return "atan2(" + in(-8, 8) + ", " + positive() + ")";
    case 6: {
      const char* name = context.Chance(50) ? "asin" : "acos";
      return std::string(name) + "(" + in(-16, 16) + " * 0.046875)";
    }
    default: {
      const std::string vector = "float3(" + Float(context, 2, {-8, 8, 2}, depth) + ", 1.5)";
      const char* name = context.Chance(60) ? "normalize" : "length";
      const std::string call = std::string(name) + "(" + vector + ")";
      if (name[0] == 'l')
        return columns == 1 ? call : "(float" + std::to_string(columns) + ")" + call;
      return call + std::string(".xyzx").substr(0, 1 + static_cast<std::size_t>(columns));
    }
  }
}

}  // namespace

std::string MakeSoft(Context& context, int columns, int depth) {
  const SpanOf span(context.choices);
  std::string text = MakeFunction(context, columns, depth);
  if (context.Chance(Feature::kPowerOfZero, 10)) {
    text = "pow(abs(" + Float(context, columns, {-4, 4, 0}, depth) + "), " +
           Float(context, columns, {-2, 2, 0}, depth) + ")";
  }
  if (context.Chance(40)) text += " * " + Literal(Kind::kFloat, 0.5).text;
  // The sum does not cancel: its error is compared with its size.
  if (context.Chance(40))
    text = "abs(" + text + ") + abs(" + MakeFunction(context, columns, depth) + ")";
  return text;
}

}  // namespace clipc::random
