// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "base/id.h"
#include "base/invariant.h"

namespace clipc {

// The owner of all values of type T of one tree, in the order of their creation. Values lie in
// fixed blocks, so references stay valid while the arena grows and a node may be read while others
// are added.
template <typename T>
class Arena {
 public:
  Id<T> Add(T value) { return Make(std::move(value)); }

  // Makes a value in place, from its members or from the arguments of its constructor.
  template <typename... Parts>
  Id<T> Make(Parts&&... parts) {
    if (size_ == room_) AddBlock();
    blocks_.back().emplace_back(std::forward<Parts>(parts)...);
    return Id<T>{size_++};
  }

  T& operator[](Id<T> id) { return In(blocks_, id.index); }
  const T& operator[](Id<T> id) const { return In(blocks_, id.index); }

  std::uint32_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  // Whether holds(value) is true for any value, without the cost of finding each by its id.
  template <typename Holds>
  bool AnyOf(Holds&& holds) const {
    for (const std::vector<T>& block : blocks_) {
      for (const T& value : block) {
        if (holds(value)) return true;
      }
    }
    return false;
  }

  // The ids from 0 to size() - 1, as a range: `for (Id<T> id : arena.ids())`.
  struct IdRange {
    struct Iterator {
      std::uint32_t index;
      Id<T> operator*() const { return Id<T>{index}; }
      Iterator& operator++() {
        ++index;
        return *this;
      }
      bool operator!=(Iterator other) const { return index != other.index; }
    };
    std::uint32_t count;
    Iterator begin() const { return {0}; }
    Iterator end() const { return {count}; }
  };
  IdRange ids() const { return {size_}; }

 private:
  void AddBlock() {
    const std::size_t count = blocks_.size() < kSmallBlocks ? kSmall : kLarge;
    if (blocks_.empty()) blocks_.reserve(kFirstBlocks);
    blocks_.emplace_back();
    blocks_.back().reserve(count);
    room_ += count;
  }

  static auto& In(auto& blocks, std::size_t index) {
    if (index < kSmallBlocks * kSmall) return blocks[index / kSmall][index % kSmall];
    index -= kSmallBlocks * kSmall;
    return blocks[kSmallBlocks + index / kLarge][index % kLarge];
  }

  // The number of values in one of the first blocks: about the nodes of one kind in a small shader,
  // which has many small nodes and a few large ones. A block of large nodes stays below the size
  // that allocators keep at hand.
  static constexpr std::size_t kSmall =
      sizeof(T) < 48 ? 64 : std::max<std::size_t>(1, std::bit_floor(1024 / sizeof(T)));
  static constexpr std::size_t kFirstBlocks = 8;  // that the list makes room for at first
  // After them come blocks of 32 KiB, so that the list of blocks of a large shader stays in cache.
  static constexpr std::size_t kSmallBlocks = 64;
  static constexpr std::size_t kLarge =
      std::max<std::size_t>(1, std::bit_floor(std::size_t{32768} / sizeof(T)));
  std::vector<std::vector<T>> blocks_;
  std::uint32_t size_ = 0;
  std::size_t room_ = 0;  // the number of values that the blocks are for
};

// A run of values in one Pool. A node holds these eight bytes instead of a vector.
template <typename T>
struct List {
  std::uint32_t begin = 0;
  std::uint32_t size = 0;
  bool empty() const { return size == 0; }
};

// The owner of the child lists of one tree. A span read from a Pool is valid until the next Add to
// that Pool.
template <typename T>
class Pool {
 public:
  // Appends a copy of `values`, which may lie in this pool.
  List<T> Add(std::span<const T> values) {
    const List<T> list{static_cast<std::uint32_t>(values_.size()),
                       static_cast<std::uint32_t>(values.size())};
    std::vector<T> old;
    if (const std::size_t size = values_.size() + values.size(); size > values_.capacity()) {
      old.reserve(std::max({size, 2 * values_.capacity(), kFirst}));
      old.insert(old.end(), values_.begin(), values_.end());
      old.swap(values_);
    }
    for (const T& value : values) values_.push_back(value);
    return list;
  }
  List<T> Add(std::initializer_list<T> values) {
    return Add(std::span<const T>(values.begin(), values.size()));
  }

  std::span<const T> operator[](List<T> list) const {
    return {values_.data() + list.begin, list.size};
  }
  std::span<T> operator[](List<T> list) { return {values_.data() + list.begin, list.size}; }

 private:
  static constexpr std::size_t kFirst = 16;  // values that the first list makes room for

  std::vector<T> values_;
};

}  // namespace clipc
