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
#include "compiler/check_lowering.h"
#include "compiler/count_matrices.h"
#include "compiler/make_clip_table.h"
#include "compiler/make_facts.h"
#include "compiler/pixel_half.h"
#include "compiler/stages.h"
#include "compiler/validate.h"
#include "compiler/write_spirv.h"
#include "ir/print.h"
#include "link/whole.h"

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

// ---- from HLSL to the lowered program

LowerOptions OptionsOf(const Job& job, ir::VarId position_input, std::string& dump) {
  LowerOptions options{job.request.target, {}};
  passes::PipelineOptions& passes = options.passes;
  passes.clip_planes = {job.plan.lowering.lowering, job.plan.lowering.plane_space, position_input};
  passes.clip_space = job.request.style.clip_space;
  passes.precise_outputs = job.request.style.precise;
  static_cast<ir::PassOptions&>(passes) = PassesOf(job, dump);
  return options;
}

// Runs all passes, unless one stops them or the target cannot express the program.
Lowered LowerAndLegalize(const Job& job, ir::Program typed, const LowerOptions& options) {
  const ClipDistances distances = ClipDistancesOf(typed);
  Lowered lowered = Lower(std::move(typed), options);
  if (!lowered.is_complete) return lowered;
  ReportLeftOut(distances, lowered.program, job.diagnostics);
  CheckTarget(lowered, job.request.style.blocks, job.diagnostics);
  CheckBufferLayout(lowered.program, job.request.style.layout, job.diagnostics);
  if (!job.diagnostics.has_errors()) Legalize(lowered, options.passes);
  return lowered;
}

// The same for a program that differs from one that was checked in its clip planes only.
Lowered LowerAgain(ir::Program typed, const LowerOptions& options) {
  Lowered lowered = Lower(std::move(typed), options);
  Legalize(lowered, options.passes);
  return lowered;
}

// A program at one step of its way: the shader of the request and, of a pair, the pixel shader.
struct LoweredProgram {
  Lowered shader;
  std::optional<Lowered> pixel;
};

// Lowers the pixel shader, which in lowering kDiscard discards what so many planes clip. A first
// time it is checked for the target.
Lowered LowerPixel(const PixelHalf& half, Lowering lowering, std::size_t planes, bool is_first,
                   std::string& dump) {
  LowerOptions options = OptionsOf(half.job, {}, dump);
  if (lowering == Lowering::kDiscard) {
    options.passes.discarded_planes = planes;
    if (is_first && planes > 0) CheckDiscards(half.typed, half.job.diagnostics);
  }
  if (!is_first) options.passes.after_pass = {};
  Lowered lowered =
      is_first ? LowerAndLegalize(half.job, half.typed, options) : LowerAgain(half.typed, options);
  NameInputs(lowered.program, half.job.plan.write.names);
  return lowered;
}

// Fits the typed program to the pixel shader, which is the lowered one of a pair if that is given,
// and asks whether it fits the request. Returns the input with the position (FindPositionInput).
ir::VarId Fit(const Job& job, const PixelHalf* half, const std::optional<Lowered>& pixel,
              ir::Program& typed, std::vector<std::string>& dependencies) {
  const CompileRequest& request = job.request;
  if (job.plan.keeps_matrices_whole)
    link::KeepMatricesWhole(typed, !request.target.Has(glsl::Feature::kFullMatrices));
  if (half) {
    LinkPair(request, *pixel, half->job, typed, job.diagnostics);
  } else if (request.link.has_pixel_shader()) {
    LinkPixelShader(request, job.plan.input, typed, dependencies, job.diagnostics);
  }
  if (job.diagnostics.has_errors()) return {};
  const ir::VarId position_input = FindPositionInput(typed, job.plan.lowering, job.diagnostics);
  if (!request.planes.given_to_device && !request.debug.changes_result())
    CheckPlanesAreKept(typed, job.plan.lowering, request.target, job.diagnostics);
  return position_input;
}

// ---- from the lowered program to the outputs

struct WrittenProgram {
  WrittenGlsl shader;
  std::optional<WrittenGlsl> pixel;
};

// The options of a job's writer. With `lines`, the GLSL has those of the HLSL as comments.
glsl::WriteOptions WriteOptionsOf(const Job& job, bool lines) {
  glsl::WriteOptions options = job.plan.write;
  if (lines) options.comment_of = [&](Span span) { return SourceLine(job.source, span); };
  return options;
}

// Writes the program. The pixel shader gets the names and places that are left after the other.
WrittenProgram WriteProgram(const Job& job, const PixelHalf* half, LoweredProgram& lowered,
                            bool lines) {
  glsl::WriteOptions options = WriteOptionsOf(job, lines);
  if (!half) return {Write(lowered.shader, options), {}};
  const glsl::OtherStage pixel =
      glsl::CompareStages(lowered.shader.program, lowered.pixel->program);
  glsl::OtherStage vertex = glsl::CompareStages(lowered.pixel->program, lowered.shader.program);
  options.other = &pixel;
  WrittenProgram written{Write(lowered.shader, options), {}};
  vertex.written = &written.shader.info;
  glsl::WriteOptions pixel_options = WriteOptionsOf(half->job, lines);
  pixel_options.other = &vertex;
  PlaceDistances(lowered.shader.program, written.shader.info, lowered.pixel->program);
  written.pixel = Write(*lowered.pixel, pixel_options);
  return written;
}

// The shaders of a program, and what kept glslang from judging them; empty where nothing did.
struct Finished {
  std::vector<ShaderOutput> shaders;
  std::string_view unjudged;
};

// Validates the shader. Returns what keeps glslang from judging it.
std::string_view ValidateShader(const Job& job, const Lowered& lowered,
                                const WrittenGlsl& written) {
  const Stage stage = lowered.program.stage;
  if (job.valid.Has(written.glsl, lowered.target, stage)) return {};
  const auto problems = Validate(written.glsl, lowered.target, stage);
  if (problems.empty()) job.valid.Add(written.glsl, lowered.target, stage);
  if (problems.empty()) return {};
  const std::string_view unknown = UnknownToValidator(written.glsl, lowered.target);
  if (!unknown.empty()) return unknown;
  Diagnostic& report = job.diagnostics.Report({}, diag::InvalidGlsl, problems.front());
  for (std::size_t i = 1; i < problems.size(); ++i) report.Note({}, diag::PlainNote, problems[i]);
  return {};
}

// The fragment shader of lowering kDiscard, or the include with the discard.
std::string FragmentOf(const Job& job, const Lowered& lowered, const glsl::GlslInfo& info) {
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

// Adds the fragment shader's part where the program has no pixel shader, and validates both.
Finished Finish(const Job& job, const PixelHalf* half, const LoweredProgram& lowered,
                WrittenProgram written) {
  Finished finished;
  const bool validates = job.request.outputs.validate;
  if (validates) finished.unjudged = ValidateShader(job, lowered.shader, written.shader);
  finished.shaders.push_back({std::move(written.shader.glsl), {}});
  if (half) {
    const std::string_view unjudged =
        validates ? ValidateShader(half->job, *lowered.pixel, *written.pixel) : "";
    if (finished.unjudged.empty()) finished.unjudged = unjudged;
    finished.shaders.push_back({std::move(written.pixel->glsl), {}});
  } else if (lowered.shader.lowering == Lowering::kDiscard) {
    finished.shaders.push_back({FragmentOf(job, lowered.shader, written.shader.info), {}});
  }
  return finished;
}

// The shaders for the first 0, 1 .. clip planes of `typed`; `whole` is the one for all of them. The
// planes of a draw call are moved to the front, so their number alone tells the variant.
std::vector<Finished> WriteVariants(const Job& job, const PixelHalf* half, const ir::Program& typed,
                                    LowerOptions options, const std::vector<ShaderOutput>& whole) {
  std::vector<Finished> variants;
  options.passes.after_pass = {};
  const std::size_t planes = typed.clip_planes.size();
  const std::size_t most = std::min<std::size_t>(planes, *job.request.planes.variants);
  for (std::size_t count = 0; count <= most && !job.diagnostics.has_errors(); ++count) {
    if (count == planes) {
      variants.push_back({whole, {}});
      break;
    }
    ir::Program program = typed;
    program.clip_planes.resize(count);
    LoweredProgram lowered{LowerAgain(std::move(program), options), {}};
    std::string no_dump;
    if (half) lowered.pixel = LowerPixel(*half, lowered.shader.lowering, count, false, no_dump);
    WrittenProgram written = WriteProgram(job, half, lowered, job.request.outputs.source_lines);
    variants.push_back(Finish(job, half, lowered, std::move(written)));
  }
  return variants;
}

// Writes the SPIR-V of a shader; where the writer lacks something, glslang translates its GLSL.
std::vector<std::uint32_t> SpirvOf(const Job& job, const Lowered& lowered,
                                   const WrittenGlsl& written) {
  const CompileRequest& request = job.request;
  const SpirvRequest& wanted = *request.outputs.spirv;
  if (request.target.IsVulkan()) {
    spirv::Written own = WriteSpirv(lowered.program, written.info, job.plan.write, wanted);
    if (!own.words.empty()) return std::move(own.words);
  }
  // The name has no folder, so that it does not matter where a shader is compiled.
  const Stage stage = lowered.program.stage;
  const std::string name =
      fmt::format("{}{}", request.path.substr(NameBegin(request.path)), InfoOf(stage).extension);
  Spirv spirv = MakeSpirv(written.glsl, request.target, stage, wanted, name);
  for (const std::string& problem : spirv.problems)
    job.diagnostics.Report({}, diag::NoSpirv, problem);
  return std::move(spirv.words);
}

// Describes the written program in the outputs that were asked for.
void Describe(const Job& job, const LoweredProgram& lowered, const WrittenProgram& written,
              const PositionMatrices& position, Outputs& outputs) {
  outputs.table = MakeClipTable(lowered.shader, written.shader.info);
  const DescribedStage shader{lowered.shader, written.shader.info, *outputs.table};
  std::optional<clip_table::ClipTable> no_planes;
  std::optional<DescribedStage> pixel;
  if (lowered.pixel) {
    no_planes = MakeClipTable(*lowered.pixel, written.pixel->info);
    pixel.emplace(DescribedStage{*lowered.pixel, written.pixel->info, *no_planes});
  }
  if (job.request.outputs.facts)
    outputs.facts = MakeFacts(shader, position, pixel ? &*pixel : nullptr);
}

}  // namespace

ir::PassOptions PassesOf(const Job& job, std::string& dump) {
  const DebugOptions& debug = job.request.debug;
  return {debug.stop_after, debug.verify,
          [&job, &dump](std::string_view pass, const ir::Program& after) {
            if (job.watch && job.watch->AskNow()) return false;
            const auto& wanted = job.request.debug.dump_after;
            if (std::ranges::find(wanted, pass) == wanted.end()) return true;
            if (wanted.size() > 1) dump += fmt::format("// after {}\n", pass);
            dump += ir::Print(after);
            return true;
          }};
}

void RunBackEnd(const Job& job, const PixelHalf* half, ir::Program typed, CompileResult& result) {
  const OutputOptions& wanted = job.request.outputs;
  std::optional<Lowered> pixel;
  if (half) {
    pixel =
        LowerPixel(*half, job.plan.lowering.lowering, typed.clip_planes.size(), true, result.dump);
    if (half->job.diagnostics.has_errors() || job.IsStopped()) return;
  }
  const std::size_t outputs_written = typed.outputs.size();
  const ir::VarId position_input = Fit(job, half, pixel, typed, result.dependencies);
  if (job.diagnostics.has_errors()) return;
  const PositionMatrices position = wanted.facts ? FollowPosition(typed) : PositionMatrices{};
  const ir::Program kept = job.request.planes.variants ? typed : ir::Program();
  LowerOptions options = OptionsOf(job, position_input, result.dump);
  options.passes.drops_unneeded = half && typed.outputs.size() < outputs_written;
  LoweredProgram lowered{LowerAndLegalize(job, std::move(typed), options), std::move(pixel)};
  if (job.diagnostics.has_errors() || job.IsStopped()) return;
  if (!lowered.shader.is_complete) {
    if (job.request.debug.dump_after.empty()) result.dump = ir::Print(lowered.shader.program);
    return;
  }

  Outputs& outputs = result.outputs.emplace();
  if (wanted.listing) {
    const WrittenProgram listed = WriteProgram(job, half, lowered, true);
    outputs.listing = listed.shader.glsl + (listed.pixel ? "\n" + listed.pixel->glsl : "");
  }
  WrittenProgram written = WriteProgram(job, half, lowered, job.request.outputs.source_lines);
  Describe(job, lowered, written, position, outputs);
  std::vector<std::vector<std::uint32_t>> spirv;
  if (wanted.spirv) {
    spirv.push_back(SpirvOf(job, lowered.shader, written.shader));
    if (half) spirv.push_back(SpirvOf(half->job, *lowered.pixel, *written.pixel));
  }
  Finished finished = Finish(job, half, lowered, std::move(written));
  std::string_view unjudged = finished.unjudged;
  outputs.shaders = std::move(finished.shaders);
  for (std::size_t i = 0; i < spirv.size(); ++i) outputs.shaders[i].spirv = std::move(spirv[i]);
  if (job.request.planes.variants) {
    for (Finished& variant : WriteVariants(job, half, kept, options, outputs.shaders)) {
      if (unjudged.empty()) unjudged = variant.unjudged;
      outputs.variants.push_back(std::move(variant.shaders));
    }
  }
  if (!unjudged.empty()) {
    job.diagnostics.Report({}, diag::NotValidated,
                           fmt::format("{} does not support {}", ValidatorName(), unjudged));
  }
  if (job.IsDump(DumpStage::kGlsl)) result.dump = outputs.shaders.front().text;
  if (job.IsDump(DumpStage::kTable)) {
    if (auto json = clip_table::WriteJson(*outputs.table)) result.dump = std::move(*json);
  }
}

}  // namespace clipc
