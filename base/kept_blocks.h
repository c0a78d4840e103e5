// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace clipc {

// Blocks of memory that a thread keeps when it drops them, by size, for the next that asks. A
// compile makes and drops some hundred small blocks, and every further compile the same ones: as
// malloc's they cost a seventh of a compile, since its own lists of free blocks are short, and have
// none of the size of a list of nodes. A block may be dropped by another thread.

// Returns a block of malloc's for `size` bytes. Throws std::bad_alloc if there is no memory.
[[nodiscard]] void* TakeBlock(std::size_t size);
// Drops a block that was taken with this size; null is not a block.
void DropBlock(void* block, std::size_t size) noexcept;
// From here on the calling thread keeps at most a mebibyte of the blocks that it drops, and frees
// them when it ends. Does nothing the second time, and in debug and sanitized builds, which watch
// each block.
void KeepBlocks();
// The same for a thread that ends with the process, and so frees none.
void KeepBlocksToTheEnd();

// An allocator for the containers of a compile.
template <typename T>
struct KeptAllocator {
  using value_type = T;

  KeptAllocator() = default;
  template <typename Other>
  KeptAllocator(const KeptAllocator<Other>&) {}  // NOLINT(google-explicit-constructor): converts

  [[nodiscard]] T* allocate(std::size_t count) {
    static_assert(alignof(T) <= alignof(std::max_align_t));
    return static_cast<T*>(TakeBlock(count * sizeof(T)));
  }
  void deallocate(T* block, std::size_t count) { DropBlock(block, count * sizeof(T)); }

  template <typename Other>
  bool operator==(const KeptAllocator<Other>&) const {
    return true;
  }
};

template <typename T>
using KeptVector = std::vector<T, KeptAllocator<T>>;
template <typename Key, typename T>
using KeptMap = std::unordered_map<Key, T, std::hash<Key>, std::equal_to<Key>,
                                   KeptAllocator<std::pair<const Key, T>>>;

}  // namespace clipc
