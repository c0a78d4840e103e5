// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The program's operator new and delete. A compile makes and drops some hundred small blocks, and
// every further compile of a batch the same ones: each thread keeps the blocks that it drops, by
// size, for the next that asks. Every block is malloc's, which cost a seventh of a compile by
// itself: its own lists of free blocks are short, and have none of the size of a list of nodes.
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>

#include <malloc.h>

namespace {

// A block has 24 bytes or 16 more, and so on: the sizes that malloc has blocks of.
constexpr std::size_t kStep = 16, kLeast = 24, kMost = 4096 + 8;
constexpr std::size_t kSizes = (kMost - kLeast) / kStep + 1;
// The bytes that a thread keeps, several times what one compile has at once.
constexpr std::ptrdiff_t kMostKept = std::ptrdiff_t{4} << 20;

constexpr std::size_t BytesOf(std::size_t number) { return kLeast + number * kStep; }

struct Block {
  Block* next;
};

// Of one thread. It has no constructor, so that finding it costs nothing.
struct KeptBlocks {
  Block* first[kSizes];  // by size
  std::ptrdiff_t room;   // the bytes that may still be kept
  bool is_begun, is_ended;

  void FreeAll() {
    is_ended = true;
    room = 0;
    for (Block*& block : first) {
      while (block) std::free(std::exchange(block, block->next));
    }
  }
};
constinit thread_local KeptBlocks kept;

// Frees what a thread has kept when it ends.
struct AtEndOfThread {
  bool is_made = true;
  ~AtEndOfThread() { kept.FreeAll(); }
};
thread_local AtEndOfThread at_end_of_thread;

// Begins to keep blocks. The first thread ends with the process, and frees none.
bool Begin() {
  if (kept.is_begun || kept.is_ended) return false;
  static constinit std::atomic_flag has_first;
  kept.is_begun = true;
  kept.room = kMostKept;
  return !has_first.test_and_set() || at_end_of_thread.is_made;
}

[[gnu::noinline]] void* Allocate(std::size_t size) {
  for (;;) {
    if (void* block = std::malloc(size)) return block;
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
  }
}

[[gnu::noinline]] void FreeOrBegin(void* block) {
  Begin();
  std::free(block);
}

// Keeps the block, which has at least BytesOf(number) bytes.
void Keep(void* block, std::size_t number) {
  if (kept.room < static_cast<std::ptrdiff_t>(BytesOf(number))) return FreeOrBegin(block);
  kept.room -= static_cast<std::ptrdiff_t>(BytesOf(number));
  kept.first[number] = new (block) Block{kept.first[number]};
}

std::size_t NumberOf(std::size_t size) {
  return size <= kLeast ? 0 : (size - kLeast + kStep - 1) / kStep;
}

bool IsPlain(std::align_val_t alignment) {
  return static_cast<std::size_t>(alignment) <= alignof(std::max_align_t);
}

}  // namespace

void* operator new(std::size_t size) {
  if (size > kMost) return Allocate(size);
  const std::size_t number = NumberOf(size);
  Block* const block = kept.first[number];
  if (!block) return Allocate(BytesOf(number));
  kept.first[number] = block->next;
  kept.room += static_cast<std::ptrdiff_t>(BytesOf(number));
  return block;
}

void operator delete(void* block, std::size_t size) noexcept {
  if (!block) return;
  if (size > kMost) return std::free(block);
  Keep(block, NumberOf(size));
}

void operator delete(void* block) noexcept {
  if (!block) return;
  const std::size_t size = malloc_usable_size(block);
  if (size > kMost + kStep) return std::free(block);
  Keep(block, size > kMost ? kSizes - 1 : (size - kLeast) / kStep);
}

void* operator new(std::size_t size, std::align_val_t alignment) {
  if (IsPlain(alignment)) return operator new(size);
  const auto step = static_cast<std::size_t>(alignment);
  if (void* block = std::aligned_alloc(step, (size + step - 1) / step * step)) return block;
  throw std::bad_alloc();
}
void operator delete(void* block, std::align_val_t alignment) noexcept {
  IsPlain(alignment) ? operator delete(block) : std::free(block);
}
void operator delete(void* block, std::size_t size, std::align_val_t alignment) noexcept {
  IsPlain(alignment) ? operator delete(block, size) : std::free(block);
}
