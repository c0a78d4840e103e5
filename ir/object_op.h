// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "ir/object.h"

// The reads and writes through texture and buffer objects: one row of ir/ops.def each, where the
// columns are explained. OperandOf of ir/access.h gives an operand of a call by its name.
namespace clipc::ir {

enum class ObjectOp : std::uint8_t {
#define OP(Enumerator, ...) k##Enumerator,
#include "ir/ops.def"
};

inline constexpr std::size_t kObjectOps = 0
#define OP(...) +1
#include "ir/ops.def"
    ;

// The names of operands, in an order that every list of operands has.
enum class OperandKind : std::uint8_t {
  kObject,      // a VarRef, or an Index of one for an array of them
  kSampler,     // the same
  kCoordinate,  // float{1..4}: where a texture is sampled, with the element of an array
  kPlace,       // integers: where a texel or an element is read or written
  kReference,   // a number that texels are compared with
  kLevel,       // of detail: a float after a coordinate, otherwise an integer
  kBias,        // a float
  kDdx,         // float{1..3}: the steps of the coordinate from pixel to pixel
  kDdy,
  kSample,     // an int, the number of a multisampled object's sample
  kOffset,     // int{1..3} in texels: literals, but for a gather and before resolve::KnowOffsets
  kStep,       // an integer
  kComparand,  // what an element is compared with, of the value's type
  kValue,      // what is written, or combined with an element
  kClamp,      // a float, the least level of detail of a sample
  kTexel,      // a target that the value of the read is assigned to
};
inline constexpr std::size_t kOperandKinds = 16;
const char* NameOf(OperandKind kind);

enum class ObjectResult : std::uint8_t {
  kVoid,
  kElement,     // the ObjectType's element; float4 if it has none
  kFloat,       // a float scalar
  kFourTexels,  // a vector of four
  kInts,        // an int scalar or vector
  kUints,       // a uint scalar or vector
  kOldValue,    // of the value's type
};

// An entry in the list of an operation's operands.
struct OperandSlot {
  OperandKind kind{};
  std::uint8_t least = 1, most = 1;  // the number of such operands that a call has

  constexpr OperandSlot() = default;
  constexpr OperandSlot(OperandKind kind) : kind(kind) {}
  constexpr OperandSlot(OperandKind kind, std::uint8_t least, std::uint8_t most)
      : kind(kind), least(least), most(most) {}
  // Of at most one slot of an operation.
  constexpr bool IsVariable() const { return least != most; }
};

struct ObjectOpInfo {
  enum Trait : std::uint8_t {
    kNothing = 0,
    kReads = 1,       // the contents
    kWrites = 2,      // the contents
    kAtomic = 4,      // reads and writes an element in one step
    kCounts = 8,      // changes the counter of a structured buffer
    kNeighbours = 16  // takes the level of detail from neighbouring pixels
  };

  static constexpr std::uint8_t kUnlimited = 0xFF;

  const char* name;       // in a printed program
  const char* method;     // HLSL's; "" if no method is this operation alone
  std::uint16_t objects;  // a bit for each ObjectCategory
  std::uint8_t traits;    // a sum of them
  ObjectResult result;
  std::uint8_t least, most;  // the number of operands that a call has, without those of tiled ones
  std::uint8_t slot_count;
  std::array<OperandSlot, 7> slots;
  // Where a call has the operands of a kind.
  struct Place {
    bool exists, is_variable, follows_variable;
    std::uint8_t before;  // the operands that every call has before them
  };
  std::array<Place, kOperandKinds> places;  // by OperandKind

  std::span<const OperandSlot> Slots() const { return std::span(slots).first(slot_count); }
};
extern const std::array<ObjectOpInfo, kObjectOps> kObjectOpInfos;  // by ObjectOp
inline const ObjectOpInfo& InfoOf(ObjectOp op) {
  return kObjectOpInfos[static_cast<std::size_t>(op)];
}

inline bool Takes(ObjectOp op, OperandKind kind) {
  return InfoOf(op).places[static_cast<std::size_t>(kind)].exists;
}
// The operands of one kind among the `size` operands of a call: `count` of them from `first` on.
struct OperandRun {
  std::uint32_t first = 0, count = 0;
};
inline OperandRun RunOf(ObjectOp op, OperandKind kind, std::uint32_t size) {
  const ObjectOpInfo& info = InfoOf(op);
  const ObjectOpInfo::Place& place = info.places[static_cast<std::size_t>(kind)];
  const std::uint32_t more = size > info.least ? size - info.least : 0;
  const std::uint32_t first = place.before + (place.follows_variable ? more : 0);
  const std::uint32_t count = place.is_variable ? more : place.exists;
  return {first, first < size ? count : 0};
}
// Whether one of these traits is true of the operation.
inline bool HasTrait(ObjectOp op, unsigned traits) { return (InfoOf(op).traits & traits) != 0; }
inline bool IsAtomic(ObjectOp op) { return HasTrait(op, ObjectOpInfo::kAtomic); }
// Whether the atomic operation changes floats too, by their bits.
inline bool Exchanges(ObjectOp op) {
  return op == ObjectOp::kAtomicExchange || op == ObjectOp::kAtomicCompareExchange;
}
// Whether the operation changes the counter of a structured buffer.
inline bool IsCounter(ObjectOp op) { return HasTrait(op, ObjectOpInfo::kCounts); }
inline bool ReadsObject(ObjectOp op) {
  return HasTrait(op, ObjectOpInfo::kReads | ObjectOpInfo::kAtomic);
}
// Whether the operation changes the contents of the object, or its counter.
inline bool WritesObject(ObjectOp op) {
  return HasTrait(op, ObjectOpInfo::kWrites | ObjectOpInfo::kAtomic | ObjectOpInfo::kCounts);
}
// Whether the operation takes the level of detail from neighbouring pixels.
inline bool AsksNeighbours(ObjectOp op) { return HasTrait(op, ObjectOpInfo::kNeighbours); }
// Whether the operation reads one component of four texels, or compares it.
inline bool IsGather(ObjectOp op) { return InfoOf(op).result == ObjectResult::kFourTexels; }
// The number of the component that a gather reads.
int ComponentOf(ObjectOp gather);
// Whether the operation reads an element of the object, or a texel, by its place.
inline bool LoadsElement(ObjectOp op) {
  return InfoOf(op).result == ObjectResult::kElement && Takes(op, OperandKind::kPlace);
}

}  // namespace clipc::ir
