// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/compile.h"

#include <algorithm>
#include <exception>
#include <new>

#include <fmt/format.h>

#include "backend-glsl/check_target.h"
#include "backend-glsl/discard.h"
#include "backend-glsl/target.h"
#include "backend-glsl/writer.h"
#include "clip-table/write.h"
#include "compiler/dump_tokens.h"
#include "compiler/make_clip_table.h"
#include "compiler/reflect.h"
#include "compiler/suggest.h"
#include "compiler/validate.h"
#include "frontend/check/check.h"
#include "frontend/lex/source.h"
#include "frontend/parse/ast_print.h"
#include "frontend/parse/parse.h"
#include "frontend/rules/position_input.h"
#include "ir/print.h"
#include "passes/outputs.h"
#include "passes/pipeline.h"

namespace clipc {
namespace {

// The parts of a request that are names, understood.
struct Settings {
  ir::Profile profile;
  std::optional<glsl::Target> target;
  Lowering lowering = Lowering::kClipDistance;
};

// One request on its way through the stages. Each stage returns whether to go on.
class Compilation {
 public:
  Compilation(FrontendContext& context, const CompileRequest& request)
      : request_(request), diagnostics_(request.warnings), context_(context) {}

  CompileResult Run() {
    if (!ReadSettings()) result_.status = Status::kBadRequest;
    SourceInput input;
    input.path = request_.path;
    input.text = request_.text;
    input.include_dirs = request_.include_dirs;
    input.defines = request_.defines;
    input.shader_model_major = settings_.profile.major;
    input.shader_model_minor = settings_.profile.minor;
    Source source(context_, std::move(input));
    if (result_.ok()) {
      RunStages(source);
      result_.dependencies = source.Dependencies();
      if (!source.main_file_read()) result_.status = Status::kBadRequest;
    }
    Finish(source);
    return std::move(result_);
  }

 private:
  bool ReadSettings();
  void RunStages(Source& source);
  void RunBackEnd(ir::Program& program);
  void Lower(ir::Program& program);
  void Write(const ir::Program& program);
  void WriteFragment(const ir::Program& program);
  void WriteVariants(const ir::Program& typed);
  void CheckWithGlslang(const std::string& glsl, ShaderStage stage);
  void Finish(const Source& source);

  bool IsDump(Stage stage) const { return request_.dump == stage; }
  bool StopsHere(Stage stage) const { return IsDump(stage) || diagnostics_.has_errors(); }

  const CompileRequest& request_;
  Diagnostics diagnostics_;
  FrontendContext& context_;
  Settings settings_;
  ir::VarId position_input_;  // with plane space `object`
  glsl::GlslInfo info_;
  CompileResult result_;
};

bool Compilation::ReadSettings() {
  if (auto profile = ir::ParseProfile(request_.profile)) {
    settings_.profile = std::move(*profile);
  } else {
    diagnostics_.Report({}, diag::UnknownProfile, request_.profile,
                        Suggest(request_.profile, ProfileNames()));
  }
  settings_.target = glsl::Target::Parse(request_.target);
  if (!settings_.target) {
    diagnostics_.Report({}, diag::UnknownTarget, request_.target,
                        Suggest(request_.target, glsl::Target::Names()));
  }
  const std::vector<std::string_view> passes = passes::PassNames();
  const auto check_pass = [&](const std::string& name) {
    if (std::find(passes.begin(), passes.end(), name) != passes.end()) return;
    diagnostics_.Report({}, diag::UnknownPass, name, Suggest(name, passes));
  };
  for (const std::string& name : request_.dump_after) check_pass(name);
  if (!request_.stop_after.empty()) check_pass(request_.stop_after);
  const bool is_level9 = settings_.profile.level9 != ir::Level9::kNone;
  settings_.lowering =
      request_.lowering.value_or(is_level9 ? Lowering::kLevel9 : Lowering::kClipDistance);
  if (!Supports(settings_.lowering, request_.plane_space)) {
    diagnostics_.Report({}, diag::PlaneSpaceLowering, NameOf(request_.plane_space),
                        NameOf(settings_.lowering));
  }
  return !diagnostics_.has_errors();
}

void Compilation::RunStages(Source& source) {
  ir::Program program;
  {
    Tokens tokens = Lex(source, diagnostics_);
    if (IsDump(Stage::kTokens)) result_.dump = DumpTokens(tokens, source);
    if (StopsHere(Stage::kTokens)) return;
    const ast::File file = Parse(std::move(tokens), diagnostics_);
    if (IsDump(Stage::kAst)) result_.dump = PrintAst(file);
    if (StopsHere(Stage::kAst)) return;
    CheckOptions options;
    options.profile = settings_.profile;
    options.entry = request_.entry;
    options.packing = request_.matrices == MatrixOrder::kRowMajor ? MatrixPacking::kRowMajor
                                                                  : MatrixPacking::kColumnMajor;
    options.whole_register_planes = settings_.lowering == Lowering::kLevel9;
    program = Check(file, options, diagnostics_);
    if (diagnostics_.has_errors()) return;
    if (!settings_.profile.IsVertex()) {
      diagnostics_.Report({}, diag::NotVertexProfile, settings_.profile.name);
      return;
    }
  }  // what was written is not needed any more
  if (IsDump(Stage::kIr)) result_.dump = ir::Print(program);
  if (!IsDump(Stage::kIr)) RunBackEnd(program);
}

// How many the shader has.
std::uint32_t DistancesOf(const ir::Program& program) {
  const ir::VarId distances = passes::FindOutput(program, ir::Builtin::kClipDistance);
  return distances ? program.types[program.vars[distances].type].count : 0;
}

void Compilation::RunBackEnd(ir::Program& program) {
  if (settings_.lowering == Lowering::kNone && !program.clip_planes.empty()) {
    const std::size_t count = program.clip_planes.size();
    diagnostics_.Report(Cover(program.clip_planes.front().span, program.clip_planes.back().span),
                        diag::ClipPlanesIgnored, count, count == 1 ? "" : "s");
  }
  if (settings_.lowering == Lowering::kNearPlane && program.clip_planes.size() > 1) {
    diagnostics_.Report(program.clip_planes[1].span, diag::ClipPlanesForNearPlane,
                        program.clip_planes.size());
    return;
  }
  if (request_.plane_space == PlaneSpace::kObject && !program.clip_planes.empty()) {
    const std::string& semantic = request_.position_input;
    position_input_ =
        CheckPositionInput(program, semantic.empty() ? "POSITION0" : semantic, diagnostics_);
    if (!position_input_) return;
  }
  if (request_.variants) WriteVariants(program);
  if (diagnostics_.has_errors()) return;
  const ir::VarId distances = passes::FindOutput(program, ir::Builtin::kClipDistance);
  const std::uint32_t count = DistancesOf(program);
  Lower(program);
  if (distances && DistancesOf(program) < count && request_.stop_after.empty()) {
    diagnostics_.Report(program.vars[distances].span, diag::ClipDistancesLeftOut,
                        DistancesOf(program));
  }
  if (!request_.stop_after.empty()) {
    if (request_.dump_after.empty()) result_.dump = ir::Print(program);
    return;
  }
  Write(program);
}

void Compilation::Lower(ir::Program& program) {
  passes::PipelineOptions options;
  options.clip_planes.lowering = settings_.lowering;
  options.clip_planes.space = request_.plane_space;
  options.clip_planes.position_input = position_input_;
  options.clip_planes.write_clip_vertex = settings_.target->HasClipVertex();
  options.clip_space.negative_one_to_one = request_.depth_range == DepthRange::kNegativeOneToOne;
  options.clip_space.flip_y = request_.flip_y;
  options.stop_after = request_.stop_after;
  options.verify = request_.verify;
  if (!request_.dump_after.empty()) {
    options.after_pass = [&](std::string_view pass, const ir::Program& after) {
      const auto& wanted = request_.dump_after;
      if (std::find(wanted.begin(), wanted.end(), pass) == wanted.end()) return;
      if (wanted.size() > 1) result_.dump += fmt::format("// after {}\n", pass);
      result_.dump += ir::Print(after);
    };
  }
  passes::RunPipeline(program, options);
}

void Compilation::Write(const ir::Program& program) {
  glsl::WriteOptions options;
  options.separable = request_.separable;
  glsl::Reached reached = glsl::CheckTarget(program, *settings_.target, diagnostics_);
  if (diagnostics_.has_errors()) return;
  result_.glsl = glsl::WriteGlsl(program, std::move(reached), *settings_.target, options, &info_);
  result_.table = MakeClipTable(program, settings_.lowering, request_.plane_space, info_);
  if (request_.validate) CheckWithGlslang(result_.glsl, ShaderStage::kVertex);
  if (settings_.lowering == Lowering::kDiscard) WriteFragment(program);
  if (IsDump(Stage::kGlsl)) result_.dump = result_.glsl;
  if (IsDump(Stage::kTable)) {
    auto json = clip_table::WriteJson(*result_.table);
    if (json) result_.dump = std::move(*json);
  }
  if (request_.reflect)
    result_.reflection = Reflect(program, *settings_.target, info_, *result_.table);
}

void Compilation::WriteFragment(const ir::Program& program) {
  const glsl::Target& target = *settings_.target;
  if (!request_.fragment) {
    const glsl::DiscardCode code = glsl::WriteDiscard(program, target, info_);
    result_.fragment = code.declarations;
    return;
  }
  glsl::Insertion insertion = glsl::InsertDiscard(*request_.fragment, program, target, info_);
  if (!insertion.error.empty()) diagnostics_.Report({}, diag::FragmentShader, insertion.error);
  result_.fragment = std::move(insertion.text);
  if (request_.validate && insertion.error.empty())
    CheckWithGlslang(result_.fragment, ShaderStage::kFragment);
}

// The planes of a draw call are moved to the front, so its variant is told by their number alone.
void Compilation::WriteVariants(const ir::Program& typed) {
  for (std::size_t count = 0; count <= std::min(typed.clip_planes.size(), request_.variant_planes);
       ++count) {
    ir::Program program = typed;
    program.clip_planes.resize(count);
    Lower(program);
    Write(program);
    if (diagnostics_.has_errors()) return;
    result_.variants.push_back({std::move(result_.glsl), std::move(result_.fragment)});
    info_ = {};
  }
}

void Compilation::CheckWithGlslang(const std::string& glsl, ShaderStage stage) {
  const Validation validation = Validate(glsl, *settings_.target, stage);
  if (validation.ok) return;
  if (stage == ShaderStage::kFragment) {
    diagnostics_.Report(
        {}, diag::FragmentShader,
        validation.problems.empty() ? "glslang refuses it" : validation.problems[0]);
    return;
  }
  if (settings_.target->IsEs() && info_.clip_distance_mask != 0) {
    const std::string why = fmt::format("{} does not support clip distances in OpenGL ES", ValidatorName());
    diagnostics_.Report({}, diag::NotValidated, why);
    return;
  }
  const auto& problems = validation.problems;
  Diagnostic& report = diagnostics_.Report({}, diag::InvalidGlsl,
                                           problems.empty() ? "no reason given" : problems[0]);
  for (std::size_t i = 1; i < problems.size(); ++i) report.Note({}, diag::PlainNote, problems[i]);
}

void Compilation::Finish(const Source& source) {
  for (const Diagnostic& diagnostic : diagnostics_.all())
    result_.messages.push_back(ToMessage(diagnostic, source));
  if (request_.draw_text && !result_.messages.empty()) {
    result_.text = source.RenderText(diagnostics_, request_.colour);
  }
  if (diagnostics_.has_errors()) {
    if (result_.ok()) result_.status = Status::kErrors;
    result_.glsl.clear();
    result_.fragment.clear();
    result_.variants.clear();
    result_.table.reset();
    result_.reflection.clear();
  }
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

struct Compiler::Shared {
  FrontendContext frontend;
};

Compiler::Compiler() : shared_(std::make_unique<Shared>()) {}
Compiler::~Compiler() = default;

CompileResult Compiler::Compile(const CompileRequest& request) {
  try {
    return Compilation(shared_->frontend, request).Run();
  } catch (const std::bad_alloc&) {
    return Failure("out of memory");
  } catch (const std::exception& problem) {
    return Failure(problem.what());
  }
}

CompileResult Compile(const CompileRequest& request) { return Compiler().Compile(request); }

}  // namespace clipc
