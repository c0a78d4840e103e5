// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile/back_end.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "backend-glsl/discard.h"
#include "backend-glsl/program_layout.h"
#include "clip-table/write.h"
#include "compiler/compile/lower_program.h"
#include "compiler/compile/make_clip_table.h"
#include "compiler/compile/make_facts.h"
#include "compiler/compile/validate.h"
#include "compiler/compile/write_spirv.h"

namespace clipc {
namespace {

// The comment in the GLSL for a statement: "water.hlsl:12: float4 p = mul(v, m);". What GLSL's
// comments may not hold is replaced: older versions take ASCII only, and a backslash at the end
// would join the next line to the comment.
std::string SourceLine(const Source& source, Span span) {
  const TextLine& from = source.LineOf(span);
  if (from.file.empty()) return {};
  const std::size_t start = from.file.starts_with("./") ? 2 : 0;
  std::string line = fmt::format("{}:{}: {}", from.file.substr(start), from.number, from.text);
  for (char& c : line) {
    if (c < ' ' || c > '~') c = c == '\t' ? ' ' : '?';
  }
  while (line.ends_with('\\')) line.pop_back();
  return line;
}

// Lays out a lowered program, which outlives the layout. `known`, if given, has what is known of
// each shader, or null.
glsl::ProgramLayout LayOut(std::span<Job> jobs, std::vector<Lowered>& lowered,
                           std::span<const std::shared_ptr<FittedShader>> known = {}) {
  std::vector<glsl::LegalStage> stages;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    stages.push_back({lowered[i].program, lowered[i].target, jobs[i].plan.write,
                      !known.empty() && known[i] ? &known[i]->forms : nullptr});
  }
  return glsl::ProgramLayout(stages);
}

// Writes the GLSL of a shader, with the lines of the HLSL as comments if they are wanted.
std::string WriteGlsl(std::span<Job> jobs, std::size_t shader, glsl::ProgramLayout& layout,
                      bool wants_lines) {
  glsl::CommentOf comment_of;
  if (wants_lines) {
    comment_of = [&job = jobs[shader]](Span span) { return SourceLine(job.source(), span); };
  }
  return layout.Write(shader, std::move(comment_of));
}

// The shaders of a program, and what kept glslang from judging them; empty where nothing did.
struct Finished {
  std::vector<ShaderOutput> shaders;
  std::string_view unjudged;
};

// Validates the shader. Returns what keeps glslang from judging it.
std::string_view ValidateShader(Job& job, const Lowered& lowered, const std::string& glsl) {
  const Stage stage = lowered.program.stage;
  if (job.valid.Has(glsl, lowered.target, stage)) return {};
  const auto problems = Validate(glsl, lowered.target, stage);
  if (problems.empty()) job.valid.Add(glsl, lowered.target, stage);
  if (problems.empty()) return {};
  const std::string_view unknown = UnknownToValidator(glsl, lowered.target);
  if (!unknown.empty()) return unknown;
  Diagnostic& report = job.diagnostics.Report({}, diag::InvalidGlsl, problems.front());
  for (std::size_t i = 1; i < problems.size(); ++i) report.Note({}, diag::PlainNote, problems[i]);
  return {};
}

// The fragment shader of lowering kDiscard, or the include with the discard.
std::string FragmentOf(Job& job, const Lowered& lowered, const glsl::GlslInfo& info) {
  const std::optional<std::string>& given = job.request.planes.fragment;
  if (!given) return glsl::WriteDiscard(lowered.program, lowered.target, info).declarations;
  glsl::Insertion insertion = glsl::InsertDiscard(*given, lowered.program, lowered.target, info);
  if (insertion.error.empty() && job.request.outputs.validate) {
    const auto problems = Validate(insertion.text, lowered.target, Stage::kPixel);
    if (!problems.empty()) insertion.error = problems.front();
  }
  if (!insertion.error.empty()) job.diagnostics.Report({}, diag::FragmentShader, insertion.error);
  if (insertion.tests_early)
    job.diagnostics.Report({}, diag::DiscardEarlyTests, "early_fragment_tests");
  return std::move(insertion.text);
}

std::vector<std::uint32_t> ModuleOf(Job& job, const Lowered& lowered, const glsl::GlslInfo& info) {
  spirv::Written written = WriteSpirv(lowered, info, job.plan.write, *job.request.outputs.spirv,
                                      {&job.source(), job.path});
  if (!written.lacks.empty())
    job.diagnostics.Report({}, diag::InternalError,
                           fmt::format("SPIR-V is not written of {}", written.lacks));
  return std::move(written.words);
}

// Writes and validates the shaders, and adds the fragment shader's part where none of them
// discards.
Finished Finish(std::span<Job> jobs, const std::vector<Lowered>& lowered,
                glsl::ProgramLayout& layout) {
  const OutputOptions& wanted = jobs.front().request.outputs;
  Finished finished;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    ShaderOutput& shader = finished.shaders.emplace_back();
    shader.stage = lowered[i].program.stage;
    if (wanted.spirv) shader.spirv = ModuleOf(jobs[i], lowered[i], layout.InfoOf(i));
    if (!wanted.glsl) continue;
    shader.text = WriteGlsl(jobs, i, layout, wanted.source_lines);
    if (!wanted.validate) continue;
    const std::string_view unjudged = ValidateShader(jobs[i], lowered[i], shader.text);
    if (finished.unjudged.empty()) finished.unjudged = unjudged;
  }
  if (lowered.back().lowering == Lowering::kDiscard) {
    const glsl::GlslInfo& info = layout.InfoOf(jobs.size() - 1);
    finished.shaders.push_back({FragmentOf(jobs.back(), lowered.back(), info), {}, {}});
  }
  return finished;
}

// The programs for the first 0, 1 .. clip planes; `whole` is the one for all of them. The planes of
// a draw call are moved to the front, so their number alone tells the variant.
std::vector<Finished> WriteVariants(std::span<Job> jobs, const LoweredProgram& lowered,
                                    const std::vector<ShaderOutput>& whole) {
  std::vector<Finished> variants;
  const std::size_t owner = jobs.front().request.PlaneStage();
  const std::size_t planes = lowered.linked[owner].program.clip_planes.size();
  const std::size_t most = std::min<std::size_t>(planes, *jobs.front().request.planes.variants);
  for (std::size_t count = 0; count <= most && !jobs.front().diagnostics.has_errors(); ++count) {
    if (count == planes) {
      variants.push_back({whole, {}});
      break;
    }
    std::vector<Lowered> variant = LowerWithPlanes(lowered.linked, count);
    glsl::ProgramLayout layout = LayOut(jobs, variant);
    variants.push_back(Finish(jobs, variant, layout));
  }
  return variants;
}

// Describes the program in the outputs that were asked for.
void Describe(const LoweredProgram& lowered, const glsl::ProgramLayout& layout,
              const ProgramRequest& request, Outputs& outputs) {
  const std::size_t owner = request.PlaneStage();
  const bool wants_facts = request.outputs.facts;
  std::vector<DescribedStage> stages;
  for (std::size_t i = 0; i < lowered.shaders.size() && (i <= owner || wants_facts); ++i) {
    const glsl::GlslInfo& info = layout.InfoOf(i);
    stages.push_back({lowered.shaders[i], info, MakeClipTable(lowered.shaders[i], info)});
  }
  if (wants_facts) outputs.facts = MakeFacts(stages, lowered.position);
  outputs.table = std::move(stages[owner].table);
}

}  // namespace

void RunBackEnd(std::span<Job> jobs, std::vector<ir::Program> typed, CompileResult& result) {
  Job& first = jobs.front();
  const ProgramRequest& request = first.request;
  const OutputOptions& wanted = request.outputs;
  std::optional<LoweredProgram> lowered = LowerProgram(jobs, std::move(typed), result);
  if (!lowered) return;

  Outputs& outputs = result.outputs.emplace();
  if (wanted.listing) {
    glsl::ProgramLayout layout = LayOut(jobs, lowered->shaders);
    for (std::size_t i = 0; i < jobs.size(); ++i)
      outputs.listing += (i == 0 ? "" : "\n") + WriteGlsl(jobs, i, layout, true);
  }
  const bool is_plain = !wanted.source_lines;  // without comments
  glsl::ProgramLayout layout =
      is_plain ? LayOut(jobs, lowered->shaders, lowered->known) : LayOut(jobs, lowered->shaders);
  Describe(*lowered, layout, request, outputs);
  Finished finished = Finish(jobs, lowered->shaders, layout);
  std::string_view unjudged = finished.unjudged;
  outputs.shaders = std::move(finished.shaders);
  if (request.planes.variants) {
    for (Finished& variant : WriteVariants(jobs, *lowered, outputs.shaders)) {
      if (unjudged.empty()) unjudged = variant.unjudged;
      outputs.variants.push_back(std::move(variant.shaders));
    }
  }
  if (!unjudged.empty()) {
    first.diagnostics.Report({}, diag::NotValidated,
                             fmt::format("{} does not support {}", ValidatorName(), unjudged));
  }
  if (first.IsDump(DumpStage::kGlsl)) result.dump = outputs.shaders.front().text;
  if (first.IsDump(DumpStage::kTable)) {
    if (auto json = clip_table::WriteJson(*outputs.table)) result.dump = std::move(*json);
  }
}

}  // namespace clipc
