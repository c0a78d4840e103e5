// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/object.h"

#include <cstddef>

namespace clipc::ir {
namespace {

enum Flag : unsigned {
  kWritable = 1,
  kArray = 2,
  kCube = 4,
  kMultisampled = 8,
  kOrdered = 16,
  kCompares = 32
};

constexpr ObjectInfo MakeInfo(const char* name, ObjectCategory category, std::uint8_t model = 10,
                              std::uint8_t axes = 0, unsigned flags = 0) {
  return {.name = name,
          .category = category,
          .model = model,
          .axes = axes,
          .is_writable = (flags & kWritable) != 0,
          .is_ordered = (flags & kOrdered) != 0,
          .is_array = (flags & kArray) != 0,
          .is_cube = (flags & kCube) != 0,
          .is_multisampled = (flags & kMultisampled) != 0,
          .compares = (flags & kCompares) != 0};
}

bool IsOf(ObjectKind kind, ObjectCategory category) { return InfoOf(kind).category == category; }

}  // namespace

const ObjectInfo& InfoOf(ObjectKind kind) {
  using enum ObjectCategory;
  static constexpr ObjectInfo kInfos[] = {
#define OBJECT(Enumerator, Spelling, Case, ...) MakeInfo(Spelling, __VA_ARGS__),
#include "base/builtin_types.def"
      MakeInfo("sampler2DShadow", kCombinedSampler, 10, 2, kCompares),
      MakeInfo("object", kOther),
  };
  return kInfos[static_cast<std::size_t>(kind)];
}

int FirstModelOf(ObjectKind kind, const StageInfo& stage) {
  const bool is_early = stage.runs_in_groups && (kind == ObjectKind::kRWStructuredBuffer ||
                                                 kind == ObjectKind::kRWByteAddressBuffer);
  return is_early ? 40 : InfoOf(kind).model;
}

bool IsWritable(ObjectKind kind) { return InfoOf(kind).is_writable; }
bool IsOrdered(ObjectKind kind) { return InfoOf(kind).is_ordered; }
bool IsTexture(ObjectKind kind) {
  return IsOf(kind, ObjectCategory::kTexture) && !IsWritable(kind);
}
bool IsCombinedSampler(ObjectKind kind) { return IsOf(kind, ObjectCategory::kCombinedSampler); }
bool IsSampler(ObjectKind kind) {
  return IsOf(kind, ObjectCategory::kSampler) || IsCombinedSampler(kind);
}
bool IsImage(ObjectKind kind) { return IsWritable(kind) && !IsStorageBuffer(kind); }
bool IsStructured(ObjectKind kind) { return IsOf(kind, ObjectCategory::kStructuredBuffer); }
bool HasNamedElements(ObjectKind kind) {
  return kind != ObjectKind::kAppendStructuredBuffer &&
         kind != ObjectKind::kConsumeStructuredBuffer;
}
bool IsByteAddress(ObjectKind kind) { return IsOf(kind, ObjectCategory::kByteAddressBuffer); }
bool IsStream(ObjectKind kind) { return IsOf(kind, ObjectCategory::kStream); }
bool IsStorageBuffer(ObjectKind kind) { return IsStructured(kind) || IsByteAddress(kind); }
bool HasTexels(ObjectKind kind) {
  return IsOf(kind, ObjectCategory::kTexture) || IsOf(kind, ObjectCategory::kSubpass) ||
         IsOf(kind, ObjectCategory::kTypedBuffer);
}
bool HasElement(ObjectKind kind) { return HasTexels(kind) || IsStructured(kind) || IsStream(kind); }
char RegisterLetter(ObjectKind kind) {
  return IsSampler(kind) ? 's' : IsWritable(kind) ? 'u' : 't';
}

}  // namespace clipc::ir
