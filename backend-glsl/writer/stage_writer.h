// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>

#include "backend-glsl/other_stage.h"
#include "backend-glsl/target.h"
#include "backend-glsl/writer/code.h"
#include "base/kept_object.h"
#include "ir/program.h"

namespace clipc::glsl {

// The writer of one stage, in two steps: all names and places of what the stage declares, and then
// its text. The arguments outlive it.
class StageWriter : public KeptObject {
 public:
  StageWriter(const ir::Program& program, const Target& target, const WriteOptions& options,
              OtherStages others = {});

  GlslInfo& info() { return info_; }
  const GlslInfo& info() const { return info_; }
  // Returns the whole shader. Call it once.
  std::string Finish(CommentOf comment_of);

 private:
  PackedStage packed_;
  Code code_;
  GlslInfo info_;
};

}  // namespace clipc::glsl
