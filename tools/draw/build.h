// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "backend-glsl/write.h"
#include "base/not_copied.h"
#include "frontend/check/check.h"
#include "frontend/lex/source.h"
#include "frontend/lex/token.h"
#include "ir/program.h"
#include "passes/pipeline.h"
#include "tools/draw/inputs.h"

namespace clipc::draw {

struct BuildOptions {
  std::string path;
  std::string profile = "vs_5_0", entry = "main";
  std::vector<std::string> defines, include_dirs, shadow_samplers;
  LanguageVersion language = LanguageVersion::k2021;
  MatrixPacking packing = MatrixPacking::kColumnMajor;
  std::string target = "glsl450";
  Lowering lowering = Lowering::kClipDistance;
  PlaneSpace plane_space = PlaneSpace::kClip;
  std::string position_input = "POSITION0";  // with plane space kObject
  passes::ClipSpaceOptions clip_space;
};

// One shader at three stages.
struct Shader {
  ir::Program typed;    // the checked program, before any pass
  ir::Program lowered;  // the program after the passes
  std::string glsl;
  GlslInfo info;                     // beside `lowered`
  std::vector<std::uint32_t> spirv;  // of clipc's writer; empty where the target has none
  // Whether the target has no uint, so that values from 2^31 on are negative there, as clipc warns.
  bool has_int_for_uint = false;
  bool flips_y = false;  // compiled with --flip-y
};

// A shader that is read and checked once, and then built for one target after another.
class CheckedShader : NotCopied {
 public:
  // Reads and checks the shader of `options`, whose target does not matter. Throws DrawError with
  // the diagnostics.
  explicit CheckedShader(const BuildOptions& options);
  ~CheckedShader();

  const ir::Program& typed() const;

  // Runs the rest of the compiler's stages (compiler/compile/stages.h). Throws NotForTarget when
  // only the target is at fault.
  Shader BuildFor(const std::string& target) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

// Builds the shader of these options for their one target.
Shader Build(const BuildOptions& options);

// The shader's tokens after the preprocessor. Throws DrawError with the diagnostics.
Tokens Preprocess(const BuildOptions& options);

// Returns the value of a name that was parsed. Throws DrawError if the name is not of that kind,
// such as "plane space".
template <typename T>
T Known(std::optional<T> parsed, const char* kind, const std::string& name) {
  if (!parsed) throw DrawError("no " + std::string(kind) + " is called `" + name + "`");
  return std::move(*parsed);
}

// The error of a shader that the target cannot express, with the compiler's report. Such a shader
// cannot be compared on that target.
class NotForTarget : public DrawError {
 public:
  using DrawError::DrawError;
};

// The shader changed for Mesa's OpenGL: llvmpipe of Mesa 22.3 stops at version 450, where draw
// parameters are an extension.
std::string ForOpenGl(const std::string& glsl);

}  // namespace clipc::draw
