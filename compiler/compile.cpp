// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <new>
#include <utility>

#include <fmt/format.h>

#include "backend-glsl/discard.h"
#include "base/path.h"
#include "clip-table/write.h"
#include "compiler/check_lowering.h"
#include "compiler/count_matrices.h"
#include "compiler/dump_tokens.h"
#include "compiler/make_clip_table.h"
#include "compiler/pixel_half.h"
#include "compiler/plan.h"
#include "compiler/reflect.h"
#include "compiler/rewrite_hlsl.h"
#include "compiler/stages.h"
#include "compiler/structs.h"
#include "compiler/validate.h"
#include "frontend/parse/ast_print.h"
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

// The reasons to end a compile before its result: the limit of its time, and its caller.
class Stop {
 public:
  explicit Stop(const Limits& limits) : limits_(limits) {
    if (limits.seconds != Limits().seconds)
      deadline_ = Clock::now() + std::chrono::seconds(limits.seconds);
  }

  // The watch that the stages ask; null if nothing can stop the compile.
  Watch* watch() { return deadline_ || limits_.is_cancelled ? &watch_ : nullptr; }

  // Reports why the compile was stopped, if it was. Returns the status that it has then.
  Status Report(Diagnostics& diagnostics) const {
    if (watch_.stopped() && is_cancelled_) {
      diagnostics.Report({}, diag::Cancelled);
      return Status::kCancelled;
    }
    if (watch_.stopped()) diagnostics.Report({}, diag::TimeLimit, limits_.seconds);
    return Status::kOk;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool MustStop() {
    is_cancelled_ = limits_.is_cancelled && limits_.is_cancelled();
    return is_cancelled_ || (deadline_ && Clock::now() >= *deadline_);
  }

  const Limits& limits_;
  std::optional<Clock::time_point> deadline_;
  bool is_cancelled_ = false;
  Watch watch_{[this] { return MustStop(); }};
};

// A plan that runs: what every step of it asks.
struct Job {
  const CompileRequest& request;
  const Plan& plan;
  Source& source;
  Diagnostics& diagnostics;
  Watch* watch;

  bool IsDump(DumpStage stage) const { return request.debug.dump == stage; }
  bool IsStopped() const { return watch && watch->stopped(); }
};

// ---- from HLSL to the lowered program

// The settings of the passes, which append the programs that the request wants to see to `dump`.
LowerSettings SettingsOf(const Job& job, ir::VarId position_input, std::string& dump) {
  LowerSettings settings{job.request.target, {}};
  passes::PipelineOptions& passes = settings.passes;
  passes.clip_planes = {job.plan.lowering.lowering, job.plan.lowering.plane_space, position_input};
  passes.clip_space = job.request.style.clip_space;
  passes.precise_outputs = job.request.style.precise;
  passes.stop_after = job.request.debug.stop_after;
  passes.verify = job.request.debug.verify;
  passes.after_pass = [&job, &dump](std::string_view pass, const ir::Program& after) {
    if (job.watch && job.watch->AskNow()) return false;
    const auto& wanted = job.request.debug.dump_after;
    if (std::ranges::find(wanted, pass) == wanted.end()) return true;
    if (wanted.size() > 1) dump += fmt::format("// after {}\n", pass);
    dump += ir::Print(after);
    return true;
  };
  return settings;
}

// Fits the typed program to the pixel shader and asks whether it fits the request. Returns the
// input with the position, as CheckLowering does.
ir::VarId Fit(const Job& job, ir::Program& typed, std::vector<std::string>& dependencies) {
  const CompileRequest& request = job.request;
  if (job.plan.keeps_matrices_whole) link::KeepMatricesWhole(typed);
  if (request.link.has_pixel_shader())
    LinkPixelShader(request, job.plan.input, typed, dependencies, job.diagnostics);
  if (job.diagnostics.has_errors()) return {};
  const ir::VarId position_input = CheckLowering(typed, job.plan.lowering, job.diagnostics);
  if (!request.planes.given_to_device && !request.debug.changes_result())
    CheckPlanesAreKept(typed, job.plan.lowering, request.target, job.diagnostics);
  return position_input;
}

// Runs all passes, unless one stops them or the target cannot express the program.
Lowered LowerAndLegalize(const Job& job, ir::Program typed, const LowerSettings& settings) {
  const ClipDistances distances = ClipDistancesOf(typed);
  Lowered lowered = Lower(std::move(typed), settings);
  if (!lowered.is_complete) return lowered;
  ReportLeftOut(distances, lowered.program, job.diagnostics);
  CheckTarget(lowered, job.request.style.blocks, job.diagnostics);
  if (!job.diagnostics.has_errors()) Legalize(lowered, settings.passes);
  return lowered;
}

// ---- from the lowered program to the outputs

// What is in the GLSL that glslang does not support; empty if it can judge the GLSL.
std::string_view UnknownToValidator(const Lowered& lowered, const glsl::GlslInfo& info) {
  // docs/language.md, "GLSL that glslang refuses".
  if (lowered.target.IsEs() && info.clip_distance_mask != 0) return "clip distances in OpenGL ES";
  bool has_instance_id = false;
  for (std::size_t i = 0; i < info.inputs.size(); ++i) {
    has_instance_id |=
        info.inputs[i].is_used && lowered.program.inputs[i].builtin == ir::Builtin::kInstanceId;
  }
  const bool has_several = std::ranges::any_of(
      lowered.program.outputs, [](const ir::IoVar& output) { return output.location > 0; });
  if (has_several && InfoOf(lowered.program.stage).draws_pixels &&
      !lowered.target.HasInCore(glsl::Feature::kSeveralTargets))
    return "`GL_EXT_draw_buffers`";
  has_instance_id &= !lowered.target.HasInCore(glsl::Feature::kInstanceId);
  return has_instance_id ? "`gl_InstanceIDARB` of GL_ARB_draw_instanced" : "";
}

// The shaders of a program, and what kept glslang from judging them; empty where nothing did.
struct Finished {
  Shaders shaders;
  std::string_view unjudged;
};

// Validates the shader. Returns what keeps glslang from judging it.
std::string_view ValidateShader(const Job& job, const Lowered& lowered, const Written& written) {
  const auto problems = Validate(written.glsl, lowered.target, lowered.program.stage);
  if (problems.empty()) return {};
  const std::string_view unknown = UnknownToValidator(lowered, written.info);
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

// Adds the fragment shader's part, and validates both.
Finished Finish(const Job& job, const Lowered& lowered, Written written) {
  Finished finished;
  if (job.request.outputs.validate) finished.unjudged = ValidateShader(job, lowered, written);
  if (lowered.lowering == Lowering::kDiscard)
    finished.shaders.fragment = FragmentOf(job, lowered, written.info);
  finished.shaders.vertex = std::move(written.glsl);
  return finished;
}

// The shaders for the first 0, 1 .. clip planes of `typed`; `whole` is the one for all of them. The
// planes of a draw call are moved to the front, so their number alone tells the variant.
std::vector<Finished> WriteVariants(const Job& job, const ir::Program& typed,
                                    LowerSettings settings, const glsl::WriteOptions& options,
                                    const Shaders& whole) {
  std::vector<Finished> variants;
  settings.passes.after_pass = {};
  const std::size_t planes = typed.clip_planes.size();
  const std::size_t most = std::min<std::size_t>(planes, *job.request.planes.variants);
  for (std::size_t count = 0; count <= most && !job.diagnostics.has_errors(); ++count) {
    if (count == planes) {
      variants.push_back({whole, {}});
      break;
    }
    ir::Program program = typed;
    program.clip_planes.resize(count);
    Lowered lowered = Lower(std::move(program), settings);
    Legalize(lowered, settings.passes);
    variants.push_back(Finish(job, lowered, Write(lowered, options)));
  }
  return variants;
}

std::vector<std::uint32_t> TranslateToSpirv(const Job& job, const std::string& glsl, Stage stage) {
  const CompileRequest& request = job.request;
  // The name has no folder, so that it does not matter where a shader is compiled.
  const std::string name =
      fmt::format("{}{}", request.path.substr(NameBegin(request.path)), InfoOf(stage).extension);
  Spirv spirv = MakeSpirv(glsl, request.target, stage, *request.outputs.spirv, name);
  for (const std::string& problem : spirv.problems)
    job.diagnostics.Report({}, diag::NoSpirv, problem);
  return std::move(spirv.words);
}

void RunBackEnd(const Job& job, ir::Program typed, CompileResult& result) {
  const OutputOptions& outputs = job.request.outputs;
  const ir::VarId position_input = Fit(job, typed, result.dependencies);
  if (job.diagnostics.has_errors()) return;
  if (outputs.reflection) result.position_matrices = CountPositionMatrices(typed);
  const ir::Program kept = job.request.planes.variants ? typed : ir::Program();
  const LowerSettings settings = SettingsOf(job, position_input, result.dump);
  const Lowered lowered = LowerAndLegalize(job, std::move(typed), settings);
  if (job.diagnostics.has_errors() || job.IsStopped()) return;
  if (!lowered.is_complete) {
    if (job.request.debug.dump_after.empty()) result.dump = ir::Print(lowered.program);
    return;
  }

  glsl::WriteOptions with_lines = job.plan.write;
  with_lines.comment_of = [&](Span span) { return SourceLine(job.source, span); };
  const glsl::WriteOptions& options = outputs.source_lines ? with_lines : job.plan.write;
  if (outputs.listing) result.listing = Write(lowered, with_lines).glsl;
  Written written = Write(lowered, options);
  result.table = MakeClipTable(lowered, written.info);
  if (outputs.reflection)
    result.reflection = Reflect(lowered, written.info, *result.table, result.position_matrices);
  if (outputs.structs) result.structs = WriteStructs(lowered.program, outputs.struct_prefix);
  Finished finished = Finish(job, lowered, std::move(written));
  std::string_view unjudged = finished.unjudged;
  result.shaders = std::move(finished.shaders);
  if (outputs.spirv)
    result.spirv = TranslateToSpirv(job, result.shaders.vertex, lowered.program.stage);
  if (job.request.planes.variants) {
    for (Finished& variant : WriteVariants(job, kept, settings, options, result.shaders)) {
      if (unjudged.empty()) unjudged = variant.unjudged;
      result.variants.push_back(std::move(variant.shaders));
    }
  }
  if (!unjudged.empty()) {
    job.diagnostics.Report({}, diag::NotValidated,
                           fmt::format("{} does not support {}", ValidatorName(), unjudged));
  }
  if (job.IsDump(DumpStage::kGlsl)) result.dump = result.shaders.vertex;
  if (job.IsDump(DumpStage::kTable)) {
    if (auto json = clip_table::WriteJson(*result.table)) result.dump = std::move(*json);
  }
}

// ---- from a request to a result

void RunStages(const Job& job, CompileResult& result) {
  Source& source = job.source;
  Diagnostics& diagnostics = job.diagnostics;
  const CompileRequest& request = job.request;
  if (request.outputs.preprocess) {
    result.preprocessed = Preprocess(source, diagnostics);
    return;
  }
  if (job.IsDump(DumpStage::kTokens)) {
    result.dump = DumpTokens(Lex(source, diagnostics), source);
    return;
  }
  if (job.IsDump(DumpStage::kAst)) {
    result.dump = PrintAst(ReadFile(source, diagnostics));
    return;
  }
  if (request.hlsl.wanted) {
    result.hlsl = RewriteHlsl(request, job.plan, source, job.watch, diagnostics);
    return;
  }
  const auto is_new = [&](const Tokens& tokens) {
    // The tokens alone do not decide the result where lines of the source or words of the
    // preprocessor are a part of it.
    if (!request.is_known || request.outputs.source_lines || request.outputs.listing ||
        request.link.has_pixel_shader() || diagnostics.has_pragmas() || !diagnostics.all().empty())
      return true;
    result.digest = DigestOf(tokens);
    result.is_repeated = request.is_known(*result.digest);
    return !result.is_repeated;
  };
  ir::Program program = Front(source, job.plan.check, diagnostics, is_new);
  if (diagnostics.has_errors() || result.is_repeated) return;
  if (job.IsDump(DumpStage::kIr)) {
    result.dump = ir::Print(program);
  } else {
    RunBackEnd(job, std::move(program), result);
  }
}

// Takes the source through the stages. The result has everything but the messages.
CompileResult Run(const Job& job) {
  CompileResult result;
  RunStages(job, result);
  if (job.IsStopped()) result.dump.clear();
  if (job.request.record_macros) result.macros_used = job.source.MacrosUsed();
  std::vector<std::string> others = std::move(result.dependencies);
  result.dependencies = job.source.Dependencies();
  result.includes = job.source.Includes();
  for (std::string& path : others) {
    if (std::ranges::find(result.dependencies, path) == result.dependencies.end())
      result.dependencies.push_back(std::move(path));
  }
  return result;
}

// Adds the messages to the result of Run. After errors, the outputs are removed.
CompileResult Deliver(CompileResult result, const OutputOptions& outputs, const Source& source,
                      const Diagnostics& diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.all())
    result.messages.push_back(ToMessage(diagnostic, source));
  if (outputs.text && !result.messages.empty())
    result.text = source.RenderText(diagnostics, outputs.colour);
  if (!diagnostics.has_errors()) return result;
  if (result.ok()) result.status = Status::kErrors;
  result.shaders = {};
  result.variants.clear();
  result.hlsl.reset();
  result.table.reset();
  result.reflection.clear();
  result.structs.clear();
  result.spirv.clear();
  result.listing.clear();
  return result;
}

CompileResult CompileIn(FrontendContext& context, const CompileRequest& request) {
  Diagnostics diagnostics(request.warnings);
  Stop stop(request.limits);
  diagnostics.SetWatch(stop.watch());
  const Plan plan = Resolve(request, diagnostics);
  Source source(context, plan.input);
  CompileResult result;
  if (diagnostics.has_errors()) {
    result.status = Status::kBadRequest;
  } else {
    result = Run({request, plan, source, diagnostics, stop.watch()});
    result.status = stop.Report(diagnostics);
    if (!source.main_file_read()) result.status = Status::kBadRequest;
  }
  return Deliver(std::move(result), request.outputs, source, diagnostics);
}

CompileResult Failure(const char* what) {
  CompileResult result;
  result.status = Status::kErrors;
  Message& message = result.messages.emplace_back();
  message.name = PrintedName(DiagId::kInternalError);
  message.text = fmt::format("internal error: {}", what);
  result.text = fmt::format("clipc: error: {}\n", message.text);
  return result;
}

}  // namespace

Compiler::Compiler() = default;
Compiler::~Compiler() = default;

FrontendContext& Compiler::ContextFor(const CompileRequest& request) {
  if (request.includes.sandbox.empty()) return context_;
  if (!sandboxed_ || sandbox_ != request.includes.sandbox) {
    sandboxed_ = std::make_unique<FrontendContext>(FrontendContext::Files::kOnDisk,
                                                   request.includes.sandbox);
    sandbox_ = request.includes.sandbox;
  }
  return *sandboxed_;
}

CompileResult Compiler::Compile(const CompileRequest& request) {
  try {
    if (!request.includes.read) return CompileIn(ContextFor(request), request);
    FrontendContext without_files(FrontendContext::Files::kNone);
    return CompileIn(without_files, request);
  } catch (const std::bad_alloc&) {
    return Failure("out of memory");
  } catch (const std::exception& problem) {
    return Failure(problem.what());
  }
}

CompileResult Compile(const CompileRequest& request) { return Compiler().Compile(request); }

}  // namespace clipc
