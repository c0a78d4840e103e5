// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "backend-glsl/style.h"
#include "backend-glsl/target.h"
#include "backend-glsl/write.h"
#include "base/diagnostics.h"
#include "clip-table/vocabulary.h"
#include "frontend/check/check.h"
#include "frontend/lex/source.h"
#include "frontend/lex/token.h"
#include "frontend/parse/ast.h"
#include "ir/program.h"
#include "legalize/es100/long_loop.h"
#include "legalize/needs.h"
#include "passes/pipeline.h"

// The chain that every shader takes from HLSL to GLSL. Each stage takes a value and gives a value;
// the compiler, the draw tests and whoever else compiles a shader call these and nothing below. The
// shaders of a program take it side by side: lower_program.h links them between Front and Lower.
//
//   Source --Front--> ir::Program --Lower--> Lowered --Legalize--> Lowered --Write--> WrittenGlsl
//
// The rules about what the user may ask for lie beside the chain: check_lowering.h between Front
// and Lower, CheckTarget between Lower and Legalize.
namespace clipc {

// Lexes and parses a source, which is the first half of Front. After syntax errors the file has the
// parts that could be read, and after errors of the preprocessor it is empty.
ast::File ReadFile(Source& source, Diagnostics& diagnostics);

// Returns the meaning of the shader, in Form::kResolved. The program is only meaningful when
// `diagnostics` has no errors afterwards. Every error about the shader alone is reported here.
// `passes` sees the passes that resolve objects, and may end them. `wants`, if given, sees the
// tokens; when it returns false, nothing more is done with them.
ir::Program Front(Source& source, const CheckOptions& options, Diagnostics& diagnostics,
                  const ir::PassOptions& passes = {},
                  const std::function<bool(const Tokens&)>& wants = {});

struct LowerOptions {
  glsl::Target target;
  // What the writer needs of the legalising passes; none: what the target's GLSL needs.
  std::optional<legalize::Needs> needs;
  // Lower itself decides about clip_planes.write_clip_vertex and hoist_loop_bounds, by the target.
  passes::PipelineOptions passes;
};

// A program that the target's writer can print.
struct Lowered {
  ir::Program program;
  glsl::Target target;
  legalize::Needs needs;
  Lowering lowering;
  PlaneSpace plane_space;
  bool is_complete = true;                          // no pass stopped it early
  std::vector<legalize::LongLoop> long_loops = {};  // that CheckTarget refuses
};

// Runs the passes of the clip planes, of the target's clip space and those that clear up, and
// unrolls the loops that the target lacks. Requires Form::kResolved.
Lowered Lower(ir::Program program, const LowerOptions& options);

// The names of the passes that Front, Lower and Legalize run, in their order: what `stop_after` and
// `after_pass` know.
std::vector<std::string_view> PassNames();

// Reports the parts of the program that the target cannot express. Without errors, Write succeeds,
// also for the same shader with fewer clip planes: LowerClipPlanes only adds to the shader.
void CheckTarget(const Lowered& lowered, glsl::BlockStyle blocks, Diagnostics& diagnostics);

// Runs the passes that take apart what the target's writer cannot express. Requires that
// CheckTarget reports no error. Afterwards `lowered` is complete unless `options` stopped it.
void Legalize(Lowered& lowered, const ir::PassOptions& options);

using glsl::WrittenGlsl;
// Writes the GLSL. Requires that Legalize has run to its end.
WrittenGlsl Write(const Lowered& lowered, const glsl::WriteOptions& options);

}  // namespace clipc
