// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/options.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <fmt/format.h>

#include "base/spelling.h"
#include "compiler/suggest.h"

namespace clipc {
namespace {

// What the arguments so far say.
struct Reading {
  CommandLine command;
  std::optional<bool> validate;  // what the user asks for
  std::string option;            // the one whose value is being read
  std::string error;
};

enum class Form : std::uint8_t {
  kFlag,
  kJoined,            // -Wno-x
  kJoinedOrSeparate,  // -Dx or -D x
  kEquals,            // --target=x or --target x
};

struct Option {
  std::string_view name;
  Form form;
  void (*read)(Reading& reading, const std::string& value);
  // For --help. An option without help is another spelling, or one of fxc's without effect.
  const char* metavar = "";
  const char* help = nullptr;
};

// ---- what an option does with its value

void Ignore(Reading&, const std::string&) {}

template <typename Owner, typename Value>
Value& MemberOf(CommandLine& command, Value Owner::* member) {
  CompileRequest& request = command.request;
  return std::get<Owner&>(
             std::tie(command, request, request.clip_space, request.warnings, request.debug)).*
         member;
}

// A flag becomes true, a list gets one more, a text is replaced.
template <auto kMember>
void Set(Reading& reading, const std::string& value) {
  auto& member = MemberOf(reading.command, kMember);
  if constexpr (std::is_same_v<decltype(member), bool&>) {
    member = true;
  } else if constexpr (requires { member.push_back(value); }) {
    member.push_back(value);
  } else {
    member = value;
  }
}

template <auto kMember, auto kValue>
void SetTo(Reading& reading, const std::string&) {
  MemberOf(reading.command, kMember) = kValue;
}

template <bool kOn>
void SetValidate(Reading& reading, const std::string&) {
  reading.validate = kOn;
}

// One of a few words, which stand in the order of the enumerators.
template <typename Enum, auto kMember, const auto& kNames>
void Choose(Reading& reading, const std::string& value) {
  if (const auto choice = EnumeratorOf<Enum>(value, kNames)) {
    MemberOf(reading.command, kMember) = *choice;
    return;
  }
  const std::vector<std::string_view> names(std::begin(kNames), std::end(kNames));
  reading.error =
      fmt::format("unknown value `{}` of {}{}", value, reading.option, Suggest(value, names));
}

// A number from kLeast to kMost.
template <auto kMember, unsigned kLeast, unsigned kMost>
void SetNumber(Reading& reading, const std::string& value) {
  auto& to = MemberOf(reading.command, kMember);
  const char* const end = value.data() + value.size();
  const auto [after, problem] = std::from_chars(value.data(), end, to);
  if (problem == std::errc() && after == end && to >= kLeast && to <= kMost) return;
  reading.error = fmt::format("`{}{}`: it must be a number from {} to {}", reading.option, value,
                              kLeast, kMost);
}

void SetVariants(Reading& reading, const std::string& value) {
  reading.command.request.variants = true;
  SetNumber<&CompileRequest::variant_planes, 0, kMaxClipPlanes>(reading, value);
}

void SetDependencyFile(Reading& reading, const std::string& value) {
  reading.command.write_dependencies = true;
  reading.command.dependency_file = value;
}

// -Wno-clip-plane-twice, -Werror, -Werror=..., -Wno-error=...
void SetWarning(Reading& reading, const std::string& value) {
  WarningOptions& warnings = reading.command.request.warnings;
  std::string_view name = value;
  if (name == "all" || name == "extra") return;  // every warning is on anyway
  const auto take = [&](std::string_view prefix) {
    const bool has = name.starts_with(prefix);
    if (has) name.remove_prefix(prefix.size());
    return has;
  };
  const bool is_on = !take("no-");
  if (name == "error") {
    warnings.warnings_are_errors = is_on;
    return;
  }
  const bool is_error = take("error=");
  const std::optional<DiagId> id = DiagIdOf(name);
  if (id && InfoOf(*id).severity == Severity::kWarning) {
    const auto index = static_cast<std::size_t>(*id);
    is_error ? warnings.as_error[index] = is_on : warnings.off[index] = !is_on;
    return;
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kDiagCount; ++i) {
    const auto other = static_cast<DiagId>(i);
    if (InfoOf(other).severity == Severity::kWarning) names.push_back(PrintedName(other));
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  reading.error = fmt::format("unknown warning `{}`{}", name,
                              NearNames(name, views).empty() ? "" : Suggest(name, views));
}

// ---- the table

constexpr const char* kDepthRanges[] = {"zero-to-one", "negative-one-to-one"};
constexpr const char* kFormats[] = {"text", "msvc", "json", "sarif"};
constexpr const char* kStages[] = {"tokens", "ast", "ir", "glsl", "table"};

using enum Form;
using Action = CommandLine::Action;
using Request = CompileRequest;

constexpr Option kOptions[] = {
    {"--depth-range", kEquals,
     Choose<bool, &passes::ClipSpaceOptions::negative_one_to_one, kDepthRanges>, "<RANGE>",
     "zero-to-one (as the HLSL writes it, the default) or negative-one-to-one"},
    {"--diagnostics", kEquals, Choose<MessageFormat, &CommandLine::format, kFormats>, "<FORM>",
     "text, msvc, json or sarif; on standard error"},
    {"--dump-after", kEquals, Set<&DebugOptions::dump_after>, "<PASS>",
     "print the program after a pass"},
    {"--dump", kEquals, Choose<DumpStage, &DebugOptions::dump, kStages>, "<STAGE>",
     "print tokens, ast, ir, glsl or table and stop there"},
    {"-D", kJoinedOrSeparate, Set<&Request::defines>, "<NAME[=VALUE]>", "define a macro"},
    {"-E", kJoinedOrSeparate, Set<&Request::entry>, "<NAME>", "entry function (main)"},
    {"--flip-y", kFlag, Set<&passes::ClipSpaceOptions::flip_y>, "",
     "negate gl_Position.y, after the clip planes"},
    {"-Fo", kJoinedOrSeparate, Set<&CommandLine::output>},
    {"--fragment", kEquals, Set<&CommandLine::fragment>, "<FILE>",
     "with --lower=discard: add the discard to this GLSL; written as .frag"},
    {"-Gec", kFlag, Ignore},
    {"-Ges", kFlag, Ignore},
    {"-Gis", kFlag, Ignore},
    {"--help", kFlag, SetTo<&CommandLine::action, Action::kHelp>, "", "print this"},
    {"-h", kFlag, SetTo<&CommandLine::action, Action::kHelp>},
    {"-I", kJoinedOrSeparate, Set<&Request::include_dirs>, "<DIR>", "look for includes here too"},
    {"-j", kJoinedOrSeparate, SetNumber<&CommandLine::jobs, 1, 256>, "<N>",
     "compile N of several files at once"},
    {"--lower", kEquals, Choose<Lowering, &Request::lowering, kLoweringNames>, "<HOW>",
     "clip planes: clip-distance, level9 (the default of level_9_x), near-plane, discard or none"},
    {"-MD", kFlag, Set<&CommandLine::write_dependencies>, "",
     "write a make rule with the files read, beside the output"},
    {"-MF", kJoinedOrSeparate, SetDependencyFile, "<FILE>", "write that rule to FILE"},
    {"-MT", kJoinedOrSeparate, Set<&CommandLine::dependency_target>, "<NAME>",
     "the target of that rule (the output file)"},
    {"--no-validate", kFlag, SetValidate<false>, "",
     "do not run glslang (the default for a single file)"},
    {"-nologo", kFlag, Ignore},
    {"-O", kJoined, Ignore},
    {"-o", kJoinedOrSeparate, Set<&CommandLine::output>, "<FILE>",
     "the GLSL: a file, standard output (-, the default), or a folder for several files"},
    {"--plane-space", kEquals, Choose<PlaneSpace, &Request::plane_space, kPlaneSpaceNames>,
     "<SPACE>",
     "the planes' space: clip (the default, fxc's), xyw1 or object, which lose fewer digits"},
    {"--position-input", kEquals, Set<&Request::position_input>, "<SEMANTIC>",
     "the input that --plane-space=object clips by (POSITION0)"},
    {"--reflect", kEquals, Set<&CommandLine::reflection>, "<FILE>",
     "write inputs, outputs, buffers and planes as JSON"},
    {"--separable", kFlag, Set<&Request::separable>, "",
     "redeclare gl_PerVertex, for glUseProgramStages"},
    {"--stop-after", kEquals, Set<&DebugOptions::stop_after>, "<PASS>",
     "stop after a pass and print the program"},
    {"--table", kEquals, Set<&CommandLine::table>, "<FILE>",
     "write the clip table: .json, .bin (Direct3D's record) or .h"},
    {"--target", kEquals, Set<&Request::target>, "<GLSL>",
     "glsl120 .. glsl460 (glsl450), vulkan, essl300, essl310, essl320"},
    {"-T", kJoinedOrSeparate, Set<&Request::profile>, "<PROFILE>",
     "vs_2_0 .. vs_6_8 (vs_5_0), vs_4_0_level_9_0, _9_1, _9_3"},
    {"--validate", kFlag, SetValidate<true>, "",
     "compile the GLSL with glslang before writing it (the default for several files)"},
    {"--variants", kFlag, Set<&Request::variants>, "",
     "one shader for each number of clip planes: x.0.vert, x.1.vert .."},
    {"--variants=", kJoined, SetVariants, "<N>", "the same, up to N planes"},
    {"--verify", kFlag, Set<&DebugOptions::verify>},
    {"--version", kFlag, SetTo<&CommandLine::action, Action::kVersion>, "", "print the version"},
    {"-WX", kFlag, Set<&WarningOptions::warnings_are_errors>},
    {"-W", kJoined, SetWarning, "<NAME>",
     "-Wno-<NAME> and -W<NAME>: a warning off and on; -Werror: warnings are errors"},
    {"-w", kFlag, Set<&WarningOptions::no_warnings>, "", "print no warnings"},
    {"-Zi", kFlag, Ignore},
    {"-Zpc", kFlag, SetTo<&Request::packing, MatrixPacking::kColumnMajor>, "",
     "matrices are column-major in memory (the default)"},
    {"-Zpr", kFlag, SetTo<&Request::packing, MatrixPacking::kRowMajor>, "",
     "matrices are row-major in memory"},
    {"-Zsb", kFlag, Ignore},
    {"-Zss", kFlag, Ignore},
};

// ---- arguments

// The option that an argument is, or begins with: the one with the longest such name.
const Option* Find(std::string_view argument) {
  const Option* found = nullptr;
  for (const Option& option : kOptions) {
    if (!argument.starts_with(option.name)) continue;
    const std::string_view rest = argument.substr(option.name.size());
    const bool fits = rest.empty() || option.form == kJoined || option.form == kJoinedOrSeparate ||
                      (option.form == kEquals && rest.starts_with('='));
    if (fits && (!found || option.name.size() > found->name.size())) found = &option;
  }
  return found;
}

// Whether an argument that starts with a slash is a path: it exists, or something could be made
// there.
bool LooksLikePath(const std::filesystem::path& argument) {
  std::error_code error;
  return std::filesystem::exists(argument, error) ||
         (argument.has_parent_path() && argument.parent_path() != argument.root_path() &&
          std::filesystem::is_directory(argument.parent_path(), error));
}

// "did you mean" for an option that is none.
std::string NearOption(std::string_view argument) {
  const std::string_view name = argument.substr(0, argument.find('='));
  std::vector<std::string_view> names;
  for (const Option& option : kOptions) names.push_back(option.name);
  const auto near = NearNames(name, names);
  return near.empty()
             ? ""
             : fmt::format("; did you mean `{}{}`?", near[0], argument.substr(name.size()));
}

}  // namespace

ParsedCommandLine ParseCommandLine(std::span<const char* const> arguments) {
  Reading reading;
  for (std::size_t i = 0; i < arguments.size() && reading.error.empty(); ++i) {
    std::string argument = arguments[i];
    const bool has_dash = argument.size() > 1 && argument[0] == '-';
    const bool has_slash = argument.size() > 1 && argument[0] == '/' && !LooksLikePath(argument);
    if (has_slash) argument[0] = '-';
    const Option* option = has_dash || has_slash ? Find(argument) : nullptr;
    if (!option && has_dash) {
      reading.error = fmt::format("unknown option `{}`{}", argument, NearOption(argument));
    } else if (!option) {
      reading.command.inputs.emplace_back(arguments[i]);
    } else {
      std::string value = argument.substr(option->name.size());
      const bool is_next =
          value.empty() && (option->form == kEquals || option->form == kJoinedOrSeparate);
      if (option->form == kEquals && !value.empty()) value.erase(0, 1);
      if (is_next && ++i == arguments.size()) {
        reading.error = fmt::format("{} needs a value", arguments[i - 1]);
        break;
      }
      if (is_next) value = arguments[i];
      reading.option = option->name;
      option->read(reading, value);
    }
  }
  // glslang's tables cost tens of milliseconds once: much for one shader, little for many.
  reading.command.request.validate = reading.validate.value_or(reading.command.inputs.size() > 1);
  return {std::move(reading.command), std::move(reading.error)};
}

std::string HelpText() {
  constexpr std::size_t kColumn = 25;
  std::string text =
      "OVERVIEW: HLSL vertex shaders with [clipplanes] to GLSL and a Direct3D 9 clip table\n\n"
      "USAGE: clipc [options] FILE...\n\nOPTIONS:\n";
  for (const Option& option : kOptions) {
    if (!option.help) continue;
    const char* separator = option.form == kEquals             ? "="
                            : option.form == kJoinedOrSeparate ? " "
                                                               : "";
    const std::string usage = fmt::format("  {}{}{}", option.name, separator, option.metavar);
    fmt::format_to(std::back_inserter(text), "{:<{}}{}{}\n", usage, kColumn,
                   usage.size() < kColumn ? "" : "\n" + std::string(kColumn, ' '), option.help);
  }
  return text;
}

}  // namespace clipc
