// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "backend-glsl/glsl_info.h"
#include "backend-glsl/other_stage.h"
#include "backend-glsl/target.h"
#include "backend-glsl/write_options.h"
#include "backend-glsl/writer/stage_writer.h"
#include "ir/program.h"

namespace clipc::glsl {

// A stage of a program, in Form::kAddressed.
struct LegalStage {
  ir::Program& program;
  const Target& target;
  const WriteOptions& options;
};

// What the stages of a program declare: the names, locations, bindings and blocks of all of them,
// which are settled before a function of one is written. In a program one name is one variable and
// one binding one object, and what two stages declare alike they share.
class ProgramLayout {
 public:
  // Lays out a program of one stage or two, which outlive the layout. An input of the second stage
  // and the output that it reads get one name, IoVar::reader of both. Requires that CheckTarget
  // reported no error.
  explicit ProgramLayout(std::span<const LegalStage> stages);
  ProgramLayout(const ProgramLayout&) = delete;
  ProgramLayout& operator=(const ProgramLayout&) = delete;

  const GlslInfo& InfoOf(std::size_t stage) const {
    return (stage == 0 ? first_ : second_)->info();
  }
  // Writes a stage, each once.
  std::string Write(std::size_t stage, CommentOf comment_of = {}) {
    return (stage == 0 ? first_ : second_)->Finish(std::move(comment_of));
  }

 private:
  // By stage. Here and not in memory of their own, as they are large.
  std::array<OtherStage, 2> others_;
  std::optional<StageWriter> first_, second_;
};

}  // namespace clipc::glsl
