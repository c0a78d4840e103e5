// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/written.h"

#include <algorithm>

#include "ir/access.h"

namespace clipc::rules {
namespace {

bool IsLocal(Storage storage) {
  return storage == Storage::kLocal || storage == Storage::kIn || storage == Storage::kOut ||
         storage == Storage::kInOut;
}

std::uint16_t Bits(std::uint32_t count) {
  return static_cast<std::uint16_t>(count >= 16 ? 0xffff : (1u << count) - 1);
}

}  // namespace

// ---- slots

void WrittenSlots::Track(VarId var) {
  if (IsTracked(var) || !IsLocal(program_.vars[var].storage)) return;
  first_[var.index] = size_;
  size_ += CountOf(program_.vars[var].type);
}

std::uint32_t WrittenSlots::CountOf(TypeId type) const {
  const std::uint32_t count = Count(type);
  return count > kMostSlots ? 1 : count;
}

// The number of slots, or kMostSlots + 1 for more.
std::uint32_t WrittenSlots::Count(TypeId type) const {
  if (program_.types[type].kind != TypeKind::kStruct) return 1;
  std::uint32_t& known = counts_[type.index];
  if (known != 0) return known;
  std::uint32_t count = 0;
  for (const Field& field : program_.types.StructOf(type).fields) {
    count += Count(field.type);
    if (count > kMostSlots) break;
  }
  return known = std::clamp(count, 1u, kMostSlots + 1);
}

std::uint16_t WrittenSlots::MaskOf(TypeId id) const {
  const Type& type = program_.types[id];
  if (type.IsNumeric()) return Bits(type.Components());
  if (type.kind == TypeKind::kStruct) return 0xffff;
  return type.kind == TypeKind::kArray && type.count <= 16 ? Bits(type.count) : 1;
}

void WrittenSlots::AddMasks(TypeId type, KeptVector<std::uint16_t>& masks) const {
  if (program_.types[type].kind != TypeKind::kStruct) return masks.push_back(MaskOf(type));
  const std::vector<Field>& fields = program_.types.StructOf(type).fields;
  if (fields.empty()) masks.push_back(0);
  for (const Field& field : fields) AddMasks(field.type, masks);
}

KeptVector<std::uint16_t> WrittenSlots::MasksOf(TypeId type) const {
  if (Count(type) > kMostSlots) return {1};
  KeptVector<std::uint16_t> masks;
  AddMasks(type, masks);
  return masks;
}

WrittenPlace WrittenSlots::Whole(VarId var) const {
  const TypeId type = program_.vars[var].type;
  WrittenPlace place{var, first_[var.index], CountOf(type)};
  const bool is_struct = program_.types[type].kind == TypeKind::kStruct;
  place.mask = MaskOf(type);
  place.has_components = program_.types[type].IsNumeric();
  place.is_coarse = is_struct && Count(type) > kMostSlots;
  return place;
}

std::optional<WrittenPlace> WrittenSlots::Find(ExprId path) const {
  if (const auto* ref = As<VarRef>(program_, path)) {
    if (!IsTracked(ref->var)) return std::nullopt;
    return Whole(ref->var);
  }
  const ExprId whole = WholeOf(program_, path);
  std::optional<WrittenPlace> place = whole ? Find(whole) : std::nullopt;
  if (!place) return place;
  if (const auto* field = As<FieldRef>(program_, path)) {
    TakeField(*place, *field);
  } else if (const auto* index = As<Index>(program_, path)) {
    TakeElement(*place, *index);
  } else if (place->has_components) {
    std::uint32_t mask = 0;
    if (const auto* swizzle = As<Swizzle>(program_, path)) {
      for (int i = 0; i < swizzle->count; ++i)
        mask |= 1u << (place->offset + swizzle->components[i]);
    } else if (const auto* matrix = As<MatrixSwizzle>(program_, path)) {
      const int columns = TypeOf(program_, whole).columns;
      for (int i = 0; i < matrix->count; ++i)
        mask |= 1u << (matrix->rows[i] * columns + matrix->columns[i]);
    }
    place->mask &= static_cast<std::uint16_t>(mask);
    place->has_components = false, place->is_coarse = true;
  }
  return place;
}

void WrittenSlots::TakeField(WrittenPlace& place, const FieldRef& field) const {
  if (place.is_coarse) return;
  const std::vector<Field>& fields = program_.types.StructOf(TypeIdOf(program_, field.base)).fields;
  for (std::uint32_t i = 0; i < field.field; ++i) place.first += Count(fields[i].type);
  const TypeId type = fields[field.field].type;
  place.count = Count(type);
  place.mask = MaskOf(type);
  place.has_components = program_.types[type].IsNumeric();
}

void WrittenSlots::TakeElement(WrittenPlace& place, const Index& index) const {
  const Type& whole = TypeOf(program_, index.base);
  const auto* literal = As<Literal>(program_, index.index);
  const bool is_matrix = whole.kind == TypeKind::kMatrix;
  const bool is_array = whole.kind == TypeKind::kArray && whole.count <= 16;
  const std::uint64_t count = is_matrix ? whole.rows : is_array ? whole.count : whole.columns;
  const bool is_known = literal && literal->bits < count && (is_array || place.has_components);
  place.has_components = is_known && is_matrix && !place.is_coarse;
  if (is_known && !place.is_coarse) {
    const std::uint32_t width = is_matrix ? whole.columns : 1;
    const auto begin = static_cast<std::uint32_t>(place.offset + literal->bits * width);
    place.mask &= static_cast<std::uint16_t>(Bits(width) << begin);
    place.offset = static_cast<std::uint8_t>(begin);
  }
  place.is_coarse = !place.has_components;
}

// ---- state

void WrittenState::Set(std::size_t slot, WrittenComponents value) {
  if (now_[slot] == value) return;
  log_.push_back({slot, now_[slot]});
  now_[slot] = value;
}

WrittenState::Changes WrittenState::TakeSince(std::size_t mark) {
  Changes changes;
  ++walk_;
  while (log_.size() > mark) {
    const Change before = log_.back();
    log_.pop_back();
    if (seen_[before.slot] != walk_) {
      seen_[before.slot] = walk_;
      changes.push_back({before.slot, now_[before.slot]});
    }
    now_[before.slot] = before.value;
  }
  return changes;
}

std::uint16_t WrittenState::UnsafeAt(std::size_t slot, std::uint16_t mask,
                                     const JoinPoint& point) const {
  const bool is_later = point.loops > places_[slot].loops || point.choices > places_[slot].choices;
  return is_later ? 0 : static_cast<std::uint16_t>(mask & now_[slot].may & ~now_[slot].safe);
}

void WrittenState::MakeSafe(bool is_discarded) {
  for (std::size_t slot = 0; slot < now_.size(); ++slot) {
    WrittenComponents value = now_[slot];
    value.safe |= is_discarded ? kAllWritten.safe : value.may;
    Set(slot, value);
  }
}

WrittenComponents WrittenState::Merge(std::size_t slot, WrittenComponents one,
                                      WrittenComponents other, const JoinPoint& point) {
  WrittenComponents all = one;
  all.may |= other.may;
  all.must &= other.must;
  if (one.safe == other.safe) return all;
  // What an iteration writes, another may have written before.
  const bool is_either = places_[slot].loops < point.loops ||
                         (point.paths && point.paths->HasKnownCases(point.condition));
  if (is_either) {
    all.safe |= other.safe;
  } else {
    all.safe &= other.safe;
    places_[slot].choices = point.choices;
  }
  return all;
}

void WrittenState::Join(const Changes& one, const Changes& other, const JoinPoint& point) {
  const auto join = [&](const Change& change) {
    Set(change.slot, Merge(change.slot, now_[change.slot], change.value, point));
  };
  ++walk_;
  for (const Change& change : other) seen_[change.slot] = walk_;
  // A slot that only one path has changed has on the other the value that it has now.
  for (const Change& change : one) {
    if (seen_[change.slot] == walk_) {
      Set(change.slot, change.value);
    } else {
      join(change);
    }
  }
  for (const Change& change : other) join(change);
}

void WrittenState::JoinAll(Changes changes, std::size_t paths, const JoinPoint& point) {
  std::ranges::sort(changes, {}, &Change::slot);
  for (std::size_t begin = 0, end = 0; begin < changes.size(); begin = end) {
    const std::size_t slot = changes[begin].slot;
    WrittenComponents all = changes[begin].value;
    for (end = begin + 1; end < changes.size() && changes[end].slot == slot; ++end)
      all = Merge(slot, all, changes[end].value, point);
    if (end - begin < paths) all = Merge(slot, all, now_[slot], point);
    Set(slot, all);
  }
}

void WrittenState::AddMay(const Changes& changes) {
  for (const Change& change : changes) {
    WrittenComponents value = now_[change.slot];
    value.may |= change.value.may;
    value.safe |= change.value.may;
    Set(change.slot, value);
  }
}

}  // namespace clipc::rules
