// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

namespace clipc::legalize {

// The arrays of objects whose elements become objects of their own: split_arrays.h.
enum class ArraySplit : std::uint8_t { kNone, kSamplers, kAll };

// What a target needs of the legalising passes, since it lacks what is named there. A writer fills
// it for its target; a language that has all of HLSL needs nothing.
struct Needs {
  // ---- types
  bool signed_integers = false;   // no uint: uint is int; nor abs, min, max and the like of int
  bool square_matrices = false;   // others are arrays of their rows; nothing is transposed
  bool constant_loops = false;    // loops count to a constant: appendix A of GLSL ES 1.00
  bool constant_indices = false;  // of all but uniforms: the same appendix
  bool array_fields = false;      // arrays that are values are structs of a field for each element
  // ---- choices
  bool float_choices = false;    // vectors of floats are chosen component by component
  bool integer_choices = false;  // those of integers and of bool
  bool struct_choices = false;   // statements choose between structs and between arrays
  bool array_choices = false;    // ... between arrays of vectors and between matrices in rows
  // ---- functions
  bool rounding = false;       // round, trunc, modf, isnan, isinf, sinh, cosh and tanh
  bool bit_functions = false;  // countbits, reversebits, firstbithigh and firstbitlow
  bool wide_bit_numbers =
      false;  // what these but reversebits give is in a variable: they may give 16 bits
  bool half_packing = false;  // f16tof32 and f32tof16
  bool determinants = false;
  // ---- objects and indices
  bool signed_words = false;  // the least and greatest int of a word of bytes, which is a uint
  ArraySplit split_arrays = ArraySplit::kNone;
  bool flat_arrays = false;      // arrays of objects have one dimension
  bool simple_operands = false;  // operands of a sample have no choice in them
  // An index is not of a swizzle of a uniform, and one of the only element of an array is not
  // computed: Mesa 22.3's OpenGL makes mistakes there.
  bool simple_indices = false;
};

}  // namespace clipc::legalize
