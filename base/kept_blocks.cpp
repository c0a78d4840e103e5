// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/kept_blocks.h"

#include <cstdint>
#include <cstdlib>
#include <new>
#include <utility>

namespace clipc {
namespace {

// A block has 24 bytes or 16 more, and so on: the sizes that malloc has blocks of.
constexpr std::size_t kStep = 16, kLeast = 24, kMost = 16384 + 8;
constexpr std::size_t kSizes = (kMost - kLeast) / kStep + 1;
// The bytes that a thread keeps, several times what one compile has at once.
constexpr std::ptrdiff_t kMostKept = CLIPC_KEEPS_BLOCKS ? std::ptrdiff_t{1} << 20 : 0;

constexpr std::size_t BytesOf(std::size_t number) { return kLeast + number * kStep; }
constexpr std::size_t NumberOf(std::size_t size) {
  return size <= kLeast ? 0 : (size - kLeast + kStep - 1) / kStep;
}

struct Block {
  Block* next;
};

// Of one thread. It has no constructor, so that finding it costs nothing.
struct KeptBlocks {
  Block* first[kSizes];  // by size
  std::ptrdiff_t room;   // the bytes that may still be kept
  bool is_begun;

  void FreeAll() {
    room = 0;
    for (Block*& block : first) {
      while (block) std::free(std::exchange(block, block->next));
    }
  }
};
constinit thread_local KeptBlocks kept = {};

#ifndef __wasm__  // which has one thread, and no functions for its end
// Frees what a thread has kept when it ends.
struct AtEndOfThread {
  bool is_made = true;
  ~AtEndOfThread() { kept.FreeAll(); }
};
thread_local AtEndOfThread at_end_of_thread;
#endif

[[gnu::noinline]] void* Allocate(std::size_t size) {
  for (;;) {
    if (void* block = std::malloc(size)) return block;
    const std::new_handler handler = std::get_new_handler();
    if (!handler) throw std::bad_alloc();
    handler();
  }
}

}  // namespace

void* TakeBlock(std::size_t size) {
  if (size > kMost) return Allocate(size);
  const std::size_t number = NumberOf(size);
  Block* const block = kept.first[number];
  if (!block) return Allocate(BytesOf(number));
  kept.first[number] = block->next;
  kept.room += static_cast<std::ptrdiff_t>(BytesOf(number));
  return block;
}

void DropBlock(void* block, std::size_t size) noexcept {
  if (!block) return;
  if (size > kMost) return std::free(block);
  const std::size_t number = NumberOf(size);
  if (kept.room < static_cast<std::ptrdiff_t>(BytesOf(number))) return std::free(block);
  kept.room -= static_cast<std::ptrdiff_t>(BytesOf(number));
  kept.first[number] = new (block) Block{kept.first[number]};
}

void KeepBlocksToTheEnd() {
  if (!std::exchange(kept.is_begun, true)) kept.room = kMostKept;
}

#ifdef __wasm__
void KeepBlocks() { KeepBlocksToTheEnd(); }
#else
void KeepBlocks() {
  if (!kept.is_begun && at_end_of_thread.is_made) KeepBlocksToTheEnd();
}
#endif

}  // namespace clipc
