// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <new>
#include <span>
#include <utility>

#include "base/id.h"
#include "base/invariant.h"
#include "base/kept_blocks.h"

namespace clipc {

// The owner of all values of type T of one tree, in the order of their creation. Values lie in
// blocks of one size, so references stay valid while the arena grows and a node may be read while
// others are added.
template <typename T>
class Arena {
 public:
  Arena() = default;
  Arena(const Arena& other) {
    blocks_.reserve(other.blocks_.size());
    for (const Id<T> id : other.ids()) Make(other[id]);
  }
  Arena(Arena&& other) noexcept { Swap(other); }
  Arena& operator=(Arena other) noexcept {
    Swap(other);
    return *this;
  }
  ~Arena() {
    for (const Id<T> id : ids()) std::destroy_at(&(*this)[id]);
    for (T* const block : blocks_) KeptAllocator<T>().deallocate(block, kBlock);
  }

  Id<T> Add(T value) { return Make(std::move(value)); }

  // Makes a value in place, from its members or from the arguments of its constructor.
  template <typename... Parts>
  Id<T> Make(Parts&&... parts) {
    if (size_ == kBlock * blocks_.size()) AddBlock();
    new (blocks_.back() + size_ % kBlock) T(std::forward<Parts>(parts)...);
    return Id<T>{size_++};
  }

  T& operator[](Id<T> id) { return blocks_[id.index / kBlock][id.index % kBlock]; }
  const T& operator[](Id<T> id) const { return blocks_[id.index / kBlock][id.index % kBlock]; }

  std::uint32_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  // Whether holds(value) is true for any value, without the cost of finding each by its id.
  template <typename Holds>
  bool AnyOf(Holds&& holds) const {
    std::size_t left = size_;
    for (const T* const block : blocks_) {
      const std::size_t count = std::min(left, kBlock);
      if (std::any_of(block, block + count, holds)) return true;
      left -= count;
    }
    return false;
  }

  // Calls visit(id, value) for all values, without the cost of finding each by its id. `visit` adds
  // none.
  template <typename Visit>
  void ForEach(Visit&& visit) {
    std::uint32_t index = 0;
    for (T* const block : blocks_) {
      T* const end = block + std::min<std::size_t>(size_ - index, kBlock);
      for (T* value = block; value != end; ++value) visit(Id<T>{index++}, *value);
    }
  }
  template <typename Visit>
  void ForEach(Visit&& visit) const {
    const_cast<Arena*>(this)->ForEach([&](Id<T> id, const T& value) { visit(id, value); });
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
    if (blocks_.empty()) blocks_.reserve(kFirstBlocks);
    blocks_.push_back(KeptAllocator<T>().allocate(kBlock));
  }
  void Swap(Arena& other) {
    blocks_.swap(other.blocks_);
    std::swap(size_, other.size_);
  }

  // The number of values in a block of 2 KiB: a small shader has about as many nodes of one kind.
  static constexpr std::size_t kBlock =
      std::max<std::size_t>(1, std::bit_floor(std::size_t{2048} / sizeof(T)));
  static constexpr std::size_t kFirstBlocks = 8;  // that the list makes room for at first
  KeptVector<T*> blocks_;
  std::uint32_t size_ = 0;
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
    KeptVector<T> old;
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

  KeptVector<T> values_;
};

}  // namespace clipc
