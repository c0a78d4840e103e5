// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/stages.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "backend-glsl/check_target.h"
#include "frontend/parse/parse.h"
#include "frontend/resolve/resolve.h"
#include "legalize/es100/unroll_loops.h"
#include "legalize/legalize.h"

namespace clipc {
namespace {

constexpr std::string_view kUnrollLoops = "unroll-loops";

}  // namespace

ast::File ReadFile(Source& source, Diagnostics& diagnostics) {
  Tokens tokens = Lex(source, diagnostics);
  return diagnostics.has_errors() ? ast::File() : Parse(std::move(tokens), diagnostics);
}

ir::Program Front(Source& source, const CheckOptions& options, Diagnostics& diagnostics,
                  const ir::PassOptions& passes, const std::function<bool(const Tokens&)>& wants) {
  if (!options.profile.stage) {  // the next errors would be about another stage's shader
    diagnostics.Report({}, diag::OtherStageProfile, options.profile.name,
                       options.profile.name.starts_with("fx_")
                           ? "`--effect` compiles the shaders of an effect"
                           : "clipc compiles no others, use dxc or glslang for them");
    return {};
  }
  Tokens tokens = Lex(source, diagnostics, options.entry);
  if (diagnostics.has_errors() || (wants && !wants(tokens))) return {};
  const int errors = diagnostics.error_count();
  const ast::File file = Parse(std::move(tokens), diagnostics, FunctionBodies::kParse,
                               {.entry_call = options.entry_call});
  return diagnostics.error_count() > errors ? ir::Program()
                                            : Check(file, options, diagnostics, passes);
}

Lowered Lower(ir::Program program, const LowerOptions& options) {
  passes::PipelineOptions pipeline = options.passes;
  pipeline.clip_planes.write_clip_vertex = options.target.Has(glsl::Feature::kClipVertex);
  pipeline.hoist_loop_bounds = options.target.Has(glsl::Feature::kFreeLoops);
  const bool is_complete = passes::RunPipeline(program, pipeline);
  glsl::Target target = options.target;
  target.flips_y = pipeline.clip_space.flip_y != pipeline.clip_space.host_flips_y;
  const legalize::Needs needs = options.needs.value_or(target.Needs());
  Lowered lowered{
      std::move(program),         std::move(target), needs, pipeline.clip_planes.lowering,
      pipeline.clip_planes.space, is_complete};
  if (is_complete) {
    lowered.long_loops = legalize::UnrollLoops(lowered.program, needs);
    lowered.is_complete =
        ir::FinishPass(lowered.program, kUnrollLoops, ir::Form::kInlined, options.passes);
  }
  return lowered;
}

std::vector<std::string_view> PassNames() {
  std::vector<std::string_view> names = resolve::ResolvePasses();
  std::ranges::copy(passes::PassNames(), std::back_inserter(names));
  names.push_back(kUnrollLoops);
  for (const auto& pass : legalize::LegalizePasses()) names.push_back(pass.name);
  return names;
}

void Legalize(Lowered& lowered, const ir::PassOptions& options) {
  lowered.is_complete = legalize::Legalize(lowered.program, lowered.needs, options);
}

void CheckTarget(const Lowered& lowered, glsl::BlockStyle blocks, Diagnostics& diagnostics) {
  glsl::CheckTarget(lowered.program, lowered.target, blocks, lowered.long_loops, diagnostics);
}

WrittenGlsl Write(const Lowered& lowered, const glsl::WriteOptions& options) {
  return glsl::WriteGlsl(lowered.program, lowered.target, options);
}

}  // namespace clipc
