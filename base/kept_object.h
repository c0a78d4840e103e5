// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>

#include "base/kept_blocks.h"

namespace clipc {

// The base of a type of which each compile makes one, with `new`: a thread keeps its memory.
struct KeptObject {
  static void* operator new(std::size_t size) { return TakeBlock(size); }
  static void operator delete(void* object, std::size_t size) { DropBlock(object, size); }
};

}  // namespace clipc
