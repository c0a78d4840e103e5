// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/effect.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/file_set.h"
#include "base/path.h"
#include "compiler/batch/batch.h"
#include "compiler/command/exit_code.h"
#include "compiler/command/place_outputs.h"
#include "compiler/command/show_messages.h"
#include "compiler/command/usage.h"
#include "compiler/compile/plan.h"
#include "compiler/compile/suggest.h"
#include "compiler/effect/captures.h"
#include "compiler/effect/check_states.h"
#include "compiler/effect/dialect.h"
#include "compiler/effect/effect_json.h"
#include "compiler/effect/effect_passes.h"
#include "compiler/effect/gl_effect.h"
#include "compiler/effect/gl_effect_header.h"
#include "compiler/effect/make_effect_facts.h"
#include "compiler/effect/vulkan_states.h"
#include "frontend/parse/parse.h"

namespace clipc {
namespace {

// Whether the command asks for the header and for no file of a pass.
bool IsHeaderAlone(const CommandLine& command) {
  const bool names_files = !command.tables.empty() || !command.reflections.empty() ||
                           !command.listing.empty() || !command.preprocessed.empty();
  return !command.header.empty() && command.output.empty() && !names_files;
}

// The first mistake of the command line.
Result<> CheckEffectCommand(const CommandLine& command) {
  if (command.inputs.size() != 1 || command.inputs[0] == "-")
    return Problem{"--effect compiles one file"};
  if (!IsHeaderAlone(command) && !IsDirectory(command.output))
    return Problem{"--effect writes several files; give an existing folder with -o"};
  if (!command.batch.empty() || command.shards != 1)
    return Problem{"--effect takes neither --batch nor --shard"};
  return CheckEffectRequest(command);
}

// A problem if no technique, or no pass, has the name that is asked for.
Result<> CheckNames(const ast::Effect& effect, const CommandLine& command) {
  std::vector<std::string_view> techniques, passes;
  for (const ast::EffectTechnique& technique : effect.techniques) {
    techniques.push_back(technique.name);
    for (const ast::EffectPass& pass : technique.passes) passes.push_back(pass.name);
  }
  if (techniques.empty())
    return Problem{"it has no technique; `-T` and `-E` compile one of its functions"};
  const auto check = [](const char* what, const std::string& name,
                        const std::vector<std::string_view>& names) {
    if (name.empty() || std::ranges::find(names, name) != names.end()) return Result<>();
    return Result<>(Problem{fmt::format("it has no {} `{}`{}", what, name, Suggest(name, names))});
  };
  const Result<> known = check("technique", command.technique, techniques);
  return known ? check("pass", command.pass, passes) : known;
}

CompileResult MessagesOf(const Diagnostics& diagnostics, const Source& source,
                         const CommandLine& command) {
  CompileResult result;
  if (diagnostics.has_errors()) result.status = Status::kErrors;
  for (const Diagnostic& diagnostic : diagnostics.all())
    result.messages.push_back(ToMessage(diagnostic, source));
  if (command.format == MessageFormat::kText && !diagnostics.all().empty())
    result.text = source.RenderText(diagnostics, WantsColour(command));
  return result;
}

}  // namespace

Result<> CheckEffectRequest(const CommandLine& command) {
  const ProgramRequest& request = command.request;
  const glsl::Target& target = request.target;
  if (!command.header.empty() && (request.outputs.spirv || target.IsVulkan()))
    return Problem{
        "-Fh of an effect has GLSL for OpenGL; choose a target such as `glsl330`, without "
        "-spirv"};
  if (!command.header.empty() && request.planes.variants)
    return Problem{"-Fh of an effect has one program for each pass; --variants makes several"};
  if (request.is_linked() || !command.pixel_shader.entry.empty())
    return Problem{
        "--effect finds the pixel shaders in the effect; --pixel-shader and the like are for a "
        "file without techniques"};
  if (request.hlsl.wanted) return Problem{"--effect writes GLSL or SPIR-V, no HLSL"};
  if (Result<> done = CheckVariable(command); !done) return done;
  const ShaderSource defaults;
  if (request.first().entry != defaults.entry || request.first().profile != defaults.profile)
    return Problem{
        "-E and -T are what the passes of an effect say; --technique and --pass choose one"};
  return {};
}

EffectHeader MakeEffectHeader(const EffectFacts& facts, const Source& source,
                              const CommandLine& command) {
  const std::string& path = command.inputs[0];
  Diagnostics diagnostics(command.request.warnings);
  if (facts.is_for_vulkan) CheckVulkanStates(facts, diagnostics);
  CheckCaptures(facts, !command.header.empty(), diagnostics);
  if (command.header.empty()) return {{}, MessagesOf(diagnostics, source, command)};
  const GlEffect effect = MakeGlEffect(facts, command.request.style.clip_space.flip_y, diagnostics);
  EffectHeader header{{}, MessagesOf(diagnostics, source, command)};
  if (diagnostics.has_errors()) return header;
  header.text =
      GlEffectHeader(effect, command.variable.empty() ? GlEffectName(path.substr(NameBegin(path)))
                                                      : command.variable);
  return header;
}

namespace {

// Reads the effect of the command, as its dialect asks. Reports what has no place in a pass.
void ReadEffect(const CommandLine& command, Diagnostics& diagnostics, LoadedEffect& loaded) {
  ProgramRequest request = command.request;
  request.first().path = command.inputs[0];
  const Plan plan = Resolve(request, 0, diagnostics);
  using Files = FrontendContext::Files;
  loaded.source.reset();
  loaded.context = request.includes.read ? std::make_unique<FrontendContext>(Files::kNone)
                                         : std::make_unique<FrontendContext>(
                                               Files::kOnDisk, request.includes.sandbox);
  loaded.source = std::make_unique<Source>(*loaded.context, InputOf(request, 0, plan, diagnostics));
  if (diagnostics.has_errors()) return;
  Tokens tokens = Lex(*loaded.source, diagnostics);
  if (diagnostics.has_errors()) return;
  loaded.file = Parse(std::move(tokens), diagnostics, FunctionBodies::kSkip, {.keep = true});
  if (!diagnostics.has_errors()) loaded.effect = ast::ReadEffect(loaded.file);
}

}  // namespace

LoadedEffect LoadEffect(const CommandLine& given) {
  LoadedEffect loaded;
  CommandLine& command = loaded.command = given;
  EffectDialect dialect = command.effect_dialect.value_or(EffectDialect::kDirect3D);
  UseDialect(dialect, command);
  Diagnostics diagnostics(command.request.warnings);
  ReadEffect(command, diagnostics, loaded);
  if (!command.effect_dialect) {
    dialect = DialectOf(loaded.effect);
    UseDialect(dialect, command);
    // Its words are macros.
    if (dialect == EffectDialect::kObs) {
      diagnostics = Diagnostics(command.request.warnings);
      ReadEffect(command, diagnostics, loaded);
    }
  }
  if (dialect == EffectDialect::kObs) ReadObs(loaded.effect);
  loaded.is_read = !diagnostics.has_errors();
  if (loaded.is_read) loaded.names = CheckNames(loaded.effect, command);
  if (loaded.is_read) CheckStates(loaded.file, dialect, loaded.effect, diagnostics);
  if (loaded.names)
    loaded.programs = FindPrograms(loaded.file, loaded.effect, command, diagnostics);
  loaded.messages = MessagesOf(diagnostics, *loaded.source, command);
  loaded.messages.dependencies = loaded.source->Dependencies();
  loaded.code = !diagnostics.has_errors()         ? kExitOk
                : loaded.source->main_file_read() ? kExitErrors
                                                  : kExitUsage;
  return loaded;
}

RunResult RunEffect(CommandLine command) {
  if (const Result<> usage = CheckEffectCommand(command); !usage)
    return {Fail(usage.problem(), command.format)};
  const std::string path = command.inputs[0];
  LoadedEffect loaded = LoadEffect(command);
  command = loaded.command;
  if (!loaded.names)
    return {Fail(fmt::format("`{}`: {}", path, loaded.names.problem()), command.format)};
  if (!loaded.is_read) {
    MessagePrinter printer(command.format, command.messages);
    printer.Show(loaded.messages);
    const int code = printer.End(loaded.code, loaded.messages.dependencies);
    return {code, {std::move(loaded.messages.dependencies)}};
  }
  const char* slash = EndsWithSlash(command.output) ? "" : "/";
  const std::string stem = WithoutExtension(path.substr(NameBegin(path)));
  if (command.index.empty() && !command.output.empty())
    command.index = fmt::format("{}{}{}.json", command.output, slash, stem);
  command.header = NameAfter(command.header, command.index.empty() ? path : command.index);
  command.keep_going = true;
  BatchOfGroups batch{loaded.programs.groups, std::move(loaded.messages), {}, {}};
  std::vector<std::shared_ptr<const EffectCode>> code(batch.groups.size());
  const bool wants_header = !command.header.empty();
  batch.keep = [&](std::size_t group, const CompileResult& compiled) {
    if (!compiled.outputs) return;
    EffectCode made{*compiled.outputs->facts, {}};
    if (wants_header) made.shaders = compiled.outputs->shaders;
    code[group] = std::make_shared<EffectCode>(std::move(made));
  };
  const CommandLine& options = command;
  batch.end = [&, options](const std::vector<BatchEntry>& entries) {
    const EffectFacts facts =
        MakeEffectFacts(loaded.effect, loaded.programs, options, entries, code);
    BatchEnd end{EffectJson(facts)};
    EffectHeader header = MakeEffectHeader(facts, *loaded.source, options);
    end.messages = std::move(header.messages);
    if (!header.text.empty())
      end.files.push_back({"header", options.header, std::move(header.text)});
    return end;
  };
  RunResult result = RunBatch(std::move(command), std::move(batch));
  result.code = std::max(loaded.code, result.code);
  return result;
}

}  // namespace clipc
