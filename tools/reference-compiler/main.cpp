// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "tools/draw/compare_flags.h"
#include "tools/draw/draw_call.h"
#include "tools/harness/options.h"
#include "tools/reference-compiler/compare.h"

using namespace clipc;
using namespace clipc::draw;

namespace {

constexpr char kUsage[] =
    R"(clipc-reference-compiler SHADER.hlsl [options]
  Compiles the shader by glslang's HLSL front end, runs it on Mesa's software Vulkan, on random
  vertices and constants, and compares every output with that of clipc's reference evaluator.
    -T -E -D -I --row-major --random --seed --ints --quarters --ulps --exact
                            as for clipc-draw compare
Exit: 0 as expected, but for known bugs of glslang, which are printed
(docs/reference-compilers.md); 1 not as expected, 2 nothing was compared.
)";

int Run(const std::vector<std::string>& arguments) {
  BuildOptions build;
  RandomOptions random;
  Tolerance tolerance;
  build.path =
      harness::options::ParseOnlyPath(arguments, ComparisonFlags(build, random, tolerance));
  build.target = "vulkan";
  build.lowering = Lowering::kNone;
  const Shader shader = Build(build);
  ChooseInstances(shader, random);
  const reference_compiler::ReferenceComparison found =
      reference_compiler::CompareWithGlslang(vulkan::Runner(), shader, build, random, tolerance);
  const Comparison& values = found.values;
  for (const std::string& mistake : values.mistakes) std::printf("  %s\n", mistake.c_str());
  std::printf("%ld values: %ld wrong, %ld of %ld equal to the bit, worst %.1f units\n",
              values.values, values.wrong, values.equal, values.values - values.undefined,
              values.worst);
  for (const std::string& bug : found.known_bugs)
    std::printf("known bug of the reference compiler: %s\n", bug.c_str());
  if (values.equal == 0 && values.wrong == 0 && found.known_bugs.empty())
    throw DrawError("nothing was compared");
  return values.wrong == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  try {
    return Run({argv, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "clipc-reference-compiler: %s\n", error.what());
    return 2;
  }
}
