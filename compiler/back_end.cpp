// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/back_end.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "backend-glsl/discard.h"
#include "backend-glsl/other_stage.h"
#include "base/path.h"
#include "clip-table/write.h"
#include "compiler/lower_program.h"
#include "compiler/make_clip_table.h"
#include "compiler/make_facts.h"
#include "compiler/validate.h"
#include "compiler/write_spirv.h"

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

// The options of a job's writer. With `lines`, the GLSL has those of the HLSL as comments.
glsl::WriteOptions WriteOptionsOf(Job& job, bool lines) {
  glsl::WriteOptions options = job.plan.write;
  if (lines) options.comment_of = [&](Span span) { return SourceLine(job.source(), span); };
  return options;
}

// Gives the distances that a pixel shader discards by the names and locations that they have in the
// stage before, which was written with `info`.
void PlaceDistances(const ir::Program& before, const glsl::GlslInfo& info, ir::Program& pixel) {
  for (ir::IoVar& input : pixel.inputs) {
    if (input.semantic != ir::kClipPlaneDistance) continue;
    const auto output = std::ranges::find_if(before.outputs, [&](const ir::IoVar& candidate) {
      return candidate.semantic == input.semantic && candidate.index == input.index;
    });
    const auto number = static_cast<std::size_t>(output - before.outputs.begin());
    input.location = info.outputs[number].location.value_or(input.location);
    input.reader->name = info.outputs[number].name;
  }
}

// Writes the shaders of a program. The second one gets the names and places that the first one
// leaves.
std::vector<WrittenGlsl> WriteProgram(std::span<Job> jobs, std::vector<Lowered>& lowered,
                                      bool lines) {
  std::vector<WrittenGlsl> written;
  glsl::WriteOptions options = WriteOptionsOf(jobs[0], lines);
  if (jobs.size() == 1) {
    written.push_back(Write(lowered[0], options));
    return written;
  }
  const glsl::OtherStage second = glsl::CompareStages(lowered[0].program, lowered[1].program);
  glsl::OtherStage first = glsl::CompareStages(lowered[1].program, lowered[0].program);
  options.other = &second;
  written.push_back(Write(lowered[0], options));
  first.written = &written[0].info;
  options = WriteOptionsOf(jobs[1], lines);
  options.other = &first;
  PlaceDistances(lowered[0].program, written[0].info, lowered[1].program);
  written.push_back(Write(lowered[1], options));
  return written;
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
  return std::move(insertion.text);
}

// Validates the shaders, and adds the fragment shader's part where none of them discards.
Finished Finish(std::span<Job> jobs, const std::vector<Lowered>& lowered,
                std::vector<WrittenGlsl> written) {
  Finished finished;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const std::string_view unjudged = jobs[i].request.outputs.validate
                                          ? ValidateShader(jobs[i], lowered[i], written[i].glsl)
                                          : "";
    if (finished.unjudged.empty()) finished.unjudged = unjudged;
    finished.shaders.push_back({std::move(written[i].glsl), {}});
  }
  if (lowered.back().lowering == Lowering::kDiscard)
    finished.shaders.push_back({FragmentOf(jobs.back(), lowered.back(), written.back().info), {}});
  return finished;
}

// The programs for the first 0, 1 .. clip planes; `whole` is the one for all of them. The planes of
// a draw call are moved to the front, so their number alone tells the variant.
std::vector<Finished> WriteVariants(std::span<Job> jobs, const LoweredProgram& lowered,
                                    const std::vector<ShaderOutput>& whole) {
  const ProgramRequest& request = jobs.front().request;
  std::vector<Finished> variants;
  const std::size_t planes = lowered.linked.front().program.clip_planes.size();
  const std::size_t most = std::min<std::size_t>(planes, *request.planes.variants);
  for (std::size_t count = 0; count <= most && !jobs.front().diagnostics.has_errors(); ++count) {
    if (count == planes) {
      variants.push_back({whole, {}});
      break;
    }
    std::vector<Lowered> variant = LowerWithPlanes(jobs, lowered.linked, count);
    std::vector<WrittenGlsl> written = WriteProgram(jobs, variant, request.outputs.source_lines);
    variants.push_back(Finish(jobs, variant, std::move(written)));
  }
  return variants;
}

// Writes the SPIR-V of a shader; where the writer lacks something, glslang translates its GLSL.
std::vector<std::uint32_t> SpirvOf(Job& job, const Lowered& lowered, const WrittenGlsl& written) {
  const ProgramRequest& request = job.request;
  const SpirvRequest& wanted = *request.outputs.spirv;
  if (request.target.IsVulkan()) {
    spirv::Written own = WriteSpirv(lowered.program, written.info, job.plan.write, wanted);
    if (!own.words.empty()) return std::move(own.words);
  }
  // The name has no folder, so that it does not matter where a shader is compiled.
  const Stage stage = lowered.program.stage;
  const std::string name =
      fmt::format("{}{}", job.path.substr(NameBegin(job.path)), InfoOf(stage).extension);
  Spirv spirv = MakeSpirv(written.glsl, request.target, stage, wanted, name);
  for (const std::string& problem : spirv.problems)
    job.diagnostics.Report({}, diag::NoSpirv, problem);
  return std::move(spirv.words);
}

// Describes the written program in the outputs that were asked for.
void Describe(const LoweredProgram& lowered, const std::vector<WrittenGlsl>& written,
              bool wants_facts, Outputs& outputs) {
  std::vector<DescribedStage> stages;
  for (std::size_t i = 0; i < written.size() && (i == 0 || wants_facts); ++i) {
    stages.push_back(
        {lowered.shaders[i], written[i].info, MakeClipTable(lowered.shaders[i], written[i].info)});
  }
  if (wants_facts) outputs.facts = MakeFacts(stages, lowered.position);
  outputs.table = std::move(stages.front().table);
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
    for (const WrittenGlsl& listed : WriteProgram(jobs, lowered->shaders, true))
      outputs.listing += (outputs.listing.empty() ? "" : "\n") + listed.glsl;
  }
  std::vector<WrittenGlsl> written = WriteProgram(jobs, lowered->shaders, wanted.source_lines);
  Describe(*lowered, written, wanted.facts, outputs);
  std::vector<std::vector<std::uint32_t>> spirv;
  for (std::size_t i = 0; wanted.spirv && i < jobs.size(); ++i)
    spirv.push_back(SpirvOf(jobs[i], lowered->shaders[i], written[i]));
  Finished finished = Finish(jobs, lowered->shaders, std::move(written));
  std::string_view unjudged = finished.unjudged;
  outputs.shaders = std::move(finished.shaders);
  for (std::size_t i = 0; i < spirv.size(); ++i) outputs.shaders[i].spirv = std::move(spirv[i]);
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
