// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The program's operator new and delete, for what has not an allocator of its own: strings, and
// what Clang makes.
#include "base/kept_blocks.h"

#include <cstddef>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {

bool IsPlain(std::align_val_t alignment) {
  return static_cast<std::size_t>(alignment) <= alignof(std::max_align_t);
}

}  // namespace

void* operator new(std::size_t size) { return clipc::TakeBlock(size); }

void operator delete(void* block, std::size_t size) noexcept { clipc::DropBlock(block, size); }
void operator delete(void* block) noexcept { clipc::DropBlock(block, malloc_usable_size(block)); }

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
