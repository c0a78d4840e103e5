// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/program_layout.h"

#include <algorithm>
#include <utility>

#include "backend-glsl/names.h"

namespace clipc::glsl {

using namespace ir;

namespace {

// Names the inputs of a stage, and the outputs of the stage before that they read.
void NameInterface(Program& before, Program& after, const NameStyle& style) {
  Namer namer;
  for (IoVar& input : after.inputs) {
    if (input.builtin != Builtin::kNone) continue;
    Reader& reader = input.reader.emplace();
    reader.is_known = false;
    reader.name = namer.Global(InterfaceName(input, style, clipc::InfoOf(before.stage)));
    if (input.semantic == kClipPlaneDistance) continue;
    for (IoVar& output : before.outputs) {
      const bool is_read = output.builtin == Builtin::kNone && output.reader;
      if (is_read && output.location == input.location) output.reader->name = reader.name;
    }
  }
}

// Gives the distances for which a stage discards the names and locations that they have in the
// stage before, which declares `info`.
void MatchDistances(const Program& before, const GlslInfo& info, Program& after) {
  for (IoVar& input : after.inputs) {
    if (input.semantic != kClipPlaneDistance) continue;
    const auto output = std::ranges::find_if(before.outputs, [&](const IoVar& candidate) {
      return candidate.semantic == input.semantic && candidate.index == input.index;
    });
    const auto number = static_cast<std::size_t>(output - before.outputs.begin());
    input.location = info.outputs[number].location.value_or(input.location);
    input.reader->name = info.outputs[number].name;
  }
}

}  // namespace

ProgramLayout::ProgramLayout(std::span<const LegalStage> stages) : others_(stages.size()) {
  for (std::size_t i = 1; i < stages.size(); ++i)
    NameInterface(stages[i - 1].program, stages[i].program, stages[i].options.names);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    for (std::size_t k = 0; k < stages.size(); ++k)
      if (k != i) others_[i].push_back(CompareStages(stages[i].program, stages[k].program));
  }
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const auto& [program, target, options] = stages[i];
    for (std::size_t k = 0; k < i; ++k) others_[i][k].laid = &writers_[k]->info();
    if (i > 0) MatchDistances(stages[i - 1].program, writers_[i - 1]->info(), program);
    writers_.push_back(std::make_unique<StageWriter>(program, target, options, others_[i]));
  }
}

}  // namespace clipc::glsl
