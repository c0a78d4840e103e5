// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/known_shader.h"

#include <algorithm>
#include <string>

#include "link/read.h"

namespace clipc {
namespace {

// The number of forms that are kept of a shader.
constexpr std::size_t kMostForms = 8;

StageInputs InputsOf(const ir::Program& program) {
  return {program.stage, link::ReadInputs(program, [](Span) { return std::string(); }).inputs};
}

bool IsFittedTo(const FittedShader& shader, std::size_t stages, const FittedShader* after) {
  return shader.stages == stages && shader.reader.has_value() == (after != nullptr) &&
         (!after || *shader.reader == after->inputs);
}

}  // namespace

std::shared_ptr<FittedShader> KnownShader::Find(std::size_t stages,
                                                const FittedShader* after) const {
  const auto found = std::ranges::find_if(
      fitted, [&](const auto& shader) { return IsFittedTo(*shader, stages, after); });
  return found == fitted.end() ? nullptr : *found;
}

std::shared_ptr<FittedShader> KnownShader::Add(std::size_t stages, const FittedShader* after,
                                               const Lowered& lowered,
                                               const PositionMatrices& position) {
  if (fitted.size() == kMostForms) return nullptr;
  return fitted.emplace_back(std::make_shared<FittedShader>(
      FittedShader{stages,
                   after ? std::optional(after->inputs) : std::nullopt,
                   InputsOf(lowered.program),
                   lowered,
                   position,
                   {}}));
}

}  // namespace clipc
