// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "backend-glsl/glsl_info.h"
#include "backend-glsl/other_stage.h"
#include "backend-glsl/target.h"
#include "backend-glsl/write_options.h"
#include "backend-glsl/writer/stage_writer.h"
#include "backend-glsl/written_forms.h"
#include "ir/program.h"

namespace clipc::glsl {

// A stage of a program, in Form::kAddressed.
struct LegalStage {
  ir::Program& program;
  const Target& target;
  const WriteOptions& options;
  // What is known of the stage from other programs, and learns how it is written in this one; null:
  // nothing. Such a stage is written without comments.
  WrittenForms* known = nullptr;
};

// What the stages of a program declare: the names, locations, bindings and blocks of all of them,
// which are settled before any text is written. In a program one name is one variable and one
// binding one object, and what stages declare alike they share.
class ProgramLayout {
 public:
  // Lays out a program of one or more stages, in the order in which they run; they outlive the
  // layout. An input of a stage and the output of the stage before that it reads get one name,
  // IoVar::reader of both. Requires that CheckTarget reported no error.
  explicit ProgramLayout(std::span<const LegalStage> stages);

  const GlslInfo& InfoOf(std::size_t stage) const;
  // Writes a stage, each once.
  std::string Write(std::size_t stage, CommentOf comment_of = {});

 private:
  struct Stage {
    const ir::Program& program;
    WrittenForms* known;
    std::vector<OtherStage> others;  // what it must know of the others
    // One of the two: how it is written in another program, or what writes it here.
    std::shared_ptr<const WrittenForm> form = nullptr;
    std::unique_ptr<StageWriter> writer = nullptr;
  };
  std::vector<Stage> stages_;
};

}  // namespace clipc::glsl
