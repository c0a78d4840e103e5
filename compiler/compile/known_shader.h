// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "backend-glsl/written_forms.h"
#include "base/diagnostics.h"
#include "base/stage.h"
#include "compiler/compile/count_matrices.h"
#include "compiler/compile/stages.h"
#include "ir/program.h"
#include "link/interface.h"

// A shader of an effect, which a Compiler takes through each step once and not in every pass.
namespace clipc {

// What a stage reads of the one before, which is fitted to it: all that LinkWithNext asks, if there
// are no ReadsBuiltins.
struct StageInputs {
  Stage stage = Stage::kPixel;
  std::vector<link::Input> inputs;
  friend bool operator==(const StageInputs&, const StageInputs&) = default;
};

// A shader that was fitted to what reads its outputs, and lowered without a message.
struct FittedShader {
  std::size_t stages;                 // of the program
  std::optional<StageInputs> reader;  // none: it is the last stage
  StageInputs inputs;
  Lowered lowered;
  PositionMatrices position;  // if facts are asked for, of a stage before the rasteriser
  glsl::WrittenForms forms;
};

// A shader that was checked. The requests that it is in differ in their shaders alone.
struct KnownShader {
  ir::Program program;  // Form::kResolved
  Diagnostics messages;
  std::vector<std::shared_ptr<FittedShader>> fitted;  // few

  // The shader in a program of so many stages, fitted to `after`, the stage after it, or to nothing
  // if it is null. Null if it was not lowered so.
  std::shared_ptr<FittedShader> Find(std::size_t stages, const FittedShader* after) const;
  // Remembers that it was lowered so.
  std::shared_ptr<FittedShader> Add(std::size_t stages, const FittedShader* after,
                                    const Lowered& lowered, const PositionMatrices& position);
};

}  // namespace clipc
