// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/usage.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "compiler/command/c_names.h"
#include "compiler/command/show_messages.h"
#include "compiler/compile/message.h"
#include "frontend/lex/source.h"
#include "frontend/lex/source_text.h"
#include "ir/profile.h"

namespace clipc {

namespace {

// Whether the file of --reflect has C structs, and not JSON.
bool HoldsStructs(const std::string& file) { return file.ends_with(".h"); }

// Returns the option that HLSL cannot have; empty if there is none.
std::string_view NotForHlsl(const CommandLine& command) {
  const ProgramRequest& request = command.request;
  if (!command.tables.empty()) return "--table";
  if (!command.reflections.empty()) return "--reflect";
  if (!command.header.empty()) return "-Fh";
  if (!command.listing.empty()) return "-Fc";
  if (!command.fragment.empty()) return "--fragment";
  if (request.outputs.spirv) return "-spirv";
  if (request.style.layout != glsl::BufferLayout::kDirect3D) return "-fvk-use-gl-layout";
  return {};
}

// The first mistake in what is said about HLSL as the target.
Result<> CheckHlsl(const CommandLine& command) {
  const ProgramRequest& request = command.request;
  const HlslOptions& hlsl = request.hlsl;
  const Lowering lowering = request.planes.lowering.value_or(Lowering::kClipDistance);
  if (hlsl.plane_distances > 0 && (!hlsl.wanted || lowering != Lowering::kClipDistance))
    return Problem{
        "--plane-distances is for --target=hlsl with clip distances, of which it writes more"};
  if (!hlsl.wanted) {
    if (hlsl.wrapper_entry.empty()) return {};
    return Problem{"--wrapper-entry is for --target=hlsl; GLSL has one entry function, `main`"};
  }
  if (!hlsl.wrapper_entry.empty() && hlsl.entries.size() > 1)
    return Problem{
        "--wrapper-entry names one function; with several -E each wrapper has its entry's name"};
  if (const std::string_view option = NotForHlsl(command); !option.empty())
    return Problem{
        fmt::format("{} is about GLSL; give it in a second call, without --target=hlsl", option)};
  if (request.is_linked() && lowering != Lowering::kDiscard)
    return Problem{
        "with --target=hlsl, a pixel shader is for --lower=discard; it stays as it is under the "
        "other lowerings"};
  if (request.is_linked() && hlsl.entries.size() > 1)
    return Problem{"the pixel shader fits one vertex shader; with it, give one -E"};
  if (!command.pixel_shader.path.empty() && command.pixel_output.empty())
    return Problem{
        "--pixel-shader is rewritten too; --pixel-output names the file that it goes to"};
  return {};
}

// Whether a name in C can begin with the text.
bool IsIdentifier(std::string_view text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) || c == '_'; }) &&
         (text.empty() || std::isdigit(static_cast<unsigned char>(text[0])) == 0);
}

// The first mistake in what is said about the pixel shader of a pair.
Result<> CheckPair(const CommandLine& command) {
  if (const Result<> middle = CheckMiddle(command); !middle) return middle;
  const bool is_pair = !command.pixel_output.empty();
  if (!is_pair && !command.pixel_shader.profile.empty())
    return Problem{"--pixel-profile is for --pixel-output, which compiles the pixel shader"};
  if (!is_pair) return {};
  if (!command.fragment.empty())
    return Problem{"--fragment is for a pixel shader in GLSL; with --pixel-output clipc writes it"};
  if (command.request.planes.variants && command.pixel_output == "-")
    return Problem{
        "--variants writes several files, named after the one that --pixel-output gives"};
  const ShaderSource& pixel = command.request.shaders.back();
  if (pixel.path.empty() && pixel.entry.empty())
    return Problem{
        "--pixel-output needs --pixel-entry, the pixel shader's function in the same file"};
  return {};
}

}  // namespace

std::vector<std::string> FilesRead(const CommandLine& command) {
  std::vector<std::string> files = command.inputs;
  files.insert(files.end(), command.response_files.begin(), command.response_files.end());
  for (const std::string* file : {&command.fragment, &command.pixel_shader.path, &command.batch}) {
    if (!file->empty()) files.push_back(*file);
  }
  return files;
}

Result<> CheckMiddle(const CommandLine& command) {
  for (std::size_t i = 0; i < command.middle.size(); ++i) {
    const std::string_view stage = InfoOf(kMiddleStages[i]).name;
    const auto& [entry, output] = command.middle[i];
    if (entry.empty() != output.empty())
      return Problem{fmt::format(
          "--{0}-entry names a {0} shader, and --{0}-output its file; give both", stage)};
    if (!entry.empty() && command.request.planes.variants)
      return Problem{fmt::format("--variants is for programs without a {} shader", stage)};
  }
  return {};
}

Result<> CheckVariable(const CommandLine& command) {
  if (!command.variable.empty() && command.header.empty())
    return Problem{"-Vn names what -Fh writes; give that option too"};
  if (!IsIdentifier(command.variable) || IsKeywordInC(command.variable))
    return Problem{fmt::format("`{}` is not a name in C and C++; -Vn gives one to what -Fh writes",
                               command.variable)};
  return {};
}

Result<> CheckCommand(const CommandLine& command) {
  const ProgramRequest& request = command.request;
  if (Result<> done = CheckHlsl(command); !done) return done;
  for (const std::string& table : command.tables) {
    if (!clip_table::FormatOf(table))
      return Problem{fmt::format("`{}` names no clip table; it ends in .json, .bin or .h", table)};
  }
  if (Result<> done = CheckPair(command); !done) return done;
  if (Result<> done = CheckVariable(command); !done) return done;
  if (!command.struct_prefix.empty() && std::ranges::none_of(command.reflections, HoldsStructs))
    return Problem{"--struct-prefix is for the C structs of --reflect=FILE.h"};
  if (!IsIdentifier(command.struct_prefix))
    return Problem{fmt::format("`{}` cannot begin a name in C; a prefix is letters, digits and `_`",
                               command.struct_prefix)};
  if (!command.fragment.empty() && request.planes.lowering != Lowering::kDiscard) {
    return Problem{
        "--fragment is for --lower=discard; with the other lowerings the fragment shader stays "
        "as it is"};
  }
  if (!request.planes.position_input.empty() && request.planes.space != PlaneSpace::kObject) {
    return Problem{
        "--position-input is for --plane-space=object; other spaces take the position that the "
        "shader computes"};
  }
  const bool has_pixel_shader = !command.pixel_output.empty() || !command.pixel_shader.path.empty();
  if (!has_pixel_shader && request.link.keep_outputs) {
    return Problem{"--keep-outputs is for --pixel-shader; without it every output is kept"};
  }
  if (!has_pixel_shader && request.shaders.size() < 2 && request.link.zero_unwritten) {
    return Problem{"--zero-unwritten is for a program of several shaders, which say what is read"};
  }
  return {};
}

void ReportIdle(const CommandLine& command, Diagnostics& notices) {
  const ProgramRequest& request = command.request;
  const auto report = [&](bool is_idle, const char* option, const char* why) {
    if (is_idle) notices.Report({}, diag::OptionWithoutEffect, option, why);
  };
  const bool has_rule =
      command.write_dependencies || !command.dependency_file.empty() || command.only_dependencies;
  report(!command.dependency_target.empty() && !has_rule, "-MT",
         "it names the target of a make rule, which -MD, -MF or -M writes");
  constexpr const char* kForMany = "it is for permutations and manifests";
  report(!command.index.empty(), "--index", kForMany);
  report(command.keep_going, "-k", kForMany);
  report(command.resume, "--resume", kForMany);
  constexpr const char* kForEffects = "it is for --effect";
  report(!command.technique.empty(), "--technique", kForEffects);
  report(!command.pass.empty(), "--pass", kForEffects);
  report(command.effect_dialect.has_value(), "--effect-dialect", kForEffects);
  report(command.shards != 1, "--shard", kForMany);
  report(
      !request.is_linked() && !command.pixel_shader.entry.empty(), "--pixel-entry",
      "it is for --pixel-shader, which fits a pixel shader, and --pixel-output, which writes one");
  const glsl::Target& target = request.target;
  report(request.style.separable && (target.IsVulkan() || target.IsEs() || target.version() < 410),
         "--separable", "it is for targets `glsl410` to `glsl460`");
  const auto profile = ir::ParseProfile(request.first().profile);
  const StageInfo* stage = profile && profile->stage ? &InfoOf(*profile->stage) : nullptr;
  const bool is_hull = stage && stage->makes_patches && request.shaders.size() == 1;
  const bool has_planes = !stage || (stage->has_stage_after && !is_hull);
  const bool has_pixel_shader =
      !has_planes || request.shaders.size() > 1 || command.effect || !command.batch.empty();
  if (!request.language.shadow_samplers.empty()) {
    report(request.hlsl.wanted, "--shadow-samplers", "with --target=hlsl the text stays as it is");
    report(!request.hlsl.wanted && !has_pixel_shader, "--shadow-samplers",
           "this is not a pixel shader");
  }
  report(!has_planes && !command.tables.empty(), "--table",
         stage && stage->makes_patches ? "a hull shader has no clip planes"
                                       : "only a vertex shader has clip planes");
  report(request.planes.in_last_stage && request.PlaneStage() == 0, "--planes-in-last-stage",
         is_hull ? "the positions of control points are not drawn; the domain shader has the planes"
                 : "no stage runs between this shader and the rasteriser");
  report(request.debug.changes_result() && !command.tables.empty(), "--table",
         "a dump takes its place");
  report(request.debug.changes_result() && !command.reflections.empty(), "--reflect",
         "a dump takes its place");
}

CompileResult NoticesOf(const CommandLine& command) {
  CompileResult result;
  if (command.notices.all().empty()) return result;
  FrontendContext context;
  const Source nowhere(context, {});
  result.text = nowhere.RenderText(command.notices, command.request.outputs.colour);
  for (const Diagnostic& notice : command.notices.all())
    result.messages.push_back(ToMessage(notice, nowhere));
  return result;
}

Result<> PrepareRequest(CommandLine& command) {
  ProgramRequest& request = command.request;
  if (!command.fragment.empty()) {
    Result<std::string> text = ReadText(command.fragment);
    if (!text)
      return Problem{fmt::format("cannot read `{}`: {}", command.fragment, text.problem())};
    request.planes.fragment = std::move(*text);
  }
  OutputOptions& outputs = request.outputs;
  outputs.facts = outputs.facts || !command.reflections.empty();
  outputs.glsl = !outputs.spirv || request.debug.dump;
  outputs.listing = !command.listing.empty();
  // GLSL has what the shader reads, and one layout for both.
  if (outputs.glsl || outputs.listing) request.target.bindings.keeps_unread = false;
  outputs.preprocess = !command.preprocessed.empty() || command.only_dependencies;
  outputs.text = command.format == MessageFormat::kText;
  outputs.colour = outputs.text && WantsColour(command);
  const bool reflects_planes = !std::ranges::all_of(command.reflections, HoldsStructs);
  request.planes.given_to_device =
      request.planes.given_to_device || !command.tables.empty() || reflects_planes;
  return {};
}

}  // namespace clipc
