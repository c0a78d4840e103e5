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
#include "compiler/output_files.h"
#include "compiler/pixel_half.h"
#include "compiler/reflect.h"
#include "compiler/stages.h"
#include "compiler/structs.h"
#include "compiler/suggest.h"
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

// One request on its way through the stages.
class Compilation {
 public:
  Compilation(FrontendContext& context, const CompileRequest& request)
      : request_(request), diagnostics_(request.warnings), context_(context) {
    const bool has_deadline = request.limits.seconds != Limits().seconds;
    if (has_deadline) deadline_ = Clock::now() + std::chrono::seconds(request.limits.seconds);
    if (has_deadline || request.limits.is_cancelled) diagnostics_.SetWatch(&watch_);
  }

  CompileResult Run();

 private:
  using Clock = std::chrono::steady_clock;
  // Thrown to leave the passes when the watch has stopped; caught in Run.
  struct Stopped {};

  void ReadNames();
  bool MustStop();
  void ReportStop();
  SourceInput InputOf() const;
  void RunStages(Source& source);
  void Dump(Source& source);
  void RunBackEnd(ir::Program program, const Source& source);
  LowerSettings SettingsFor(ir::VarId position_input);
  Shaders Finish(const Lowered& lowered, Written written);
  void WriteVariants(const ir::Program& typed, LowerSettings settings);
  void TranslateToSpirv();
  void ValidateVertex(const Lowered& lowered, const Written& written);
  void CloseResult(const Source& source);

  bool IsDump(DumpStage stage) const { return request_.debug.dump == stage; }

  const CompileRequest& request_;
  Diagnostics diagnostics_;
  FrontendContext& context_;
  // The parts of the request that are names, resolved.
  CheckOptions front_;
  LoweringRequest lowering_;
  glsl::WriteOptions options_;

  Clock::time_point deadline_ = Clock::time_point::max();
  bool is_cancelled_ = false;
  Watch watch_{[this] { return MustStop(); }};
  bool has_pixel_shader_ = false;
  bool keeps_matrices_whole_ = false;
  std::string_view unjudged_;  // a feature that glslang does not know; empty if it can judge
  CompileResult result_;
};

CompileResult Compilation::Run() {
  ReadNames();
  Source source(context_, InputOf());
  if (diagnostics_.has_errors()) {
    result_.status = Status::kBadRequest;
  } else {
    try {
      RunStages(source);
    } catch (const Stopped&) {
      result_.dump.clear();
    }
    ReportStop();
    if (request_.record_macros) result_.macros_used = source.MacrosUsed();
    std::vector<std::string> others = std::move(result_.dependencies);
    result_.dependencies = source.Dependencies();
    result_.includes = source.Includes();
    for (std::string& path : others) {
      if (std::ranges::find(result_.dependencies, path) == result_.dependencies.end())
        result_.dependencies.push_back(std::move(path));
    }
    if (!source.main_file_read()) result_.status = Status::kBadRequest;
  }
  CloseResult(source);
  return std::move(result_);
}

bool Compilation::MustStop() {
  is_cancelled_ = request_.limits.is_cancelled && request_.limits.is_cancelled();
  return is_cancelled_ || (deadline_ != Clock::time_point::max() && Clock::now() >= deadline_);
}

void Compilation::ReportStop() {
  if (!watch_.stopped()) return;
  if (is_cancelled_) {
    diagnostics_.Report({}, diag::Cancelled);
    result_.status = Status::kCancelled;
  } else {
    diagnostics_.Report({}, diag::TimeLimit, request_.limits.seconds);
  }
}

void Compilation::ReadNames() {
  const auto unknown = [&](const auto& kind, const std::string& name,
                           std::span<const std::string_view> names) {
    diagnostics_.Report({}, kind, name, Suggest(name, names));
  };
  if (auto profile = ir::ParseProfile(request_.language.profile)) {
    front_ = CheckOptions::For(std::move(*profile), request_.language.version);
  } else {
    unknown(diag::UnknownProfile, request_.language.profile, ProfileNames());
  }
  auto names =
      glsl::NameStyle::Parse(request_.style.names.empty() ? "hlslcc" : request_.style.names);
  if (!names) {
    unknown(diag::UnknownNames, request_.style.names, glsl::NameStyle::Names());
    names.emplace();
  }
  options_ = {.separable = request_.style.separable,
              .base_vertex_is_zero = request_.style.base_vertex_is_zero,
              .base_instance_is_zero = request_.style.base_instance_is_zero,
              .invariant = request_.style.invariant,
              .blocks = request_.style.blocks,
              .names = std::move(*names)};
  const auto check_pass = [&](const std::string& name) {
    const std::vector<std::string_view> passes = LowerPasses();
    if (std::ranges::find(passes, name) != passes.end()) return;
    unknown(diag::UnknownPass, name, passes);
  };
  for (const std::string& name : request_.debug.dump_after) check_pass(name);
  if (!request_.debug.stop_after.empty()) check_pass(request_.debug.stop_after);

  lowering_ = {request_.planes.lowering.value_or(DefaultLowering(front_.profile)),
               request_.planes.space, request_.planes.position_input};
  CheckRequest(lowering_, diagnostics_);
  if (!request_.includes.sandbox.empty() && !IsDirectory(request_.includes.sandbox))
    diagnostics_.Report({}, diag::NoSandbox, request_.includes.sandbox);
  front_.entry = request_.language.entry;
  front_.packing = request_.language.packing;
  front_.position_name = request_.language.position_name;
  // HLSLcc, after fxc, has a variable for each column of a matrix between two stages. Its names
  // are the usual ones where stages match by name.
  const bool is_hlslcc = request_.style.names.empty()
                             ? !request_.target.Has(glsl::Feature::kOutputLocations)
                             : request_.style.names == "hlslcc";
  has_pixel_shader_ = request_.link.has_pixel_shader();
  keeps_matrices_whole_ = !has_pixel_shader_ && !is_hlslcc;
  front_.stages_match_by_row = has_pixel_shader_ || keeps_matrices_whole_;
  front_.whole_register_planes = lowering_.lowering == Lowering::kLevel9;
}

SourceInput Compilation::InputOf() const {
  return {.path = request_.path,
          .text = request_.text,
          .include_dirs = request_.includes.dirs,
          .defines = request_.defines,
          .forced_includes = request_.includes.forced,
          .read_include = request_.includes.read,
          .shader_model_major = front_.profile.major,
          .shader_model_minor = front_.profile.minor,
          .language = request_.language.version,
          .max_bytes = request_.limits.bytes,
          .max_tokens = request_.limits.tokens,
          .record_macros = request_.record_macros};
}

void Compilation::RunStages(Source& source) {
  if (request_.outputs.preprocess) {
    result_.preprocessed = Preprocess(source, diagnostics_);
    return;
  }
  if (IsDump(DumpStage::kTokens) || IsDump(DumpStage::kAst)) return Dump(source);
  const auto is_new = [&](const Tokens& tokens) {
    // The tokens alone do not decide the result where lines of the source or words of the
    // preprocessor are a part of it.
    if (!request_.is_known || request_.outputs.source_lines || request_.outputs.listing ||
        has_pixel_shader_ || diagnostics_.has_pragmas() || !diagnostics_.all().empty())
      return true;
    result_.digest = DigestOf(tokens);
    result_.is_repeated = request_.is_known(*result_.digest);
    return !result_.is_repeated;
  };
  ir::Program program = Front(source, front_, diagnostics_, is_new);
  if (diagnostics_.has_errors() || result_.is_repeated) return;
  if (IsDump(DumpStage::kIr)) {
    result_.dump = ir::Print(program);
  } else {
    RunBackEnd(std::move(program), source);
  }
}

// Dumps a stage before the typed program.
void Compilation::Dump(Source& source) {
  if (IsDump(DumpStage::kTokens)) {
    result_.dump = DumpTokens(Lex(source, diagnostics_), source);
    return;
  }
  result_.dump = PrintAst(ReadFile(source, diagnostics_));
}

void Compilation::RunBackEnd(ir::Program typed, const Source& source) {
  if (keeps_matrices_whole_) link::KeepMatricesWhole(typed);
  if (has_pixel_shader_) {
    LinkPixelShader(request_, InputOf(), typed, result_.dependencies, diagnostics_);
    if (diagnostics_.has_errors()) return;
  }
  const LowerSettings settings = SettingsFor(CheckLowering(typed, lowering_, diagnostics_));
  if (!request_.planes.given_to_device && !request_.debug.changes_result())
    CheckPlanesAreKept(typed, lowering_, request_.target, diagnostics_);
  if (diagnostics_.has_errors()) return;
  if (request_.outputs.reflection) result_.position_matrices = CountPositionMatrices(typed);
  const ClipDistances distances = ClipDistancesOf(typed);
  const ir::Program kept = request_.planes.variants ? typed : ir::Program();
  Lowered lowered = Lower(std::move(typed), settings);
  if (lowered.is_complete) {
    ReportLeftOut(distances, lowered.program, diagnostics_);
    CheckTarget(lowered, request_.style.blocks, diagnostics_);
    if (diagnostics_.has_errors()) return;
    Legalize(lowered, settings.passes);
  }
  if (!lowered.is_complete) {
    if (request_.debug.dump_after.empty()) result_.dump = ir::Print(lowered.program);
    return;
  }

  glsl::WriteOptions with_lines = options_;
  with_lines.comment_of = [&](Span span) { return SourceLine(source, span); };
  if (request_.outputs.listing) result_.listing = Write(lowered, with_lines).glsl;
  if (request_.outputs.source_lines) options_ = std::move(with_lines);
  Written written = Write(lowered, options_);
  result_.table = MakeClipTable(lowered, written.info);
  if (request_.outputs.reflection) {
    result_.reflection = Reflect(lowered, written.info, *result_.table, result_.position_matrices);
  }
  if (request_.outputs.structs) result_.structs = WriteStructs(lowered.program);
  result_.shaders = Finish(lowered, std::move(written));
  if (request_.outputs.spirv) TranslateToSpirv();
  if (request_.planes.variants) WriteVariants(kept, settings);
  if (!unjudged_.empty()) {
    diagnostics_.Report({}, diag::NotValidated,
                        fmt::format("{} does not support {}", ValidatorName(), unjudged_));
  }
  if (IsDump(DumpStage::kGlsl)) result_.dump = result_.shaders.vertex;
  if (IsDump(DumpStage::kTable)) {
    if (auto json = clip_table::WriteJson(*result_.table)) result_.dump = std::move(*json);
  }
}

LowerSettings Compilation::SettingsFor(ir::VarId position_input) {
  LowerSettings settings{request_.target, {}};
  settings.passes.clip_planes = {lowering_.lowering, lowering_.plane_space, position_input};
  settings.passes.clip_space = request_.style.clip_space;
  settings.passes.precise_outputs = request_.style.precise;
  settings.passes.stop_after = request_.debug.stop_after;
  settings.passes.verify = request_.debug.verify;
  settings.passes.after_pass = [&](std::string_view pass, const ir::Program& after) {
    if (watch_.AskNow()) throw Stopped();
    const auto& wanted = request_.debug.dump_after;
    if (std::ranges::find(wanted, pass) == wanted.end()) return;
    if (wanted.size() > 1) result_.dump += fmt::format("// after {}\n", pass);
    result_.dump += ir::Print(after);
  };
  return settings;
}

// Adds the fragment shader's part, and validates both.
Shaders Compilation::Finish(const Lowered& lowered, Written written) {
  if (request_.outputs.validate) ValidateVertex(lowered, written);
  Shaders shaders{std::move(written.glsl), {}};
  if (lowered.lowering != Lowering::kDiscard) return shaders;
  if (!request_.planes.fragment) {
    shaders.fragment =
        glsl::WriteDiscard(lowered.program, lowered.target, written.info).declarations;
    return shaders;
  }
  glsl::Insertion insertion =
      glsl::InsertDiscard(*request_.planes.fragment, lowered.program, lowered.target, written.info);
  shaders.fragment = std::move(insertion.text);
  if (insertion.error.empty() && request_.outputs.validate) {
    const auto problems = Validate(shaders.fragment, lowered.target, ShaderStage::kFragment);
    if (!problems.empty()) insertion.error = problems.front();
  }
  if (!insertion.error.empty()) diagnostics_.Report({}, diag::FragmentShader, insertion.error);
  return shaders;
}

// The planes of a draw call are moved to the front, so their number alone tells the variant.
void Compilation::WriteVariants(const ir::Program& typed, LowerSettings settings) {
  settings.passes.after_pass = {};
  const std::size_t planes = typed.clip_planes.size();
  for (std::size_t count = 0; count <= std::min<std::size_t>(planes, *request_.planes.variants);
       ++count) {
    if (diagnostics_.has_errors()) return;
    if (count == planes) {
      result_.variants.push_back(result_.shaders);
      return;
    }
    ir::Program program = typed;
    program.clip_planes.resize(count);
    Lowered lowered = Lower(std::move(program), settings);
    Legalize(lowered, settings.passes);
    result_.variants.push_back(Finish(lowered, Write(lowered, options_)));
  }
}

void Compilation::TranslateToSpirv() {
  // The name has no folder, so that it does not matter where a shader is compiled.
  const std::string name = request_.path.substr(NameBegin(request_.path)) + ".vert";
  Spirv spirv = MakeSpirv(result_.shaders.vertex, request_.target, *request_.outputs.spirv, name);
  for (const std::string& problem : spirv.problems) diagnostics_.Report({}, diag::NoSpirv, problem);
  result_.spirv = std::move(spirv.words);
}

void Compilation::ValidateVertex(const Lowered& lowered, const Written& written) {
  const auto problems = Validate(written.glsl, lowered.target, ShaderStage::kVertex);
  if (problems.empty()) return;
  // docs/language.md, "GLSL that glslang refuses".
  if (lowered.target.IsEs() && written.info.clip_distance_mask != 0) {
    unjudged_ = "clip distances in OpenGL ES";
    return;
  }
  if (problems.front().find("gl_InstanceIDARB") != std::string::npos) {
    unjudged_ = "`gl_InstanceIDARB` of GL_ARB_draw_instanced";
    return;
  }
  Diagnostic& report = diagnostics_.Report({}, diag::InvalidGlsl, problems.front());
  for (std::size_t i = 1; i < problems.size(); ++i) report.Note({}, diag::PlainNote, problems[i]);
}

void Compilation::CloseResult(const Source& source) {
  for (const Diagnostic& diagnostic : diagnostics_.all())
    result_.messages.push_back(ToMessage(diagnostic, source));
  if (request_.outputs.text && !result_.messages.empty()) {
    result_.text = source.RenderText(diagnostics_, request_.outputs.colour);
  }
  if (!diagnostics_.has_errors()) return;
  if (result_.ok()) result_.status = Status::kErrors;
  result_.shaders = {};
  result_.variants.clear();
  result_.table.reset();
  result_.reflection.clear();
  result_.structs.clear();
  result_.spirv.clear();
  result_.listing.clear();
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
    if (!request.includes.read) return Compilation(ContextFor(request), request).Run();
    FrontendContext without_files(FrontendContext::Files::kNone);
    return Compilation(without_files, request).Run();
  } catch (const std::bad_alloc&) {
    return Failure("out of memory");
  } catch (const std::exception& problem) {
    return Failure(problem.what());
  }
}

CompileResult Compile(const CompileRequest& request) { return Compiler().Compile(request); }

}  // namespace clipc
