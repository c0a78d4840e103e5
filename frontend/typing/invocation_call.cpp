// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Functions without arguments that are facts about the invocation, and become inputs of the shader;
// and the places of samples in a pixel.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "frontend/typing/object_call.h"

namespace clipc::typing {
namespace {

constexpr struct {
  std::string_view name;
  Builtin builtin;
  int major;  // the first shader model
  bool is_of_pixel;
} kFacts[] = {
    {"GetRenderTargetSampleCount", Builtin::kSampleCount, 4, true},
    {"IsHelperLane", Builtin::kHelperLane, 6, true},
    {"WaveGetLaneCount", Builtin::kLaneCount, 6, false},
    {"WaveGetLaneIndex", Builtin::kLaneIndex, 6, false},
};

// The input that has the value; its name is that of the function.
ExprId InputOf(const IntrinsicCheck& call, Builtin builtin, std::string_view name) {
  IoVars& inputs = call.program.inputs;
  const auto known = std::ranges::find(inputs, builtin, &IoVar::builtin);
  if (known != inputs.end()) return call.Make().Ref(known->var);
  const VarId var = call.program.vars.Add({.name = std::string(name),
                                           .type = call.program.types.Make(InfoOf(builtin).scalar),
                                           .storage = Storage::kInput,
                                           .span = call.name_span});
  inputs.push_back({.var = var, .semantic = std::string(name), .builtin = builtin});
  return call.Make().Ref(var);
}

// Places of the samples of 1, 2, 4, 8 and 16, in sixteenths of a pixel from its centre:
// D3D11_STANDARD_MULTISAMPLE_PATTERN, "Rasterization Rules" of the Direct3D 11 reference.
constexpr std::array<std::int8_t, 2> kPlaces[] = {
    {0, 0},                                //
    {4, 4},   {-4, -4},                    //
    {-2, -6}, {6, -2},  {-6, 2},  {2, 6},  //
    {1, -3},  {-1, 3},  {5, 1},   {-3, -5}, {-5, 5},  {-7, -1}, {3, 7}, {7, -7},
    {1, 1},   {-1, -3}, {-3, 2},  {4, -1},  {-5, -2}, {2, 5},   {5, 3}, {3, -5},
    {-2, 6},  {0, -7},  {-4, -6}, {-6, 4},  {-8, 0},  {7, -4},  {6, 7}, {-7, -8}};
constexpr std::uint32_t kMostSamples = 16;

// The constant array of all places. It has no span, unlike a user's variable of that name.
VarId PlacesIn(Program& program) {
  constexpr std::string_view kName = "sample_positions";
  for (const VarId global : program.globals) {
    if (program.vars[global].name == kName && !program.vars[global].span) return global;
  }
  Builder builder(program);
  const TypeId pair = program.types.Vector(Scalar::kFloat, 2);
  const TypeId type = program.types.Array(pair, std::size(kPlaces));
  std::vector<ExprId> places;
  for (const auto& [x, y] : kPlaces)
    places.push_back(builder.ConstructOf(pair, {builder.Float(static_cast<float>(x) / 16),
                                                builder.Float(static_cast<float>(y) / 16)}));
  const VarId var = program.vars.Add({.name = std::string(kName),
                                      .type = type,
                                      .storage = Storage::kConstant,
                                      .init = builder.ConstructOf(type, places)});
  program.globals.push_back(var);
  return var;
}

}  // namespace

ExprId CheckFact(const IntrinsicCheck& call) {
  const auto& fact =
      *std::ranges::find(kFacts, call.name, [](const auto& row) { return row.name; });
  const StageInfo& stage = call.ThisStage();
  if (fact.is_of_pixel && !stage.draws_pixels)
    return call.Fail(call.name_span, diag::IntrinsicRenderTarget, call.name, stage.name);
  if (!call.HasCount(0, 0)) return call.Error();
  Program& program = call.program;
  if (program.is_interface_only)
    return call.Make().ZeroOf(program.types.Make(InfoOf(fact.builtin).scalar));
  if (!program.profile.IsAtLeast(fact.major, 0))
    return call.Fail(call.name_span, diag::IntrinsicProfile, call.name,
                     fmt::format("{}_{}_0", stage.prefix, fact.major), program.profile.name);
  return InputOf(call, fact.builtin, fact.name);
}

// Checks WaveIsFirstLane(): the first active lane is the one that WaveReadLaneFirst reads.
ExprId CheckFirstLane(const IntrinsicCheck& call) {
  IntrinsicCheck index = call;
  index.name = "WaveGetLaneIndex";
  const ExprId own = CheckFact(index);
  if (call.TypeOf(own).kind == TypeKind::kError) return own;
  const Builder builder = call.Make();
  const ExprId first = Builder(builder).IntrinsicOf(CommonIntrinsic::kWaveReadLaneFirst,
                                                    call.TypeIdOf(own), {Clone(call.program, own)});
  return Builder(builder).BinaryOf(BinaryOp::kEqual, own, first);
}

ExprId CheckSamplePosition(const IntrinsicCheck& call, ExprId count) {
  Program& program = call.program;
  const TypeId integer = program.types.Make(Scalar::kUint);
  const TypeId pair = program.types.Vector(Scalar::kFloat, 2);
  if (!call.HasCount(1, 1)) return call.Error();
  const auto given = call.Converted(0, integer);
  if (!given) return call.Error();
  if (program.is_interface_only) return After(call, {&*given, 1}, call.Make().ZeroOf(pair));
  Builder builder = call.Make();
  const auto samples = call.temporaries.Make(count);
  const auto sample = call.temporaries.Make(*given);
  const auto limited = [&](ExprId value, BinaryOp op, ExprId limit) {
    return builder.BinaryOf(op, value, limit);
  };
  const ExprId exists = builder.BinaryOf(
      BinaryOp::kLogicalAnd,
      limited(builder.Ref(sample.var), BinaryOp::kLess, builder.Ref(samples.var)),
      limited(builder.Ref(samples.var), BinaryOp::kLessEqual, builder.Uint(kMostSamples)));
  const ExprId place = builder.BinaryOf(
      BinaryOp::kAdd, builder.BinaryOf(BinaryOp::kSub, builder.Ref(samples.var), builder.Uint(1)),
      builder.Ref(sample.var));
  const ExprId position = builder.At(builder.Ref(PlacesIn(program)), place);
  const ExprId steps[] = {samples.prologue, sample.prologue};
  return After(call, steps, builder.Add(pair, Conditional{exists, position, builder.ZeroOf(pair)}));
}

ExprId CheckTargetSamplePosition(const IntrinsicCheck& call) {
  IntrinsicCheck count = call;
  count.name = "GetRenderTargetSampleCount";
  count.arguments = {};
  const ExprId samples = CheckFact(count);
  if (call.TypeOf(samples).kind == TypeKind::kError) return samples;
  return CheckSamplePosition(call, samples);
}

}  // namespace clipc::typing
