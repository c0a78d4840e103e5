// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/draw/build.h"
#include "tools/draw/random_inputs.h"
#include "tools/draw/reference.h"

namespace clipc::draw {

// The distance that a driver's values may have from the evaluator's. Ints must be equal. A float
// must equal the evaluator's float, or lie within ulps * 2^-24 * max(|expected|, the largest
// |expected| of the output among all vertices) of its double; or, where the shader loses more than
// that by cancelling, within `roundings` times the evaluator's own difference between float and
// double: another order of the same operations errs by as much, another formula by more.
//
// Measured on Mesa 22.3.6's llvmpipe: + - * / sqrt and rcp round as IEEE, nothing is fused, and mat
// * vec adds from left to right, so most shaders match bit for bit. dot and vec * mat add from the
// right, which is off by up to 4 units of the sum of the products' sizes; exp2 by 4, pow by 18,
// normalize by 4 units. The default leaves room for a chain of those (the worst seen in
// testdata/draw is 14, a pow of an abs; tools/bench/compare_corpus.py lists the shaders that take
// more); any mistake in what is computed is larger by orders of magnitude on random inputs.
struct Tolerance {
  double ulps = 32;
  double roundings = 8;
};

// The outputs of a shader on one draw call, and what they must be.
struct Trial {
  const Shader& shader;
  const std::vector<Expected>& expected;
  const RandomInputs& inputs;
  const RandomOptions& draw;
  Tolerance tolerance;
};

struct Comparison {
  long values = 0;                    // components compared
  long equal = 0;                     // components equal to the bit, or both zero
  long undefined = 0;                 // components that are NaN, or that HLSL leaves undefined
  double worst = 0;                   // the largest error, in units of 2^-24 of the output's size
  std::vector<std::string> mistakes;  // the first wrong values, in words

  long wrong = 0;
  long missing = 0;  // wrong values of outputs that are not written
};

// The outputs that have a defined value at some vertex: others may not be written, and so cannot be
// captured.
std::vector<const Expected*> Defined(const std::vector<Expected>& expected);

std::vector<std::string> NamesOf(const std::vector<const Expected*>& outputs);

// The captured values of each expected output, found by its name.
std::vector<Captured> Chosen(const std::vector<Captured>& captured,
                             const std::vector<const Expected*>& expected);

// Compares each captured output with the expected one of the same index.
Comparison CompareOutputs(const std::vector<const Expected*>& expected,
                          const std::vector<Captured>& captured, const Tolerance& tolerance);

}  // namespace clipc::draw
