// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>

#include "ir/intrinsic.h"
#include "ir/type.h"
#include "legalize/formula.h"
#include "legalize/needs.h"
#include "legalize/shape.h"

// HLSL's functions that languages like GLSL, or older versions of them, lack, as helper functions.
namespace clipc::legalize {

struct Function {
  enum Of : std::uint8_t { kAll, kFloats, kIntegers, kInts, kUints, kRows2, kRows3, kRows4 };

  ir::Intrinsic op;
  bool Needs::* need;           // null: no target has the function
  Of of;                        // the first argument
  bool of_scalars;              // vectors are done component by component
  std::string_view parameters;  // "x y": the names, each of one word
  void (*define)(Formula& f);
  std::string_view name = {};  // of the helper function; empty: HLSL's
};

// The helper function in place of the function for a first argument of this type; null where the
// target has the function.
const Function* FindFunction(ir::Intrinsic op, const ir::Type& first, const Needs& needs);

// Whether a first argument of this type is a vector while the target's function, or the helper
// function in its place, takes scalars only.
bool IsOfScalars(ir::Intrinsic op, const ir::Type& first, const Needs& needs);

}  // namespace clipc::legalize
