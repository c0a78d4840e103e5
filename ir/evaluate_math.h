// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <span>

#include "ir/program.h"

// The operations of the evaluator on single components and on vectors, without any state. `rep`
// says how components lie in their words: a base kind, where a float of the shader is kFloat, or
// kDouble when the evaluator computes in double.
namespace clipc::ir {

using Word = std::uint64_t;

Word BinaryComponent(BinaryOp op, Scalar rep, Word left, Word right);
// Applies a unary operator to one component. Increments and decrements give the new value.
Word UnaryComponent(UnaryOp op, Scalar rep, Word operand);

// One component of the result of an intrinsic of category kComponents.
Word ComponentFunction(Intrinsic op, Scalar rep, Word x, Word y, Word z);

struct EvalArgument {
  const Word* words = nullptr;
  const Type* type = nullptr;
};
// Fills in the components of `result` for mul, dot, cross, transpose and the other intrinsics of
// category kVectors.
void VectorFunction(Intrinsic op, Scalar rep, std::span<const EvalArgument> arguments,
                    Word* result);

// The same for dot4add_u8packed and the other intrinsics of bytes packed into a uint; returns false
// for other intrinsics.
bool PackedFunction(Intrinsic op, std::span<const EvalArgument> arguments, Word* result);

// pow(x, y), which the vector function lit uses too.
template <typename T>
T PowOf(T x, T y);

}  // namespace clipc::ir
