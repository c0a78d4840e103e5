// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>

#include "ir/evaluate.h"
#include "ir/scalar.h"
#include "ir/type.h"
#include "tools/harness/random.h"

namespace clipc::draw {

// The options of one run of a shader.
struct RandomOptions {
  std::uint32_t seed = 1;
  int vertices = 64;
  int instances = 1;
  int first_vertex = 0, base_instance = 0;  // the start of the draw call
  bool constant_textures = false;           // all texels of a sampled texture are equal
  int least_int = -4, greatest_int = 7;     // small, as ints are loop counts and array indices
  // Floats are multiples of 1/4 in [-4, 4], so that short sums and products of them are exact.
  bool quarters = false;
  // Of a pixel shader: w changes from pixel to pixel, so that inputs are not exact.
  bool perspective = false;
  // Of a pixel shader: the samples of a pixel, of which the image is resolved.
  int samples = 1;
};

// A source of random values. Equal seeds give equal values on every machine. Floats lie in [-2, 2],
// one in four is a whole number, so that comparisons and exact zeros occur, and no result is large
// enough to hide the errors of another.
class RandomValues {
 public:
  explicit RandomValues(const RandomOptions& options) : options_(options), random_(options.seed) {}

  // The bits of a value as ir::Literal holds them.
  std::uint64_t Next(ir::Scalar kind);
  // A random number in [0, limit).
  std::uint32_t Below(std::uint32_t limit) { return random_.Below(limit); }

 private:
  int Int(int least);
  float Float();

  RandomOptions options_;
  harness::Random random_;
};

// The bits of a component that a request reads and that is undefined: 0 where `undefined` is 0,
// else another value for every request, component and `undefined`. The values are not multiples of
// each other, so that a sum of some is not 0 every time, as if it were known.
std::uint64_t UndefinedBits(const ir::ObjectRequest& request, double undefined, ir::Scalar kind,
                            std::size_t component);

}  // namespace clipc::draw
