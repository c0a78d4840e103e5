// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-glsl/written_forms.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace clipc::glsl {
namespace {

// The number of forms that are kept of a stage.
constexpr std::size_t kMostForms = 8;

// Whether two descriptions of other stages agree in everything but `laid`.
bool IsSame(const OtherStage& a, const OtherStage& b) {
  return a.cbuffers == b.cbuffers && a.vars == b.vars && a.is_read == b.is_read &&
         a.has_distances == b.has_distances;
}

bool IsSame(OtherStages others, const WrittenForm& form) {
  std::size_t laid = 0;
  for (std::size_t i = 0; i < others.size(); ++i) {
    if (!IsSame(others[i], form.others[i])) return false;
    if (others[i].laid && *others[i].laid != form.laid[laid++]) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const WrittenForm> WrittenForms::Find(const ir::Program& program,
                                                      OtherStages others) const {
  const auto found = std::ranges::find_if(forms_, [&](const auto& form) {
    return others.size() == form->others.size() && program.inputs == form->inputs &&
           program.outputs == form->outputs && IsSame(others, *form);
  });
  return found == forms_.end() ? nullptr : *found;
}

void WrittenForms::Add(const ir::Program& program, OtherStages others, const GlslInfo& info,
                       std::string text) {
  if (forms_.size() == kMostForms) return;
  auto form = std::make_shared<WrittenForm>();
  form->inputs = program.inputs;
  form->outputs = program.outputs;
  for (const OtherStage& other : others) {
    if (other.laid) form->laid.push_back(*other.laid);
    form->others.push_back(other);
    form->others.back().laid = nullptr;
  }
  form->info = info;
  form->text = std::move(text);
  forms_.push_back(std::move(form));
}

}  // namespace clipc::glsl
