// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "backend-glsl/glsl_info.h"
#include "backend-glsl/other_stage.h"
#include "ir/program.h"

// One stage in several programs. The passes of an effect combine a few shaders in many ways, and
// most of them are written alike whatever they are combined with.
namespace clipc::glsl {

// A stage as it is written in a program, and all of that program which decides it.
struct WrittenForm {
  ir::IoVars inputs, outputs;      // of the stage, named by the program
  std::vector<OtherStage> others;  // `laid` is null
  std::vector<GlslInfo> laid;      // what those of `others` declare that are laid out before
  GlslInfo info;
  std::string text;
};

// The forms that a stage had so far. All programs in which it is differ in their other stages, and
// in nothing else of what the stage is written of.
class WrittenForms {
 public:
  // The form that the stage has beside these others; null if it is not known.
  std::shared_ptr<const WrittenForm> Find(const ir::Program& program, OtherStages others) const;
  void Add(const ir::Program& program, OtherStages others, const GlslInfo& info, std::string text);

 private:
  std::vector<std::shared_ptr<const WrittenForm>> forms_;  // few
};

}  // namespace clipc::glsl
