// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <iosfwd>
#include <vector>

// glslang's SPIR-V names these for what clipc never asks for: to optimise, check, strip and print.
// With definitions of our own, a program or a library that keeps its names to itself need not
// contain SPIRV-Tools, and starts sooner.
namespace spv {
class SpvBuildLogger;
}
namespace glslang {
class TIntermediate;
struct SpvOptions;
using Words = std::vector<unsigned>;
[[gnu::weak]] void SpirvToolsDisassemble(std::ostream&, const Words&) {}
[[gnu::weak]] void SpirvToolsStripDebugInfo(const TIntermediate&, Words&, spv::SpvBuildLogger*) {}
[[gnu::weak]] void SpirvToolsTransform(const TIntermediate&, Words&, spv::SpvBuildLogger*,
                                       const SpvOptions*) {}
[[gnu::weak]] void SpirvToolsValidate(const TIntermediate&, Words&, spv::SpvBuildLogger*, bool) {}
}  // namespace glslang
