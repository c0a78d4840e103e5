// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/program.h"

namespace clipc::ir {

const char* NameOf(Intrinsic op) {
  static constexpr const char* kNames[] = {
#define INTRINSIC(Enumerator, HlslName, Signature) HlslName,
#include "ir/intrinsics.def"
#undef INTRINSIC
  };
  return kNames[static_cast<std::size_t>(op)];
}

bool WritesArgument(Intrinsic op, std::size_t argument) {
  switch (op) {
    case Intrinsic::kFrexp:
    case Intrinsic::kModf: return argument == 1;
    case Intrinsic::kSincos: return argument == 1 || argument == 2;
    case Intrinsic::kAsUint: return argument > 0;
    default: return false;
  }
}

}  // namespace clipc::ir
