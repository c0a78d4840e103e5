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

ProgramLayout::ProgramLayout(std::span<const LegalStage> stages) {
  for (std::size_t i = 1; i < stages.size(); ++i)
    NameInterface(stages[i - 1].program, stages[i].program, stages[i].options.names);
  std::vector<ReachedStage> reached;
  if (stages.size() > 1) {
    for (const LegalStage& stage : stages) reached.push_back({stage.program, Reach(stage.program)});
  }
  for (const LegalStage& stage : stages) {
    std::vector<OtherStage> others;
    for (const ReachedStage& other : reached) {
      if (&other.program != &stage.program)
        others.push_back(CompareStages(reached[stages_.size()], other));
    }
    stages_.push_back({stage.program, stage.known, std::move(others)});
  }
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const auto& [program, target, options, known] = stages[i];
    Stage& stage = stages_[i];
    for (std::size_t k = 0; k < i; ++k) stage.others[k].laid = &InfoOf(k);
    if (i > 0) MatchDistances(stages[i - 1].program, InfoOf(i - 1), program);
    if (known) stage.form = known->Find(program, stage.others);
    if (!stage.form)
      stage.writer = std::make_unique<StageWriter>(program, target, options, stage.others);
  }
}

const GlslInfo& ProgramLayout::InfoOf(std::size_t stage) const {
  const Stage& laid = stages_[stage];
  return laid.form ? laid.form->info : laid.writer->info();
}

std::string ProgramLayout::Write(std::size_t stage, CommentOf comment_of) {
  Stage& laid = stages_[stage];
  if (laid.form) return laid.form->text;
  std::string text = laid.writer->Finish(std::move(comment_of));
  if (laid.known) laid.known->Add(laid.program, laid.others, laid.writer->info(), text);
  return text;
}

}  // namespace clipc::glsl
