// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

namespace clipc {

// The base of types that own something and so are not copied.
struct NotCopied {
  NotCopied() = default;
  NotCopied(const NotCopied&) = delete;
  NotCopied& operator=(const NotCopied&) = delete;
};

}  // namespace clipc
