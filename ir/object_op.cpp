// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/object_op.h"

#include <initializer_list>

namespace clipc::ir {
namespace {

constexpr OperandSlot Optional(OperandKind kind) { return {kind, 0, 1}; }
constexpr OperandSlot Many(OperandKind kind) { return {kind, 0, ObjectOpInfo::kUnlimited}; }

constexpr unsigned BitOf(ObjectCategory category) { return 1u << static_cast<unsigned>(category); }

constexpr ObjectOpInfo MakeInfo(const char* name, const char* method, unsigned objects,
                                unsigned traits, ObjectResult result,
                                std::initializer_list<OperandSlot> slots) {
  ObjectOpInfo info = {.name = name,
                       .method = method,
                       .objects = static_cast<std::uint16_t>(objects),
                       .traits = static_cast<std::uint8_t>(traits),
                       .result = result,
                       .least = 0,
                       .most = 0,
                       .slot_count = 0,
                       .slots = {},
                       .places = {}};
  bool follows_variable = false;
  for (const OperandSlot& slot : slots) {
    info.places[static_cast<std::size_t>(slot.kind)] = {.exists = true,
                                                        .is_variable = slot.IsVariable(),
                                                        .follows_variable = follows_variable,
                                                        .before = info.least};
    follows_variable |= slot.IsVariable();
    info.slots[info.slot_count++] = slot;
    info.least += slot.least;
    info.most = slot.most == ObjectOpInfo::kUnlimited || info.most == ObjectOpInfo::kUnlimited
                    ? ObjectOpInfo::kUnlimited
                    : static_cast<std::uint8_t>(info.most + slot.most);
  }
  return info;
}

constexpr auto MakeInfos() {
  using enum OperandKind;
  using enum ObjectResult;
  using enum ObjectOpInfo::Trait;
  constexpr OperandSlot Offsets = {kOffset, 0, 4};
  constexpr unsigned kTexture = BitOf(ObjectCategory::kTexture),
                     kCombinedSampler = BitOf(ObjectCategory::kCombinedSampler),
                     kSubpass = BitOf(ObjectCategory::kSubpass),
                     kTypedBuffer = BitOf(ObjectCategory::kTypedBuffer),
                     kStructuredBuffer = BitOf(ObjectCategory::kStructuredBuffer),
                     kByteAddressBuffer = BitOf(ObjectCategory::kByteAddressBuffer),
                     kStream = BitOf(ObjectCategory::kStream),
                     kAnyBuffer = kTypedBuffer | kStructuredBuffer | kByteAddressBuffer,
                     kAnyWritable = kTexture | kAnyBuffer;
  return std::array<ObjectOpInfo, kObjectOps>{
#define OP(Enumerator, Name, Method, Objects, Traits, Result, ...) \
  MakeInfo(Name, Method, Objects, Traits, Result, {__VA_ARGS__}),
#include "ir/ops.def"
  };
}

}  // namespace

constexpr std::array<ObjectOpInfo, kObjectOps> kObjectOpInfos = MakeInfos();

const char* NameOf(OperandKind kind) {
  static constexpr const char* kNames[kOperandKinds] = {
      "object", "sampler", "coordinate", "place", "reference", "level", "bias",  "ddx",
      "ddy",    "sample",  "offset",     "step",  "comparand", "value", "clamp", "texel"};
  return kNames[static_cast<std::size_t>(kind)];
}

int ComponentOf(ObjectOp gather) {
  switch (gather) {
    case ObjectOp::kGatherGreen: return 1;
    case ObjectOp::kGatherBlue: return 2;
    case ObjectOp::kGatherAlpha: return 3;
    default: return 0;
  }
}

}  // namespace clipc::ir
