// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/compare_flags.h"

#include <cstdio>
#include <cstdlib>

namespace clipc::draw {
namespace {

using namespace harness::options;

void SetInts(const std::string& text, RandomOptions& random) {
  if (std::sscanf(text.c_str(), "%d..%d", &random.least_int, &random.greatest_int) != 2 ||
      random.least_int > random.greatest_int) {
    throw DrawError("--ints -4..7, not `" + text + "`");
  }
}

}  // namespace

Flags ComparisonFlags(BuildOptions& build, RandomOptions& random, Tolerance& tolerance) {
  return {
      {"T", Text(build.profile)},
      {"E", Text(build.entry)},
      {"D", Append(build.defines)},
      {"I", Append(build.include_dirs)},
      {"shadow-samplers", Append(build.shadow_samplers)},
      {"row-major", {false, [&](const std::string&) { build.packing = MatrixPacking::kRowMajor; }}},
      {"random", Number(random.vertices)},
      {"seed", Number(random.seed)},
      {"ints", With([&](auto& value) { SetInts(value, random); })},
      {"quarters", On(random.quarters)},
      {"perspective", On(random.perspective)},
      {"samples", Number(random.samples)},
      {"ulps", With([&](auto& value) { tolerance.ulps = std::strtod(value.c_str(), nullptr); })},
      {"exact", {false, [&](const std::string&) { tolerance.ulps = -1; }}},
  };
}

}  // namespace clipc::draw
