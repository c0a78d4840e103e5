// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/objects.h"

#include <algorithm>
#include <vector>

#include "base/spelling.h"
#include "frontend/typing/method_check.h"
#include "ir/access.h"

namespace clipc::typing {
namespace {

// The property that an object must have for a method to exist.
enum class Needs : std::uint8_t {
  kNothing,
  kSampling,
  kComparison,
  kGathering,
  kTexels,  // a cube texture does not have texels to load
  kReading,
  kWriting,
  kAppending,
  kConsuming,
  kCounting,
  kElements,  // an append or consume buffer does not let them be named
};
using enum Needs;

bool Offers(ObjectKind kind, Needs needs) {
  const TextureTraits traits = TraitsOf(kind);
  switch (needs) {
    case kNothing: return true;
    case kSampling: return traits.coordinates != 0;
    // Microsoft's pages list no Texture3D under SampleCmp and SampleCmpLevelZero.
    case kComparison: return traits.gradient != 0 && InfoOf(kind).axes <= 2;
    case kGathering: return traits.can_gather;
    case kTexels: return traits.texel != 0;
    case kReading: return !IsWritable(kind);
    case kWriting: return IsWritable(kind);
    case kAppending: return kind == ObjectKind::kAppendStructuredBuffer;
    case kConsuming: return kind == ObjectKind::kConsumeStructuredBuffer;
    case kCounting: return IsStructured(kind) && IsWritable(kind) && HasNamedElements(kind);
    case kElements: return HasNamedElements(kind);
  }
  return false;
}

using Check = ExprId (MethodCheck::*)();

struct Method {
  std::string_view name;
  Needs needs;
  Check check;
  int model = 10;  // the first shader model that has it, 41 for 4.1
  Staged staged = {};
};

// "Minimum Shader Model" of the methods' pages in Microsoft's HLSL reference, and the model of the
// instructions gather4, lod and samplepos, sm4.1, and gather4_c, sm5. fxc makes the samples that
// have 10 instructions of Direct3D 9.

constexpr Method kTextureMethods[] = {
    {"SampleLevel", kSampling, &MethodCheck::SampleBy<ObjectOp::kSampleLevel>},
    {"SampleGrad", kSampling, &MethodCheck::SampleBy<ObjectOp::kSampleGrad>},
    {"Sample", kSampling, &MethodCheck::Sample},
    {"SampleBias", kSampling, &MethodCheck::SampleBias},
    {"SampleCmp", kComparison, &MethodCheck::SampleCmp, 40},
    {"SampleCmpLevelZero", kComparison, &MethodCheck::SampleBy<ObjectOp::kSampleCmpLevelZero>, 40},
    {"Gather", kGathering, &MethodCheck::Gather<ObjectOp::kGather>, 41},
    {"GatherRed", kGathering, &MethodCheck::Gather<ObjectOp::kGather>, 41},
    {"GatherGreen", kGathering, &MethodCheck::Gather<ObjectOp::kGatherGreen>, 50},
    {"GatherBlue", kGathering, &MethodCheck::Gather<ObjectOp::kGatherBlue>, 50},
    {"GatherAlpha", kGathering, &MethodCheck::Gather<ObjectOp::kGatherAlpha>, 50},
    {"Load", kTexels, &MethodCheck::TextureLoad, 40},
    {"GetDimensions", kNothing, &MethodCheck::GetDimensions, 40},
    {"SampleCmpBias", kComparison, &MethodCheck::SampleCmpBias},
    {"SampleCmpGrad", kComparison, &MethodCheck::SampleCmpGrad},
    {"SampleCmpLevel", kComparison, &MethodCheck::SampleCmpLevel},
    {"GatherCmp", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"GatherCmpRed", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"GatherCmpGreen", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"GatherCmpBlue", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"GatherCmpAlpha", kGathering, &MethodCheck::Gather<ObjectOp::kGatherCmp>, 50},
    {"CalculateLevelOfDetail", kSampling, &MethodCheck::LevelOfDetail<ObjectOp::kLevelOfDetail>,
     41},
    {"CalculateLevelOfDetailUnclamped", kSampling,
     &MethodCheck::LevelOfDetail<ObjectOp::kLevelOfDetailUnclamped>, 41},
    {"GetSamplePosition", kReading, &MethodCheck::SamplePosition, 41},
    {"GatherRaw", kReading, &MethodCheck::Unsupported},
};

// The methods of typed and structured buffers.
constexpr Method kBufferMethods[] = {
    {"Load", kElements, &MethodCheck::BufferLoad},
    {"GetDimensions", kNothing, &MethodCheck::GetDimensions},
    {"Append", kAppending, &MethodCheck::Counter},
    {"Consume", kConsuming, &MethodCheck::Counter},
    {"IncrementCounter", kCounting, &MethodCheck::Counter},
    {"DecrementCounter", kCounting, &MethodCheck::Counter},
};

constexpr Method kByteMethods[] = {
    {"Load", kNothing, &MethodCheck::ByteLoad<1>},
    {"Load2", kNothing, &MethodCheck::ByteLoad<2>},
    {"Load3", kNothing, &MethodCheck::ByteLoad<3>},
    {"Load4", kNothing, &MethodCheck::ByteLoad<4>},
    {"GetDimensions", kNothing, &MethodCheck::GetDimensions},
    {"Store", kWriting, &MethodCheck::ByteStore<1>},
    {"Store2", kWriting, &MethodCheck::ByteStore<2>},
    {"Store3", kWriting, &MethodCheck::ByteStore<3>},
    {"Store4", kWriting, &MethodCheck::ByteStore<4>},
    {"InterlockedAdd", kWriting, &MethodCheck::Atomic},
    {"InterlockedAnd", kWriting, &MethodCheck::Atomic},
    {"InterlockedCompareExchange", kWriting, &MethodCheck::Atomic},
    {"InterlockedCompareExchangeFloatBitwise", kWriting, &MethodCheck::Atomic},
    {"InterlockedCompareStore", kWriting, &MethodCheck::Atomic},
    {"InterlockedCompareStoreFloatBitwise", kWriting, &MethodCheck::Atomic},
    {"InterlockedExchange", kWriting, &MethodCheck::Atomic},
    {"InterlockedExchangeFloat", kWriting, &MethodCheck::Atomic},
    {"InterlockedMax", kWriting, &MethodCheck::Atomic},
    {"InterlockedMin", kWriting, &MethodCheck::Atomic},
    {"InterlockedOr", kWriting, &MethodCheck::Atomic},
    {"InterlockedXor", kWriting, &MethodCheck::Atomic},
};

constexpr Method kStreamMethods[] = {{"Append", kNothing, &MethodCheck::Append},
                                     {"RestartStrip", kNothing, &MethodCheck::RestartStrip}};

constexpr Method kSubpassMethods[] = {{"SubpassLoad", kNothing, &MethodCheck::SubpassLoad}};

std::span<const Method> MethodsOf(ObjectKind kind) {
  switch (InfoOf(kind).category) {
    case ObjectCategory::kTexture: return kTextureMethods;
    case ObjectCategory::kTypedBuffer:
    case ObjectCategory::kStructuredBuffer: return kBufferMethods;
    case ObjectCategory::kByteAddressBuffer: return kByteMethods;
    case ObjectCategory::kSubpass: return kSubpassMethods;
    case ObjectCategory::kStream: return kStreamMethods;
    default: return {};
  }
}

}  // namespace

TextureTraits TraitsOf(ObjectKind kind) {
  const ObjectInfo& info = InfoOf(kind);
  if (info.category != ObjectCategory::kTexture) return {};
  const bool is_sampled = !info.is_writable && !info.is_multisampled;
  const int layers = info.is_array;
  const int direction = info.is_cube ? 3 : info.axes;
  return {.coordinates = is_sampled ? direction + layers : 0,
          .texel = info.is_cube ? 0 : info.axes + layers,
          .size = info.axes + layers,
          .offset = info.is_cube || info.is_writable ? 0 : info.axes,
          .gradient = is_sampled ? direction : 0,
          .is_multisampled = info.is_multisampled,
          .can_gather = is_sampled && info.axes == 2};
}

TypeId ElementOf(TypeTable& types, const Type& object) {
  return object.element ? object.element : types.Vector(Scalar::kFloat, 4);
}

ExprId Moved(Builder builder, Program& program, ExprId location, ExprId offset) {
  const TypeId type = typing::TypeIdOf(program, location);
  if (TypeOf(program, offset).Components() < program.types[type].Components())
    offset = builder.ConstructOf(type, {offset, builder.Int(0)});
  return builder.BinaryOf(BinaryOp::kAdd, location, offset);
}

ExprId CheckMethodCall(const IntrinsicCheck& call, ExprId object) {
  const Type type = call.TypeOf(object);
  if (type.kind == TypeKind::kError || call.HasErrorArgument()) return call.Error();
  if (type.kind != TypeKind::kObject) {
    return call.Fail(call.name_span, diag::MethodUnknown,
                     call.program.types.Name(call.TypeIdOf(object)), call.name, "");
  }
  const bool lacks = (IsOrdered(type.object) && !call.ThisStage().draws_pixels) ||
                     (IsStream(type.object) && !call.ThisStage().emits_vertices);
  if (lacks)
    return call.Fail(call.name_span, diag::ObjectUnusable, call.name, call.ThisStage().name);
  MethodCheck check(call, object, type.object);
  const std::span<const Method> methods = MethodsOf(type.object);
  const auto found = std::ranges::find_if(methods, [&](const Method& each) {
    return each.name == call.name && Offers(type.object, each.needs);
  });
  if (found == methods.end()) {
    std::vector<std::string_view> names;
    for (const Method& each : methods) {
      if (Offers(type.object, each.needs)) names.push_back(each.name);
    }
    return check.Unknown(NearNames(call.name, names));
  }
  if (!call.program.is_interface_only && !check.HasModel(found->model)) return call.Error();
  const ExprId value = StandInFor(call, found->staged);
  return value ? value : (check.*found->check)();
}

}  // namespace clipc::typing
