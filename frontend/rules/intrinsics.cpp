// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/intrinsics.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/spelling.h"
#include "base/word_index.h"
#include "frontend/rules/intrinsic_call.h"
#include "frontend/rules/reread.h"

namespace clipc {
namespace {

using ir::ExprId;

// What becomes of a call by name.
enum class Rule : std::uint8_t {
  kIr,  // an ir::Intrinsic
  kSelect,
  kAnd,
  kOr,
  kIdentity,  // a hint that GLSL's targets do not need
  kTexLod,
  // Refused, in families, each with its own message.
  kAbort,
  kAtomic,
  kBarrier,
  kDebug,
  kDerivative,
  kDiscard,
  kImplicitLevel,
  kInterpolation,
  kMesh,
  kNoise,
  kPacked,
  kRayTracing,
  kRenderTarget,
  kTessellation,
  kTiled,
  kUnsupported,
  kWave,
  kWorkGraph,
};
struct Entry {
  std::string_view name;
  Rule rule;
  std::uint8_t detail =
      0;  // kIr: the ir::Intrinsic; kTexLod, kImplicitLevel: the ir::ObjectKind of the sampler
};

constexpr Entry kIrEntries[] = {
#define INTRINSIC(Enumerator, HlslName, Signature) \
  {HlslName, Rule::kIr, static_cast<std::uint8_t>(ir::Intrinsic::k##Enumerator)},
#include "ir/intrinsics.def"
#undef INTRINSIC
};

constexpr std::uint8_t kS1D = static_cast<std::uint8_t>(ir::ObjectKind::kSampler1D);
constexpr std::uint8_t kS2D = static_cast<std::uint8_t>(ir::ObjectKind::kSampler2D);
constexpr std::uint8_t kS3D = static_cast<std::uint8_t>(ir::ObjectKind::kSampler3D);
constexpr std::uint8_t kSCube = static_cast<std::uint8_t>(ir::ObjectKind::kSamplerCube);

constexpr Entry kOtherEntries[] = {
    {"select", Rule::kSelect},
    {"and", Rule::kAnd},
    {"or", Rule::kOr},
    {"NonUniformResourceIndex", Rule::kIdentity},
    {"tex1Dlod", Rule::kTexLod, kS1D},
    {"tex2Dlod", Rule::kTexLod, kS2D},
    {"tex3Dlod", Rule::kTexLod, kS3D},
    {"texCUBElod", Rule::kTexLod, kSCube},
    {"tex1D", Rule::kImplicitLevel, kS1D},
    {"tex1Dbias", Rule::kImplicitLevel, kS1D},
    {"tex1Dgrad", Rule::kImplicitLevel, kS1D},
    {"tex1Dproj", Rule::kImplicitLevel, kS1D},
    {"tex2D", Rule::kImplicitLevel, kS2D},
    {"tex2Dbias", Rule::kImplicitLevel, kS2D},
    {"tex2Dgrad", Rule::kImplicitLevel, kS2D},
    {"tex2Dproj", Rule::kImplicitLevel, kS2D},
    {"tex3D", Rule::kImplicitLevel, kS3D},
    {"tex3Dbias", Rule::kImplicitLevel, kS3D},
    {"tex3Dgrad", Rule::kImplicitLevel, kS3D},
    {"tex3Dproj", Rule::kImplicitLevel, kS3D},
    {"texCUBE", Rule::kImplicitLevel, kSCube},
    {"texCUBEbias", Rule::kImplicitLevel, kSCube},
    {"texCUBEgrad", Rule::kImplicitLevel, kSCube},
    {"texCUBEproj", Rule::kImplicitLevel, kSCube},
    {"abort", Rule::kAbort},
    {"printf", Rule::kDebug},
    {"errorf", Rule::kDebug},
    {"source_mark", Rule::kDebug},
    {"noise", Rule::kNoise},
    {"clip", Rule::kDiscard},
    {"ddx", Rule::kDerivative},
    {"ddx_coarse", Rule::kDerivative},
    {"ddx_fine", Rule::kDerivative},
    {"ddy", Rule::kDerivative},
    {"ddy_coarse", Rule::kDerivative},
    {"ddy_fine", Rule::kDerivative},
    {"fwidth", Rule::kDerivative},
    {"EvaluateAttributeAtCentroid", Rule::kInterpolation},
    {"EvaluateAttributeAtSample", Rule::kInterpolation},
    {"EvaluateAttributeCentroid", Rule::kInterpolation},
    {"EvaluateAttributeSnapped", Rule::kInterpolation},
    {"GetAttributeAtVertex", Rule::kInterpolation},
    {"GetRenderTargetSampleCount", Rule::kRenderTarget},
    {"GetRenderTargetSamplePosition", Rule::kRenderTarget},
    {"IsHelperLane", Rule::kRenderTarget},
    {"AllMemoryBarrier", Rule::kBarrier},
    {"AllMemoryBarrierWithGroupSync", Rule::kBarrier},
    {"Barrier", Rule::kBarrier},
    {"DeviceMemoryBarrier", Rule::kBarrier},
    {"DeviceMemoryBarrierWithGroupSync", Rule::kBarrier},
    {"GroupMemoryBarrier", Rule::kBarrier},
    {"GroupMemoryBarrierWithGroupSync", Rule::kBarrier},
    {"InterlockedAdd", Rule::kAtomic},
    {"InterlockedAnd", Rule::kAtomic},
    {"InterlockedCompareExchange", Rule::kAtomic},
    {"InterlockedCompareExchangeFloatBitwise", Rule::kAtomic},
    {"InterlockedCompareStore", Rule::kAtomic},
    {"InterlockedCompareStoreFloatBitwise", Rule::kAtomic},
    {"InterlockedExchange", Rule::kAtomic},
    {"InterlockedMax", Rule::kAtomic},
    {"InterlockedMin", Rule::kAtomic},
    {"InterlockedOr", Rule::kAtomic},
    {"InterlockedXor", Rule::kAtomic},
    {"Process2DQuadTessFactorsAvg", Rule::kTessellation},
    {"Process2DQuadTessFactorsMax", Rule::kTessellation},
    {"Process2DQuadTessFactorsMin", Rule::kTessellation},
    {"ProcessIsolineTessFactors", Rule::kTessellation},
    {"ProcessQuadTessFactorsAvg", Rule::kTessellation},
    {"ProcessQuadTessFactorsMax", Rule::kTessellation},
    {"ProcessQuadTessFactorsMin", Rule::kTessellation},
    {"ProcessTriTessFactorsAvg", Rule::kTessellation},
    {"ProcessTriTessFactorsMax", Rule::kTessellation},
    {"ProcessTriTessFactorsMin", Rule::kTessellation},
    {"QuadAll", Rule::kWave},
    {"QuadAny", Rule::kWave},
    {"QuadReadAcrossDiagonal", Rule::kWave},
    {"QuadReadAcrossX", Rule::kWave},
    {"QuadReadAcrossY", Rule::kWave},
    {"QuadReadLaneAt", Rule::kWave},
    {"WaveActiveAllEqual", Rule::kWave},
    {"WaveActiveAllTrue", Rule::kWave},
    {"WaveActiveAnyTrue", Rule::kWave},
    {"WaveActiveBallot", Rule::kWave},
    {"WaveActiveBitAnd", Rule::kWave},
    {"WaveActiveBitOr", Rule::kWave},
    {"WaveActiveBitXor", Rule::kWave},
    {"WaveActiveCountBits", Rule::kWave},
    {"WaveActiveMax", Rule::kWave},
    {"WaveActiveMin", Rule::kWave},
    {"WaveActiveProduct", Rule::kWave},
    {"WaveActiveSum", Rule::kWave},
    {"WaveGetLaneCount", Rule::kWave},
    {"WaveGetLaneIndex", Rule::kWave},
    {"WaveIsFirstLane", Rule::kWave},
    {"WaveMatch", Rule::kWave},
    {"WaveMultiPrefixBitAnd", Rule::kWave},
    {"WaveMultiPrefixBitOr", Rule::kWave},
    {"WaveMultiPrefixBitXor", Rule::kWave},
    {"WaveMultiPrefixCountBits", Rule::kWave},
    {"WaveMultiPrefixProduct", Rule::kWave},
    {"WaveMultiPrefixSum", Rule::kWave},
    {"WavePrefixCountBits", Rule::kWave},
    {"WavePrefixProduct", Rule::kWave},
    {"WavePrefixSum", Rule::kWave},
    {"WaveReadLaneAt", Rule::kWave},
    {"WaveReadLaneFirst", Rule::kWave},
    {"AcceptHitAndEndSearch", Rule::kRayTracing},
    {"CallShader", Rule::kRayTracing},
    {"DispatchRaysDimensions", Rule::kRayTracing},
    {"DispatchRaysIndex", Rule::kRayTracing},
    {"IgnoreHit", Rule::kRayTracing},
    {"ReportHit", Rule::kRayTracing},
    {"TraceRay", Rule::kRayTracing},
    {"DispatchMesh", Rule::kMesh},
    {"SetMeshOutputCounts", Rule::kMesh},
    {"GetRemainingRecursionLevels", Rule::kWorkGraph},
    {"dot2add", Rule::kPacked},
    {"dot4add_i8packed", Rule::kPacked},
    {"dot4add_u8packed", Rule::kPacked},
    {"msad4", Rule::kPacked},
    {"pack_clamp_s8", Rule::kPacked},
    {"pack_clamp_u8", Rule::kPacked},
    {"pack_s8", Rule::kPacked},
    {"pack_u8", Rule::kPacked},
    {"unpack_s8s16", Rule::kPacked},
    {"unpack_s8s32", Rule::kPacked},
    {"unpack_u8u16", Rule::kPacked},
    {"unpack_u8u32", Rule::kPacked},
    {"CheckAccessFullyMapped", Rule::kTiled},
    {"AddUint64", Rule::kUnsupported},
    {"asfloat16", Rule::kUnsupported},
    {"asint16", Rule::kUnsupported},
    {"asuint16", Rule::kUnsupported},
    {"isnormal", Rule::kUnsupported},
};

// All, in the order of their names.
constexpr auto kEntries = [] {
  std::array<Entry, std::size(kIrEntries) + std::size(kOtherEntries)> entries{};
  std::copy(std::begin(kIrEntries), std::end(kIrEntries), entries.begin());
  std::copy(std::begin(kOtherEntries), std::end(kOtherEntries),
            entries.begin() + std::size(kIrEntries));
  std::sort(entries.begin(), entries.end(),
            [](const Entry& a, const Entry& b) { return a.name < b.name; });
  return entries;
}();

constexpr WordIndex kEntryIndex = [] {
  std::array<std::string_view, kEntries.size()> names;
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kEntries[i].name;
  return WordIndex(names);
}();

const Entry* FindEntry(std::string_view name) {
  const std::size_t i = kEntryIndex.Find(name);
  return i != kEntryIndex.kNone ? &kEntries[i] : nullptr;
}

const diag::Kind<std::string_view>& RefusalOf(Rule rule) {
  switch (rule) {
    case Rule::kAbort: return diag::IntrinsicAbort;
    case Rule::kAtomic: return diag::IntrinsicAtomic;
    case Rule::kBarrier: return diag::IntrinsicBarrier;
    case Rule::kDebug: return diag::IntrinsicDebug;
    case Rule::kDerivative: return diag::IntrinsicDerivative;
    case Rule::kDiscard: return diag::IntrinsicDiscard;
    case Rule::kInterpolation: return diag::IntrinsicInterpolation;
    case Rule::kMesh: return diag::IntrinsicMesh;
    case Rule::kNoise: return diag::IntrinsicNoise;
    case Rule::kPacked: return diag::IntrinsicPacked;
    case Rule::kRayTracing: return diag::IntrinsicRayTracing;
    case Rule::kRenderTarget: return diag::IntrinsicRenderTarget;
    case Rule::kTessellation: return diag::IntrinsicTessellation;
    case Rule::kTiled: return diag::IntrinsicTiled;
    case Rule::kWave: return diag::IntrinsicWave;
    case Rule::kWorkGraph: return diag::IntrinsicWorkGraph;
    default: return diag::IntrinsicUnsupported;
  }
}

ExprId Refuse(const IntrinsicCheck& call, const Entry& entry) {
  if (entry.rule == Rule::kImplicitLevel) {
    const std::string dimension(entry.name.substr(0, entry.detail == kSCube ? 7 : 5));
    call.diagnostics.Report(call.name_span, diag::IntrinsicImplicitLevel, entry.name,
                            dimension + "lod");
    return call.Error();
  }
  call.diagnostics.Report(call.name_span, RefusalOf(entry.rule), entry.name);
  // Debug output is only warned of: what is left of it is a value that nobody uses.
  return entry.rule == Rule::kDebug ? call.Make().Int(0) : call.Error();
}

// The first profile whose fxc knows the intrinsic, where that matters: what needs integer
// registers.
int MajorProfileOf(ir::Intrinsic op) {
  switch (op) {
    case ir::Intrinsic::kAsFloat:
    case ir::Intrinsic::kAsInt:
    case ir::Intrinsic::kAsUint: return 4;
    case ir::Intrinsic::kAsDouble:
    case ir::Intrinsic::kCountBits:
    case ir::Intrinsic::kF16ToF32:
    case ir::Intrinsic::kF32ToF16:
    case ir::Intrinsic::kFirstBitHigh:
    case ir::Intrinsic::kFirstBitLow:
    case ir::Intrinsic::kFma:
    case ir::Intrinsic::kReverseBits: return 5;
    default: return 1;
  }
}

ExprId CheckIr(const IntrinsicCheck& call, ir::Intrinsic op) {
  const int major = MajorProfileOf(op);
  if (!call.program.profile.IsAtLeast(major, 0)) {
    const std::string needed = "vs_" + std::to_string(major) + "_0";
    call.diagnostics.Report(call.name_span, diag::IntrinsicProfile, call.name, needed,
                            call.program.profile.name);
    return call.Error();
  }
  if (!SignatureOf(op).is_special) return CheckBySignature(call, op);
  switch (op) {
    case ir::Intrinsic::kMul: return CheckMul(call);
    case ir::Intrinsic::kFirstBitHigh: return CheckFirstBitHigh(call);
    default: return CheckBitCast(call, op);
  }
}

}  // namespace

bool IsIntrinsicName(std::string_view name) { return FindEntry(name) != nullptr; }

ExprId CheckIntrinsicCall(ir::Program& program, std::string_view name, Span name_span,
                          std::span<const ExprId> arguments, Span call_span,
                          TemporaryMaker& temporaries, Diagnostics& diagnostics) {
  const IntrinsicCheck call(program, name, name_span, arguments, call_span, temporaries,
                            diagnostics);
  const Entry* entry = FindEntry(name);
  if (entry == nullptr) {
    diagnostics.Report(name_span, diag::IntrinsicUnsupported, name);
    return call.Error();
  }
  for (const ExprId argument : arguments) {
    if (call.TypeIdOf(argument) == program.types.Error()) return call.Error();
  }
  switch (entry->rule) {
    case Rule::kIr: return CheckIr(call, static_cast<ir::Intrinsic>(entry->detail));
    case Rule::kSelect: return CheckSelect(call);
    case Rule::kAnd: return CheckLogical(call, ir::BinaryOp::kLogicalAnd);
    case Rule::kOr: return CheckLogical(call, ir::BinaryOp::kLogicalOr);
    case Rule::kIdentity: return call.HasCount(1, 1) ? arguments[0] : call.Error();
    case Rule::kTexLod: return CheckTexLod(call, static_cast<ir::ObjectKind>(entry->detail));
    default: return Refuse(call, *entry);
  }
}

std::vector<std::string_view> NearIntrinsics(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Entry& entry : kEntries) {
    if (entry.rule < Rule::kAbort) names.push_back(entry.name);
  }
  return NearNames(name, names);
}

}  // namespace clipc
