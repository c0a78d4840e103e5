// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "base/kept_blocks.h"
#include "frontend/rules/names.h"
#include "frontend/rules/written_paths.h"

namespace clipc::rules {

// The components of a slot that some path has written, those that every path has, where a loop runs
// at least once, and those that may be read without a warning: every path has written them, or the
// paths that have not are not known to lead there.
struct WrittenComponents {
  std::uint16_t may = 0, must = 0, safe = 0;
  friend bool operator==(const WrittenComponents&, const WrittenComponents&) = default;
};
inline constexpr WrittenComponents kAllWritten{0xffff, 0xffff, 0xffff};

inline bool AreAllWritten(std::span<const WrittenComponents> values) {
  return std::ranges::all_of(values, [](WrittenComponents value) { return value == kAllWritten; });
}

// A point where paths join.
struct JoinPoint {
  int loops = 0;    // around it
  int choices = 0;  // the conditions and loops around it
  // What chose between the paths; none: nothing is known of it.
  WrittenPaths* paths = nullptr;
  ExprId condition = {};
};

// A place in a local variable: the slots of a struct, or components of one slot.
struct WrittenPlace {
  VarId var;
  std::size_t first = 0, count = 0;
  std::uint16_t mask = 0;       // of one slot
  std::uint8_t offset = 0;      // the first component of the place in its slot
  bool has_components = false;  // its parts are components, of which the slot has a bit for each
  bool is_coarse = false;       // its parts cannot be told apart: they are taken for the whole
};

// The slots of the variables that are tracked. A field that is a number, a vector, a matrix or an
// array is a slot, with a bit for each component or element; a variable with more than kMostSlots
// of them, or an array of more than 16 elements, has one slot whose bits are all written together.
//
// A variable is tracked from the first point on where a part of it may be unwritten. Most never
// are: they begin with a value.
class WrittenSlots {
 public:
  explicit WrittenSlots(const Program& program)
      : program_(program), counts_(program.types.size()), first_(program.vars.size(), kUntracked) {}

  static constexpr std::uint32_t kMostSlots = 64;

  std::size_t size() const { return size_; }
  bool IsTracked(VarId var) const { return first_[var.index] != kUntracked; }
  // Gives slots to a local variable or a parameter that has none yet. Other variables get none.
  void Track(VarId var);
  // The slots of a value of the type; 1 for one with too many.
  std::uint32_t CountOf(TypeId type) const;
  // The bits of each slot of the type.
  KeptVector<std::uint16_t> MasksOf(TypeId type) const;
  // Requires that the variable is tracked.
  WrittenPlace Whole(VarId var) const;
  // The place of a path in a variable that is tracked; nullopt for every other expression.
  std::optional<WrittenPlace> Find(ExprId path) const;

 private:
  std::uint32_t Count(TypeId type) const;
  void AddMasks(TypeId type, KeptVector<std::uint16_t>& masks) const;
  std::uint16_t MaskOf(TypeId type) const;
  void TakeField(WrittenPlace& place, const FieldRef& field) const;
  void TakeElement(WrittenPlace& place, const Index& index) const;

  static constexpr std::size_t kUntracked = SIZE_MAX;

  const Program& program_;
  mutable KeptVector<std::uint32_t> counts_;  // by TypeId; 0: not known yet
  KeptVector<std::size_t> first_;             // by VarId
  std::size_t size_ = 0;
};

// What is written at a point of a function, and the changes that led to it.
class WrittenState {
 public:
  struct Change {
    std::size_t slot;
    WrittenComponents value;
  };
  using Changes = KeptVector<Change>;

  // Adds slots up to the number `slots`, all of them written.
  void Grow(std::size_t slots) {
    now_.resize(slots, kAllWritten);
    seen_.resize(slots);
    places_.resize(slots);
  }
  // Makes a slot unwritten, of a variable that is declared in so many loops.
  void Declare(std::size_t slot, int loops) {
    Set(slot, {});
    places_[slot].loops = loops;
  }
  int LoopsOf(std::size_t slot) const { return places_[slot].loops; }
  // The components among `mask` that a path to this point has written and another has not. Under
  // further conditions, and in further loops, there are none.
  std::uint16_t UnsafeAt(std::size_t slot, std::uint16_t mask, const JoinPoint& point) const;
  // After a path was left on a condition: all that a path has written is safe. Where the pixel is
  // discarded, everything is.
  void MakeSafe(bool is_discarded);
  const WrittenComponents& operator[](std::size_t slot) const { return now_[slot]; }
  void Set(std::size_t slot, WrittenComponents value);
  void Add(std::size_t slot, std::uint16_t mask) {
    Set(slot, {static_cast<std::uint16_t>(now_[slot].may | mask),
               static_cast<std::uint16_t>(now_[slot].must | mask),
               static_cast<std::uint16_t>(now_[slot].safe | mask)});
  }
  std::size_t Mark() const { return log_.size(); }
  // Reverts all changes since the mark, and returns each changed slot with its value.
  Changes TakeSince(std::size_t mark);
  // Makes the state that of a point where two paths join, which began with this one.
  void Join(const Changes& one, const Changes& other, const JoinPoint& point);
  // The same for any number of paths, whose changes are in one list; a path has a slot once.
  void JoinAll(Changes changes, std::size_t paths, const JoinPoint& point);
  // Makes the changes of a loop's body. Calls may_not_run() where it matters, once or more.
  template <typename MayNotRun>
  void LeaveLoop(const Changes& changes, const JoinPoint& point, MayNotRun&& may_not_run) {
    for (auto [slot, value] : changes) {  // fxc and dxc know the iterations of most loops
      const bool is_outer = places_[slot].loops <= point.loops;
      value.safe |= value.may;
      if (is_outer && value.safe != now_[slot].safe && may_not_run()) {
        value.safe = now_[slot].safe;
        places_[slot].choices = point.choices;
      }
      Set(slot, value);
    }
  }
  // Makes the changes of a path that is left (by break or continue): what it has written may be
  // written at the place where it arrives.
  void AddMay(const Changes& changes);
  void Apply(const Changes& changes) {
    for (const Change& change : changes) Set(change.slot, change.value);
  }

 private:
  // Where the variable of a slot is declared, and where a path that has written it joined one that
  // has not.
  struct Place {
    int loops = 0, choices = 0;
  };
  WrittenComponents Merge(std::size_t slot, WrittenComponents one, WrittenComponents other,
                          const JoinPoint& point);

  KeptVector<WrittenComponents> now_;
  KeptVector<Place> places_;        // by slot
  KeptVector<std::uint32_t> seen_;  // by slot: the last walk of the log that has found it
  std::uint32_t walk_ = 0;
  Changes log_;  // the values before
};

}  // namespace clipc::rules
