// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/intrinsics.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <numeric>
#include <string>
#include <vector>

#include "base/spelling.h"
#include "base/word_index.h"
#include "frontend/typing/intrinsic_call.h"
#include "frontend/typing/reread.h"
#include "ir/intrinsic_list.h"

namespace clipc::typing {
namespace {

// The treatment of a call by its name.
enum class Rule : std::uint8_t {
  kCall,  // becomes a call of an ir::Intrinsic
  kSelect,
  kAnd,
  kOr,
  kAtomic,
  kTexLod,
  kTex,
  kTexBias,
  kTexGrad,
  kTexProj,
  kInvocation,
  kFirstLane,
  kSamplePosition,
  kDebug,  // warned of and dropped
  kRefused,
};
using Refusal = ExprId(const IntrinsicCheck& call);
struct Entry {
  std::string_view name = {};
  Rule rule = Rule::kRefused;
  Intrinsic intrinsic = {};  // for kCall
  // For kRefused.
  Refusal* refuse = nullptr;
  Staged staged = {};
};

// Reports the call. A message has places for the function, then for the stage, and then for the
// function that is given a level of detail: tex2Dlod instead of tex2Dbias.
template <typename... Texts>
ExprId Report(const IntrinsicCheck& call, const diag::Kind<Texts...>& kind) {
  const std::string_view stage = call.ThisStage().name;
  if constexpr (sizeof...(Texts) == 1) {
    return call.Fail(call.name_span, kind, call.name);
  } else if constexpr (sizeof...(Texts) == 2) {
    return call.Fail(call.name_span, kind, call.name, stage);
  } else {
    const std::string_view dimension = call.name.substr(0, call.name.find_first_of("DE") + 1);
    return call.Fail(call.name_span, kind, call.name, stage, std::string(dimension) + "lod");
  }
}
template <const auto& kKind>
ExprId Refuse(const IntrinsicCheck& call) {
  return Report(call, kKind);
}

constexpr std::size_t kCounts[] = {
#define INTRINSIC(...) 1,
#define BY_RULE(Rule, ...) std::initializer_list<const char*>{__VA_ARGS__}.size(),
#define STAGED(Family, Trait, Result, ...) std::initializer_list<const char*>{__VA_ARGS__}.size(),
#define REFUSED(Family, ...) std::initializer_list<const char*>{__VA_ARGS__}.size(),
#include "ir/intrinsics.def"
};

// All functions of ir/intrinsics.def in the order of their names.
constexpr auto kEntries = [] {
  std::array<Entry, std::accumulate(std::begin(kCounts), std::end(kCounts), std::size_t{})>
      entries{};
  std::size_t at = 0;
  const auto add = [&](Entry entry, std::initializer_list<const char*> names) {
    for (const char* name : names) {
      entry.name = name;
      entries[at++] = entry;
    }
  };
#define INTRINSIC(Enumerator, Name, ...) \
  add({.rule = Rule::kCall, .intrinsic = Intrinsic::k##Enumerator}, {Name});
#define BY_RULE(Name, ...) add({.rule = Rule::k##Name}, {__VA_ARGS__});
#define STAGED(Family, Trait, Result, ...)                               \
  add({.refuse = Refuse<diag::Intrinsic##Family>,                        \
       .staged = {.trait = &StageInfo::Trait, .type = StandIn::Result}}, \
      {__VA_ARGS__});
#define REFUSED(Family, ...) add({.refuse = Refuse<diag::Intrinsic##Family>}, {__VA_ARGS__});
#include "ir/intrinsics.def"
  std::ranges::sort(entries, {}, &Entry::name);
  return entries;
}();

constexpr WordIndex kEntryIndex = [] {
  std::array<std::string_view, kEntries.size()> names;
  std::ranges::transform(kEntries, names.begin(), &Entry::name);
  return WordIndex(names);
}();

const Entry* FindEntry(std::string_view name) {
  const std::size_t i = kEntryIndex.Find(name);
  return i != kEntryIndex.kNone ? &kEntries[i] : nullptr;
}

// Checks a function that takes the level of detail from neighbouring pixels.
ExprId NeedsNeighbours(const IntrinsicCheck& call, ExprId (&check)(const IntrinsicCheck&)) {
  return call.ThisStage().has_neighbours ? check(call) : Report(call, diag::IntrinsicImplicitLevel);
}

// Reports and returns false if the profile has no gradients. D3DXGetPixelShaderProfile: of the
// profiles 2_x, ps_2_a alone has GradientInstructions; level 9_1 runs as ps_2_0.
bool HasGradients(const IntrinsicCheck& call) {
  const Profile& profile = call.program.profile;
  const bool is_level9 = profile.level9 == Level9::k9_0 || profile.level9 == Level9::k9_1;
  if (!is_level9 && profile.name != "ps_2_0" && profile.name != "ps_2_b") return true;
  const std::string_view needed = is_level9 ? "ps_4_0_level_9_3" : "ps_2_a or ps_3_0";
  call.Fail(call.name_span, diag::IntrinsicProfile, call.name, needed, profile.name);
  return false;
}

ExprId CheckAtomicCall(const IntrinsicCheck& call) {
  const ExprId value = StandInFor(call, {.trait = &StageInfo::draws_pixels});
  return value ? value : CheckAtomic(call);
}

// Whether shaders of the stage have a barrier: one that waits, or orders memory that a group
// shares, is for a stage with groups.
bool HasBarrier(const StageInfo& stage, const ir::BarrierInfo& barrier) {
  return barrier.waits || barrier.orders_shared ? stage.runs_in_groups : stage.orders_memory;
}

ExprId CheckIr(const IntrinsicCheck& call, Intrinsic op) {
  const IntrinsicInfo& info = InfoOf(op);
  if (info.category == IntrinsicCategory::kMemory &&
      !HasBarrier(call.ThisStage(), ir::BarrierOf(op)))
    return Report(call, diag::IntrinsicBarrier);
  if (!call.program.profile.IsAtLeast(info.first_model, 0) && !call.program.is_interface_only) {
    const std::string needed = fmt::format("{}_{}_0", call.ThisStage().prefix, info.first_model);
    return call.Fail(call.name_span, diag::IntrinsicProfile, call.name, needed,
                     call.program.profile.name);
  }
  if (info.category == IntrinsicCategory::kNeighbours) {
    if (call.ThisStage().runs_in_groups)
      return call.Fail(call.name_span, diag::IntrinsicComputeDerivative, call.name);
    if (!call.ThisStage().has_neighbours) return Report(call, diag::IntrinsicDerivative);
    if (!HasGradients(call)) return call.Error();
  }
  if (info.category == IntrinsicCategory::kInterpolants && !call.ThisStage().draws_pixels)
    return Report(call, diag::IntrinsicInterpolation);
  if (info.category == IntrinsicCategory::kQuad && !call.ThisStage().has_neighbours &&
      !call.ThisStage().runs_in_groups)
    return Report(call, diag::IntrinsicDerivative);
  if (op == Intrinsic::kClip && !call.ThisStage().draws_pixels)
    return Report(call, diag::IntrinsicDiscard);
  if (op == Intrinsic::kCountBits || op == Intrinsic::kFirstBitHigh ||
      op == Intrinsic::kFirstBitLow || op == Intrinsic::kReverseBits) {
    if (const ExprId bits = CheckWideBits(call, op)) return bits;
  }
  if (info.category == IntrinsicCategory::kAtomic) return CheckAtomicCall(call);
  if (!info.signature.is_special) {
    const ExprId value = CheckBySignature(call, op);
    // DXC's `refract` of halves is a float (vkd3d's refract.shader_test, checked against native).
    const bool is_half = call.TypeOf(value).scalar == Scalar::kHalf;
    return op == Intrinsic::kRefract && is_half && call.program.profile.IsAtLeast(6, 0)
               ? call.Make().ConvertTo(Scalar::kFloat, value)
               : value;
  }
  return op == Intrinsic::kMul ? CheckMul(call) : CheckBitCast(call, op);
}

}  // namespace

bool IsIntrinsicName(std::string_view name) { return FindEntry(name) != nullptr; }

bool IsWritingIntrinsic(std::string_view name) {
  const Entry* entry = FindEntry(name);
  return entry != nullptr && entry->rule == Rule::kCall && WritesArguments(entry->intrinsic);
}

bool TakesArguments(const IntrinsicCheck& call) {
  const Entry* entry = FindEntry(call.name);
  return entry && entry->rule == Rule::kCall && FitsSignature(call, entry->intrinsic);
}

ExprId CheckIntrinsicCall(const IntrinsicCheck& call) {
  const Entry* entry = FindEntry(call.name);
  if (entry == nullptr) return call.Fail(call.name_span, diag::IntrinsicUnsupported, call.name);
  if (call.HasErrorArgument()) return call.Error();
  switch (entry->rule) {
    case Rule::kCall: return CheckIr(call, entry->intrinsic);
    case Rule::kSelect: return CheckSelect(call);
    case Rule::kAnd: return CheckLogical(call, BinaryOp::kLogicalAnd);
    case Rule::kOr: return CheckLogical(call, BinaryOp::kLogicalOr);
    case Rule::kAtomic: return CheckAtomicCall(call);
    case Rule::kTexLod: return CheckTexLod(call);
    case Rule::kTex: return NeedsNeighbours(call, CheckTex);
    case Rule::kTexBias: return NeedsNeighbours(call, CheckTexBias);
    case Rule::kTexGrad:
      return HasGradients(call) ? NeedsNeighbours(call, CheckTexGrad) : call.Error();
    case Rule::kTexProj: return NeedsNeighbours(call, CheckTexProj);
    case Rule::kInvocation: return CheckFact(call);
    case Rule::kFirstLane: return CheckFirstLane(call);
    case Rule::kSamplePosition: return CheckTargetSamplePosition(call);
    case Rule::kDebug:
      call.diagnostics.Report(call.name_span, diag::IntrinsicDebug, call.name);
      return call.Make().Int(0);  // a value that nobody uses
    case Rule::kRefused: break;
  }
  if (const ExprId value = StandInFor(call, entry->staged)) return value;
  // The message of a family says why other stages may not call it.
  const bool may_call = entry->staged.trait && call.ThisStage().*entry->staged.trait;
  return may_call ? Report(call, diag::IntrinsicUnsupported) : entry->refuse(call);
}

std::vector<std::string_view> NearIntrinsics(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Entry& entry : kEntries) {
    if (entry.rule != Rule::kRefused && entry.rule != Rule::kDebug) names.push_back(entry.name);
  }
  return NearNames(name, names);
}

}  // namespace clipc::typing
