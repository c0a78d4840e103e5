// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/command/options.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/file_set.h"
#include "base/path.h"
#include "base/spelling.h"
#include "base/system.h"
#include "compiler/command/option_actions.h"
#include "compiler/command/option_table.h"
#include "frontend/lex/source_text.h"
#include "ir/profile.h"

namespace clipc {
namespace {

using enum Option::Form;

// ---- response files

constexpr std::size_t kMaxArguments = 1 << 16;
constexpr int kMaxResponseDepth = 10;

// The words of a response file, which are separated by white space outside double quotes. A
// backslash stands for itself, as in paths of Windows, except before a double quote.
std::vector<std::string> Words(std::string_view text) {
  std::vector<std::string> words;
  bool is_open = false, is_quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_escape = text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '"';
    const char c = is_escape ? text[++i] : text[i];
    const bool is_space =
        !is_quoted && std::string_view(" \t\r\n").find(c) != std::string_view::npos;
    if (!is_space && !is_open) words.emplace_back();
    is_open = !is_space;
    if (c == '"' && !is_escape) {
      is_quoted = !is_quoted;
    } else if (!is_space) {
      words.back() += c;
    }
  }
  return words;
}

// Adds `argument`, or for @FILE the words of the file, to `to`, and the file to `files`. Returns
// the problem in words; empty if there is none.
Result<> Expand(std::string argument, int depth, std::vector<std::string>& to,
                std::vector<std::string>& files) {
  if (!argument.starts_with('@') || argument.size() == 1) {
    to.push_back(std::move(argument));
    if (to.size() > kMaxArguments) return Problem{"too many arguments"};
    return {};
  }
  const std::string file = argument.substr(1);
  if (depth == kMaxResponseDepth) return Problem{fmt::format("`{}` includes itself", file)};
  const Result<std::string> text = ReadText(file);
  if (!text)
    return Problem{fmt::format("cannot read the response file `{}`: {}", file, text.problem())};
  files.push_back(file);
  for (std::string& word : Words(*text)) {
    if (Result<> done = Expand(std::move(word), depth + 1, to, files); !done) return done;
  }
  return {};
}

// ---- one argument

// Whether an argument that starts with a slash is a path: it exists, or something could be made
// there.
bool LooksLikePath(const std::string& argument) {
  if (system::StatusOf(argument)) return true;
  const std::string folder = argument.substr(0, argument.find_last_of(kSlashes));
  return folder.find_first_not_of(kSlashes) != std::string::npos && IsDirectory(folder);
}

// The advice "did you mean" for an argument that is not an option.
std::string NearOption(std::string_view argument) {
  const std::string_view name = argument.substr(0, argument.find('='));
  // Any one letter is near any other.
  std::vector<std::string_view> near;
  if (name.size() > 3) near = NearNames(name, Spellings());
  return near.empty() || near[0] == name
             ? ""
             : fmt::format("did you mean `{}{}`?", near[0], argument.substr(name.size()));
}

// Whether a word can be the value of -D: NAME, NAME=VALUE or NAME(PARAMETERS)=VALUE.
bool IsDefinition(std::string_view word) {
  const std::string_view name = word.substr(0, word.find_first_of("=("));
  return !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_';
  });
}

// Reads the option or the input at `arguments[at]` and its value, and moves `at` past them.
void ReadArgument(std::span<const std::string> arguments, std::size_t& at, Reading& reading) {
  const std::string& written = arguments[at++];
  if (written.empty()) return reading.Refuse("an argument is empty, where a file is named");
  if (written == "--") {  // no option follows
    auto& inputs = reading.command.inputs;
    for (; at < arguments.size(); ++at) inputs.push_back(arguments[at]);
    return;
  }
  std::string spelling = written;
  const bool has_dash = written.size() > 1 && written[0] == '-';
  const bool has_slash = written.size() > 1 && written[0] == '/' && !LooksLikePath(written);
  if (has_slash) spelling[0] = '-';
  const auto [name, option] = has_dash || has_slash ? FindOption(spelling) : Spelling{};
  if (!option) {
    // A path has more slashes than the first one, or an extension.
    if (has_dash || (has_slash && written.find_first_of("/.", 1) == std::string::npos)) {
      reading.unknown.emplace_back(written, NearOption(spelling));
    } else {
      reading.command.inputs.push_back(written);
    }
    return;
  }
  // The words of glslang, dxc and glslc for what a line writes.
  constexpr std::string_view kOfTools[] = {"-V", "-Fo", "-fshader-stage", "-fentry-point"};
  reading.is_of_tool |= std::ranges::find(kOfTools, name) != std::end(kOfTools);
  reading.argument = written;
  reading.option = written.substr(0, name.size());
  reading.advice = option->help;
  reading.next = at < arguments.size() ? arguments[at] : "";
  std::string value = spelling.substr(name.size());
  if ((option->form == kEquals || option->form == kNumbers) && !value.empty()) {
    value.erase(0, 1);
  } else if (value.empty() && option->form != kFlag && option->form != kJoined) {
    const bool is_definition = option->form == kDefinition && has_dash;
    const bool has_next = at < arguments.size() && !arguments[at].empty() &&
                          (!arguments[at].starts_with('-') || arguments[at] == "-") &&
                          (!is_definition || IsDefinition(arguments[at]));
    if (has_next) value = arguments[at++];
    if (!has_next && option->form != kOptional && !is_definition) {
      reading.Refuse(NeedsValue(reading));
      return;
    }
  }
  const int more = option->form == kTwo ? 1 : option->form == kFour ? 3 : 0;
  for (int i = 0; i < more && at < arguments.size(); ++i) value += " " + arguments[at++];
  const auto goes_on = [form = option->form](std::string_view word) {
    if (form == kRegisters && word.size() > 1 && IsRegisterLetter(word[0])) word.remove_prefix(1);
    return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
  };
  const bool is_list = option->form == kNumbers || option->form == kRegisters;
  while (is_list && at < arguments.size() && goes_on(arguments[at])) value += " " + arguments[at++];
  option->read(reading, value);
}

// ---- what the options say together

// Settles -P FILE, or -P alone and -Fi FILE, as newer releases of dxc take it.
void FinishPreprocess(Reading& reading) {
  CommandLine& command = reading.command;
  if (reading.preprocesses_only) {
    command.preprocessed = std::exchange(command.output, {});
    if (command.preprocessed.empty()) command.preprocessed = "-";
  }
  if (!reading.preprocess) return;
  command.preprocessed = reading.preprocess_name;
  if (command.inputs.empty() && command.batch.empty() && !command.preprocessed.empty())
    command.inputs.push_back(std::exchange(command.preprocessed, {}));
  if (!reading.preprocess_output.empty()) command.preprocessed = reading.preprocess_output;
  if (command.preprocessed.empty()) command.preprocessed = ".i";
}

// Settles what is written for which target: the one that the user names, or without a name `vulkan`
// for SPIR-V that is not for OpenGL. As glslang's, --vn makes a header of -o.
void FinishTarget(Reading& reading) {
  CommandLine& command = reading.command;
  ProgramRequest& request = command.request;
  const bool is_spirv = reading.writes_spirv || command.output.ends_with(".spv");
  if (!command.variable.empty() && command.header.empty())
    command.header = std::exchange(command.output, {});
  if (is_spirv) {
    reading.spirv.debug_info = request.outputs.source_lines;
    request.outputs.spirv = reading.spirv;
    if (reading.spirv_for_vulkan) request.target = *glsl::Target::Parse("vulkan");
  }
  if (reading.target) request.target = *reading.target;
  command.names_target = reading.target || is_spirv;
  glsl::BindingRules& bindings = reading.bindings;
  bindings.replaces_tool = reading.is_of_tool && bindings.rules.empty() && !bindings.globals &&
                           !bindings.unplaced_set && !bindings.later_base &&
                           !bindings.keeps_unread && !bindings.splits_arrays &&
                           std::ranges::count(bindings.plain_sets, 0u) == kStageCount;
  request.target.bindings = std::move(bindings);
  if (is_spirv && !reading.spirv_for_vulkan && request.target.IsVulkan())
    reading.Refuse("-G writes SPIR-V for OpenGL, and --target=vulkan is not; give one of the two");
  if (!reading.spirv.entry.empty() && reading.spirv.entry != "main")
    reading.spirv_option =
        reading.source_entry.empty() ? "-fspv-entrypoint-name" : "--source-entrypoint";
  if (!reading.spirv_option.empty() && !is_spirv)
    reading.without_effect.push_back({reading.spirv_option, "it is for SPIR-V"});
  const bool has_precision = is_spirv || request.target.IsEs();
  if (request.style.relaxed_precision && !has_precision && command.batch.empty()) {
    reading.without_effect.push_back(
        {"--min-precision=relaxed", "it is for SPIR-V and for the GLSL of OpenGL ES"});
  }
  if (request.target.bindings.keeps_unread && request.target.IsVulkan() && !is_spirv) {
    reading.without_effect.push_back({reading.vulkan_option, "it is for SPIR-V"});
    request.target.bindings.keeps_unread = false;
  }
  if (reading.joins_samplers && !request.target.IsVulkan() && command.batch.empty()) {
    reading.without_effect.push_back(
        {"--auto-sampled-textures",
         "it is for target `vulkan`; for OpenGL a texture and its sampler are one already"});
  }
  // Each entry of a batch may have a target of its own.
  if (!reading.vulkan_option.empty() && !request.target.IsVulkan() && command.batch.empty()) {
    reading.without_effect.push_back(
        {reading.vulkan_option, fmt::format("it is for target `vulkan`, and this is `{}`",
                                            request.hlsl.wanted ? "hlsl" : request.target.name())});
  }
}

// Names the options about GLSL that the text of the HLSL has no use for.
void ReportForHlsl(Reading& reading) {
  const ProgramRequest& request = reading.command.request;
  if (!request.hlsl.wanted) return;
  const StyleOptions& style = request.style;
  const std::pair<bool, const char*> given[] = {
      {style.clip_space.flip_y, "--flip-y"},
      {style.clip_space.negative_one_to_one, "--depth-range"},
      {style.invariant, "--invariant"},
      {style.base_vertex_is_zero, "--base-vertex"},
      {style.base_instance_is_zero, "--base-instance"},
      {style.separable, "--separable"},
      {style.blocks != glsl::BlockStyle::kNamed, "--blocks"},
      {!style.names.empty(), "--names"},
      {reading.validate == true, "--validate"},
  };
  for (const auto& [is_given, option] : given) {
    if (is_given)
      reading.without_effect.push_back({option, "with --target=hlsl the text stays as it is"});
  }
}

// Settles glslang's -e NAME --source-entrypoint FUNCTION, which gives SPIR-V's entry point a name
// of its own.
void FinishEntry(Reading& reading) {
  if (reading.source_entry.empty()) return;
  std::string& entry = reading.command.request.first().entry;
  reading.spirv.entry = std::exchange(entry, reading.source_entry);
}

// The stage that the names of the files say: "blur.comp", "blur.comp.hlsl"; a vertex shader's where
// a name says none. None if they differ.
std::optional<Stage> StageOfNames(const std::vector<std::string>& files) {
  std::optional<Stage> all;
  for (std::string_view file : files) {
    if (file.ends_with(".hlsl")) file.remove_suffix(5);
    const std::size_t dot = file.rfind('.');
    const auto named = dot == file.npos ? std::nullopt : StageOfExtension(file.substr(dot + 1));
    const Stage stage = named.value_or(Stage::kVertex);
    if (all.value_or(stage) != stage) return std::nullopt;
    all = stage;
  }
  return all.value_or(Stage::kVertex);
}

// Settles the stage that -S names, or without it, as for glslang, the name of the file.
void FinishStage(Reading& reading) {
  const CommandLine& command = reading.command;
  std::string& name = reading.command.request.first().profile;
  if (reading.names_profile) {
    const auto profile = ir::ParseProfile(name);
    if (reading.stage && profile && profile->stage != reading.stage)
      reading.Refuse(fmt::format("-S names a {} shader, and profile `{}` is of another one",
                                 InfoOf(*reading.stage).name, name));
    return;
  }
  const bool by_name = !reading.stage && !command.request.hlsl.wanted;
  const auto stage = by_name         ? StageOfNames(command.inputs)
                     : reading.stage ? reading.stage
                                     : Stage::kVertex;
  if (!stage)
    reading.Refuse("the names of the files are of shaders of several stages; -T says which");
  else if (*stage != Stage::kVertex)
    name = fmt::format("{}_5_0", InfoOf(*stage).prefix);
}

// The profile of a shader that is compiled beside a vertex shader: of the same model, or of the
// first one where there is none that clipc knows.
std::string ProfileBeside(const std::string& vertex, Stage stage) {
  std::string name = vertex;
  name.replace(0, 2, InfoOf(stage).prefix);
  const auto profile = ir::ParseProfile(name);
  if (profile && profile->IsAtLeast(2, 0)) return name;
  return InfoOf(stage).draws_pixels ? "ps_2_0" : ir::ProfilesOf(stage).front();
}

// Settles what the program is: a shader after the first is compiled where its output is named, and
// rewritten where HLSL is given its entry; elsewhere it is a neighbour.
void FinishProgram(CommandLine& command) {
  ProgramRequest& request = command.request;
  for (std::size_t i = 0; i < command.middle.size(); ++i) {
    const auto& [entry, output] = command.middle[i];
    if (entry.empty() || output.empty()) continue;
    request.shaders.push_back(
        {.entry = entry, .profile = ProfileBeside(request.first().profile, kMiddleStages[i])});
  }
  const ShaderSource& given = command.pixel_shader;
  request.hlsl.in_one_file = given.path.empty() && command.pixel_output.empty();
  if (command.pixel_output.empty() && (!request.hlsl.wanted || given.entry.empty())) {
    if (!given.path.empty()) request.neighbour = {.path = given.path, .entry = given.entry};
    return;
  }
  ShaderSource next = given;
  if (next.entry.empty() && !next.path.empty()) next.entry = "main";
  if (next.profile.empty()) next.profile = ProfileBeside(request.first().profile, Stage::kPixel);
  request.shaders.push_back(std::move(next));
}

// Settles the options about bindings that depend on each other.
void FinishBindings(Reading& reading) {
  glsl::BindingRules& bindings = reading.bindings;
  const auto is_of_kind = [](const glsl::BindingRule& rule) {
    return rule.letter == glsl::kImages || rule.letter == glsl::kStorageBlocks;
  };
  // The kind of an object decides before its register, as in glslang, and never with --hlsl-iomap.
  std::ranges::stable_partition(bindings.rules, std::not_fn(is_of_kind));
  if (reading.maps_registers) {
    std::erase_if(bindings.rules, is_of_kind);
    for (const std::string& option : reading.kind_shifts)
      reading.without_effect.push_back({option, "under --hlsl-iomap the registers decide"});
  }
  if (reading.joins_samplers) JoinSamplers(bindings);
}

// The error that names every unknown option.
std::string UnknownOptions(const Reading& reading) {
  std::string text = reading.unknown.size() > 1 ? "unknown options" : "";
  for (const auto& [option, advice] : reading.unknown) {
    text +=
        text.empty() ? fmt::format("unknown option `{}`", option) : fmt::format("\n  `{}`", option);
    if (!advice.empty()) text += "; " + advice;
  }
  return text;
}

void ReportWithoutEffect(Reading& reading) {
  CommandLine& command = reading.command;
  for (const Reading::Ignored& ignored : reading.without_effect)
    command.notices.Report({}, diag::OptionWithoutEffect, ignored.option, ignored.why);
  if (!reading.foreign_warnings.empty()) {
    command.notices.Report({}, diag::UnknownWarningOption,
                           fmt::format("{}", fmt::join(reading.foreign_warnings, "`, `")));
  }
}

}  // namespace

std::string NeedsValue(const Reading& reading) {
  const std::string problem = fmt::format("{} needs a value", reading.argument);
  return reading.next.empty() ? problem
                              : fmt::format("{}; `{}` is an option", problem, reading.next);
}

ParsedCommandLine ParseCommandLine(std::span<const char* const> arguments) {
  Reading reading;
  std::vector<std::string> words;
  for (const char* argument : arguments) {
    reading.result = Expand(argument, 0, words, reading.command.response_files);
    if (!reading.result) break;
  }
  for (std::size_t at = 0; at < words.size() && reading.result;) ReadArgument(words, at, reading);
  CommandLine& command = reading.command;
  FinishBindings(reading);
  if (!reading.unknown.empty()) reading.Refuse(UnknownOptions(reading));
  FinishEntry(reading);
  FinishStage(reading);
  FinishProgram(command);
  // Where nothing is known to read them, all outputs are kept.
  if (reading.preserves_interface && command.request.is_linked())
    command.request.link.keep_outputs = true;
  FinishPreprocess(reading);
  FinishTarget(reading);
  ReportForHlsl(reading);
  if (reading.validate == true && command.request.outputs.spirv)
    reading.without_effect.push_back({"--validate", "it is for GLSL; `spirv-val` is for SPIR-V"});
  // A remark about the options is a warning even where the shader's warnings are errors.
  WarningOptions warnings = command.request.warnings;
  warnings.warnings_are_errors = false;
  command.notices = Diagnostics(warnings);
  ReportWithoutEffect(reading);
  // glslang's tables cost tens of milliseconds once: much for one shader, little for many.
  command.request.outputs.validate = reading.validate.value_or(false);
  return {std::move(command), std::move(reading.result)};
}

namespace {

// The names of the options of other compilers, in lines.
std::string CompilersHelp() {
  constexpr std::size_t kWidth = 98;
  std::string text;
  bool is_wanted = false;
  std::size_t width = kWidth;
  for (const Option& option : ForeignOptions()) {
    if (option.IsTopic()) {
      is_wanted = option.metavar == std::string_view(kCompilersTopic);
      if (is_wanted)
        text += fmt::format("{}{}: {}", text.empty() ? "" : "\n\n", option.metavar, option.help);
      width = kWidth;
    }
    for (const std::string_view name : WordsIn(option.names)) {
      if (!is_wanted) continue;
      const bool is_new = width + 1 + name.size() > kWidth;
      text += fmt::format("{}{}", is_new ? "\n  " : " ", name);
      width = is_new ? 2 + name.size() : width + 1 + name.size();
    }
  }
  return text + "\n";
}

}  // namespace

std::string HelpText(std::string_view topic) {
  if (topic == kCompilersTopic) return CompilersHelp();
  constexpr std::size_t kColumn = 25;
  std::string text;
  if (topic.empty()) {
    text =
        "clipc translates HLSL, shaders and effects, into GLSL or SPIR-V, and keeps their clip "
        "planes.\n\n"
        "USAGE: clipc [options] FILE...      (- is standard input, @FILE is more options)\n";
  }
  bool is_wanted = false;
  for (const Option& option : OwnOptions()) {
    if (option.IsTopic()) {
      is_wanted = topic.empty() || topic == option.metavar;
      if (is_wanted)
        fmt::format_to(std::back_inserter(text), "{}{}: {}\n", text.empty() ? "" : "\n",
                       option.metavar, option.help);
      continue;
    }
    if (!is_wanted || !option.metavar) continue;
    const char* separator = option.form == kEquals ? "=" : option.form == kJoined ? "" : " ";
    const std::string usage =
        fmt::format("  {}{}{}", option.names, *option.metavar ? separator : "", option.metavar);
    fmt::format_to(std::back_inserter(text), "{:<{}}{}{}\n", usage, kColumn,
                   usage.size() < kColumn ? "" : "\n" + std::string(kColumn, ' '), option.help);
  }
  return text;
}

}  // namespace clipc
