// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/intrinsic.h"

#include <string_view>

#include "ir/intrinsic_list.h"

namespace clipc::ir {
namespace {

constexpr IntrinsicSlot ParseSlot(std::string_view text, std::size_t& at) {
  const bool is_out = text[at] == 'o';
  at += is_out ? 3 : 2;
  return {text[at - 2], text[at - 1], is_out};
}

constexpr IntrinsicSignature ParseSignature(std::string_view text) {
  IntrinsicSignature signature;
  signature.is_special = text.starts_with("special");
  std::size_t at = text.find('(');
  std::size_t start = 0;
  if (!signature.is_special && !text.starts_with("void")) signature.result = ParseSlot(text, start);
  while (text[at] != ')' && text.substr(at) != "()") {
    ++at;  // the parenthesis or the comma
    const IntrinsicSlot slot = ParseSlot(text, at);
    signature.arguments[signature.count++] = slot;
    signature.writes |= slot.is_out;
  }
  return signature;
}

constexpr IntrinsicInfo MakeInfo(const char* name, const char* signature,
                                 IntrinsicCategory category, std::uint8_t first_model = 1,
                                 TargetGate gate = TargetGate::kNone) {
  return {name, signature, ParseSignature(signature), category, first_model, gate};
}

}  // namespace

#define COMMON(Name) constexpr Intrinsic CommonIntrinsic::Name = Intrinsic::Name;
COMMON(kAll)
COMMON(kAny)
COMMON(kAsDouble)
COMMON(kAsFloat)
COMMON(kAsUint)
COMMON(kAttributeAtVertex)
COMMON(kCheckAccessFullyMapped)
COMMON(kClamp)
COMMON(kClip)
COMMON(kDot)
COMMON(kEmitVertex)
COMMON(kEndPoints)
COMMON(kEndPrimitive)
COMMON(kFloor)
COMMON(kInputOfVertex)
COMMON(kIsFirstPoint)
COMMON(kIsNan)
COMMON(kMad)
COMMON(kMax)
COMMON(kMin)
COMMON(kMul)
COMMON(kNonUniform)
COMMON(kOutputOfPoint)
COMMON(kPow)
COMMON(kSaturate)
COMMON(kSign)
COMMON(kSmoothstep)
COMMON(kTranspose)
COMMON(kWaveReadLaneFirst)
COMMON(kWholePower)
#undef COMMON

const IntrinsicInfo& InfoOf(Intrinsic op) {
  using enum IntrinsicCategory;
  using enum TargetGate;
  static constexpr IntrinsicInfo kInfos[] = {
#define INTRINSIC(Enumerator, ...) MakeInfo(__VA_ARGS__),
#include "ir/intrinsics.def"
  };
  return kInfos[static_cast<std::size_t>(op)];
}

bool WritesArgument(Intrinsic op, std::size_t argument) {
  const IntrinsicSignature& signature = InfoOf(op).signature;
  return argument < signature.count && signature.arguments[argument].is_out;
}

BarrierInfo BarrierOf(Intrinsic op) {
  using enum Intrinsic;
  switch (op) {
    case kDeviceMemoryBarrier: return {.orders_objects = true};
    case kDeviceMemoryBarrierWithGroupSync: return {.orders_objects = true, .waits = true};
    case kGroupMemoryBarrier: return {.orders_shared = true};
    case kGroupMemoryBarrierWithGroupSync: return {.orders_shared = true, .waits = true};
    case kAllMemoryBarrier: return {true, true, false};
    case kAllMemoryBarrierWithGroupSync: return {true, true, true};
    default: return {};
  }
}

bool IsComposed(Intrinsic op) {
  using enum Intrinsic;
  switch (op) {
    case kD3dColorToUbyte4:
    case kDot2Add:
    case kDot4AddI8:
    case kDot4AddU8:
    case kDst:
    case kFmod:
    case kFrexp:
    case kIsFinite:
    case kLdexp:
    case kLit:
    case kLog10:
    case kMad:
    case kMsad4:
    case kPackClampS8:
    case kPackClampU8:
    case kPackS8:
    case kPackU8:
    case kQuadAll:
    case kQuadAny:
    case kRcp:
    case kSaturate:
    case kSincos:
    case kWholePower:
    case kUnpackS8S16:
    case kUnpackS8S32:
    case kUnpackU8U16:
    case kUnpackU8U32: return true;
    default: return false;
  }
}

}  // namespace clipc::ir
