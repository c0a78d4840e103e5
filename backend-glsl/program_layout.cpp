// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/program_layout.h"

#include <algorithm>
#include <utility>

#include "backend-glsl/names.h"
#include "base/invariant.h"

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
    reader.name = namer.Global(InterfaceName(input, style));
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

ProgramLayout::ProgramLayout(std::span<const LegalStage> stages) {
  const LegalStage& first = stages.front();
  if (stages.size() == 1) {
    first_.emplace(first.program, first.target, first.options);
    return;
  }
  CLIPC_CHECK(stages.size() == 2);
  const LegalStage& second = stages[1];
  NameInterface(first.program, second.program, second.options.names);
  others_[0] = CompareStages(first.program, second.program);
  others_[1] = CompareStages(second.program, first.program);
  first_.emplace(first.program, first.target, first.options, &others_[0]);
  others_[1].laid = &first_->info();
  MatchDistances(first.program, first_->info(), second.program);
  second_.emplace(second.program, second.target, second.options, &others_[1]);
}

}  // namespace clipc::glsl
