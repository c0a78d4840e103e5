// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Functions and methods that a pixel shader may call and a vertex shader may not. clipc looks only
// for the inputs that a pixel shader reads, so a call becomes its arguments and a zero of its type.
#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "frontend/rules/intrinsic_call.h"

namespace clipc::rules {
namespace {

enum class Result : std::uint8_t {
  kFirst,       // the type of the first argument
  kFloatFirst,  // the type of the first argument, in float
  kVoid,        // an int that nobody uses
  kBool,
  kUint,
  kUint4,
  kFloat,
  kFloat2,
  kFloat4,
};
using enum Result;
struct Row {
  std::string_view prefix;  // the prefix of the names
  Result result;
};
// The results of functions and methods by the prefix of their names. The first row that fits
// counts.
constexpr auto kRows = std::to_array<Row>({
    {"ddx", kFloatFirst},
    {"ddy", kFloatFirst},
    {"fwidth", kFloatFirst},
    {"clip", kVoid},
    {"tex", kFloat4},
    {"SubpassLoad", kFloat4},
    {"CalculateLevelOfDetail", kFloat},
    {"SampleCmp", kFloat},
    {"GatherCmp", kFloat4},
    {"GetSamplePosition", kFloat2},
    {"EvaluateAttribute", kFirst},
    {"GetAttributeAtVertex", kFirst},
    {"GetRenderTargetSampleCount", kUint},
    {"GetRenderTargetSamplePosition", kFloat2},
    {"IsHelperLane", kBool},
    {"CheckAccessFullyMapped", kBool},
    {"Interlocked", kVoid},
    {"DeviceMemoryBarrier", kVoid},
    {"AllMemoryBarrier", kVoid},
    {"WaveActiveAll", kBool},
    {"WaveActiveAny", kBool},
    {"WaveIsFirstLane", kBool},
    {"WaveActiveBallot", kUint4},
    {"WaveActiveCountBits", kUint},
    {"WavePrefixCountBits", kUint},
    {"WaveGetLane", kUint},
    {"Wave", kFirst},
    {"Quad", kFirst},
});

TypeId TypeOf(const IntrinsicCheck& call, Result result) {
  TypeTable& types = call.program.types;
  switch (result) {
    case kFirst:
    case kFloatFirst: {
      if (call.arguments.empty()) return types.Error();
      const TypeId first = call.ArgumentTypeId(0);
      const bool is_float = IsFloat(types[first].scalar);
      return result == kFirst || is_float ? first : types.WithScalar(first, Scalar::kFloat);
    }
    case kVoid: return types.Make(Scalar::kInt);
    case kBool: return types.Make(Scalar::kBool);
    case kUint: return types.Make(Scalar::kUint);
    case kUint4: return types.Vector(Scalar::kUint, 4);
    case kFloat: return types.Make(Scalar::kFloat);
    case kFloat2: return types.Vector(Scalar::kFloat, 2);
    case kFloat4: return types.Vector(Scalar::kFloat, 4);
  }
  return types.Error();
}

}  // namespace

ExprId CheckPixelCall(const IntrinsicCheck& call) {
  if (!call.program.profile.IsPixel()) return {};
  const std::span rows(kRows);  // an array's iterators are pointers in some libraries only
  const auto row = std::ranges::find_if(
      rows, [&](const Row& each) { return call.name.starts_with(each.prefix); });
  if (row == rows.end()) return {};
  std::vector<ExprId> values;
  for (const ExprId argument : call.arguments) {
    if (call.TypeOf(argument).IsNumeric()) values.push_back(argument);
  }
  return After(call, values, call.Make().ZeroOf(TypeOf(call, row->result)));
}

}  // namespace clipc::rules
