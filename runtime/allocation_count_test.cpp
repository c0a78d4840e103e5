// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "runtime/allocation_count.h"

#include <atomic>
#include <cstdlib>
#include <new>
#include <string>

#include <gtest/gtest.h>

namespace {
std::atomic<std::size_t> g_allocations = 0;
}  // namespace

// The allocation functions of the whole test program, in all forms: a sanitizer brings its own for
// those left out. No caller may see what is inside, or g++ warns of memory that was malloc'ed and
// is deleted.
#define CLIPC_NOINLINE __attribute__((noinline))
CLIPC_NOINLINE void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++g_allocations;
  return std::malloc(size == 0 ? 1 : size);
}
CLIPC_NOINLINE void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  std::abort();
}
CLIPC_NOINLINE void* operator new[](std::size_t size) { return operator new(size); }
CLIPC_NOINLINE void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return operator new(size, std::nothrow);
}
CLIPC_NOINLINE void operator delete(void* memory) noexcept { std::free(memory); }
CLIPC_NOINLINE void operator delete[](void* memory) noexcept { std::free(memory); }
CLIPC_NOINLINE void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
CLIPC_NOINLINE void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
CLIPC_NOINLINE void operator delete(void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
CLIPC_NOINLINE void operator delete[](void* memory, const std::nothrow_t&) noexcept {
  std::free(memory);
}
#undef CLIPC_NOINLINE

namespace clipc::runtime {

std::size_t AllocationCount() { return g_allocations; }

namespace {

TEST(AllocationCount, Counts) {
  const std::size_t before = AllocationCount();
  const std::string text(100, 'x');
  EXPECT_EQ(AllocationCount(), before + 1);
}

}  // namespace
}  // namespace clipc::runtime
