// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "compiler/binding_options.h"
#include "compiler/option_actions.h"

// The options that people know from fxc, dxc, glslang and C compilers.
namespace clipc {
namespace {

using rules::PositionName;

// Ignores an option for the code of another compiler, which GLSL has no use for.
void Ignore(Reading&, const std::string&) {}

void HasNoEffect(Reading& reading, const std::string&) {
  reading.without_effect.push_back({reading.option, reading.advice});
}

void Refuse(Reading& reading, const std::string&) {
  reading.error = fmt::format("unknown option `{}`; {}", reading.option, reading.advice);
}

// -Gec and -Ges exclude each other, as in fxc.
template <PositionName kName>
void SetPositionName(Reading& reading, const std::string&) {
  PositionName& name = reading.command.request.language.position_name;
  if (name != PositionName::kSystemValue && name != kName)
    reading.error = "-Gec and -Ges contradict each other";
  name = kName;
}

void AddStandardInput(Reading& reading, const std::string&) {
  reading.command.inputs.emplace_back("-");
}

void Undefine(Reading& reading, const std::string& value) {
  std::erase_if(reading.command.request.defines, [&](const std::string& define) {
    return define.substr(0, define.find('=')) == value;
  });
}

// Reads -O, -O0 to -O4, -Od, -Op, -Os and -Oz: how hard another compiler works on its code.
void SetOptimisation(Reading& reading, const std::string& value) {
  if (value.empty() ||
      (value.size() == 1 && std::string_view("01234dpsz").find(value[0]) != std::string_view::npos))
    return;
  reading.error = fmt::format("unknown option `-O{}`", value);
}

// Requires the one value that clipc has, of those that another compiler knows.
template <const auto& kValue>
void RequireValue(Reading& reading, const std::string& value) {
  if (value != kValue)
    reading.error = fmt::format("`{} {}`: clipc has `{}` only", reading.option, value, kValue);
}

// The same formats, as Clang calls them.
constexpr Named<MessageFormat> kClangFormats[] = {{MessageFormat::kText, "clang"},
                                                  {MessageFormat::kMsvc, "msvc"},
                                                  {MessageFormat::kJson, "json"},
                                                  {MessageFormat::kSarif, "sarif"}};
constexpr char kShift[] = "two numbers, or a number and `all`";
constexpr char kKindShift[] = "a number, or numbers each with its set";
constexpr char kByKind[] =
    "clipc shifts by register: `--shift-texture-binding` moves t, `--shift-uav-binding` u";
constexpr char kFollowRegisters[] = "bindings follow the registers; `--reflect` tells them";
constexpr std::string_view kHlsl = "hlsl", kVert = "vert", kVertex = "vertex";

using enum Option::Form;
using Action = CommandLine::Action;
using Request = CompileRequest;

// Those that clipc has, by other names too; then those without effect; then those that it refuses.
constexpr Option kForeignOptions[] = {
    {"-fvk-bind-register", kFour, Bind<AddRegister>, nullptr,
     "a register such as b0, its space, a binding and a set"},
    {"-fvk-bind-globals", kTwo, Bind<SetGlobals>, nullptr, "a binding and a set"},
    {"-auto-binding-space", kSeparate, Bind<SetUnplaced>, nullptr, "a set"},
    {"-fvk-b-shift", kTwo, Bind<AddShift<'b'>>, nullptr, kShift},
    {"-fvk-s-shift", kTwo, Bind<AddShift<'s'>>, nullptr, kShift},
    {"-fvk-t-shift", kTwo, Bind<AddShift<'t'>>, nullptr, kShift},
    {"-fvk-u-shift", kTwo, Bind<AddShift<'u'>>, nullptr, kShift},
    {"--shift-ubo-binding --shift-UBO-binding --sub --shift-cbuffer-binding --scb", kNumbers,
     Bind<AddKindShift<'b'>>, nullptr, kKindShift},
    {"--shift-sampler-binding --ssb", kNumbers, Bind<AddKindShift<'s'>>, nullptr, kKindShift},
    {"--shift-texture-binding --stb", kNumbers, Bind<AddKindShift<'t'>>, nullptr, kKindShift},
    {"--shift-uav-binding --shift-UAV-binding --suavb", kNumbers, Bind<AddKindShift<'u'>>, nullptr,
     kKindShift},
    {"-V", kFlag, SetSpirv<true>},
    {"-Fo", kJoinedOrSeparate, Set<&CommandLine::output>},
    {"-e", kSeparate, Set<&LanguageOptions::entry>},
    {"-fentry-point", kEquals, Set<&LanguageOptions::entry>},
    {"-isystem -iquote", kSeparate, Set<&IncludeOptions::dirs>},
    {"-U", kJoinedOrSeparate, Undefine},
    {"-std=hlsl", kJoined, Choose<&LanguageOptions::version, kLanguageNames>},
    {"--invert-y -fvk-invert-y", kFlag, Set<&passes::ClipSpaceOptions::flip_y>},
    {"-g", kFlag, Set<&OutputOptions::source_lines>},
    {"--vn", kSeparate, Set<&CommandLine::variable>},
    {"-MMD", kFlag, Set<&CommandLine::write_dependencies>},
    {"-MM", kFlag, Set<&CommandLine::only_dependencies>},
    {"-MQ", kJoinedOrSeparate, Set<&CommandLine::dependency_target>},
    {"--depfile", kEquals, SetDependencyFile},
    {"-MP", kFlag, Ignore},
    {"-Vi", kFlag, Set<&CommandLine::show_includes>},
    {"-Fi", kJoinedOrSeparate, Set<&Reading::preprocess_output>},
    {"-Vd", kFlag, SetTo<&Reading::validate, false>},
    {"-WX", kFlag, Set<&WarningOptions::warnings_are_errors>},
    {"-no-warnings", kFlag, Set<&WarningOptions::no_warnings>},
    {"-h -? -help", kFlag, SetTo<&CommandLine::action, Action::kHelp>},
    {"--stdin", kFlag, AddStandardInput},
    {"-fdiagnostics-format", kEquals, Choose<&CommandLine::format, kClangFormats>},
    {"-fcolor-diagnostics", kFlag, SetTo<&CommandLine::colour, true>},
    {"-fno-color-diagnostics", kFlag, SetTo<&CommandLine::colour, false>},
    {"-x", kSeparate, RequireValue<kHlsl>},
    {"-S", kSeparate, RequireValue<kVert>},
    {"-fshader-stage", kEquals, RequireValue<kVertex>},

    // Options for the code, the listing or the effort of another compiler. --hlsl-iomap maps by
    // register, as clipc does.
    {"-nologo --hlsl-iomap -Zss -Zsb -Zs -Cc -c -Gpp -all_resources_bound -all-resources-bound "
     "-enable_unbounded_descriptor_tables -res_may_alias -res-may-alias -Qembed_debug "
     "-Qsource_in_debug_module",
     kFlag, Ignore},
    {"-Qstrip_", kJoined, Ignore},
    {"-O", kJoined, SetOptimisation},

    {"-Gec", kFlag, SetPositionName<PositionName::kBoth>},
    {"-Ges", kFlag, SetPositionName<PositionName::kStrict>},

    // Options whose meaning is lost.
    {"-Fd", kJoinedOrSeparate, HasNoEffect, nullptr,
     "GLSL has no debug database; -Zi keeps the lines of the HLSL"},
    {"-Gfa", kFlag, HasNoEffect, nullptr,
     "GLSL has no such mode; `[flatten]` on a statement reaches Vulkan's drivers"},
    {"-Gfp", kFlag, HasNoEffect, nullptr,
     "GLSL has no such mode; `[branch]` on a statement reaches Vulkan's drivers"},
    {"-Ni -No -Lx", kFlag, HasNoEffect, nullptr, "the listing is GLSL"},

    // Options whose meaning clipc does not have.
    {"-Entry -entry", kJoined, Refuse, nullptr, "did you mean `-E`?"},
    {"-Define -define", kJoined, Refuse, nullptr, "did you mean `-D`?"},
    {"-Target -target -profile -Profile", kJoined, Refuse, nullptr,
     "did you mean `-T` or `--target`?"},
    {"-Include", kJoined, Refuse, nullptr, "did you mean `-I` or `-include`?"},
    {"-opt-", kJoined, Refuse, nullptr, "clipc leaves optimisation to the driver"},
    {"-output -Output", kJoined, Refuse, nullptr, "did you mean `-o`?"},
    {"-fspv-", kJoined, Refuse, nullptr, "the SPIR-V is what glslang makes of the GLSL"},
    {"-fvk-", kJoined, Refuse, nullptr, kFollowRegisters},
    {"--shift-image-binding --sib --shift-ssbo-binding --sbb", kNumbers, Refuse, nullptr, kByKind},
    {"--shift- --auto-map-", kJoined, Refuse, nullptr, kFollowRegisters},
    {"-enable-16bit-types", kFlag, Refuse, nullptr,
     "`half` and `min16float` are computed and stored at 32 bits"},
    {"-Fe", kJoinedOrSeparate, Refuse, nullptr, "messages go to standard error"},
    {"-Fre", kJoinedOrSeparate, Refuse, nullptr, "`--reflect` writes the reflection as JSON"},
    {"-Frs -Fsh -setrootsignature -extractrootsignature -verifyrootsignature -getprivate "
     "-setprivate -dumpbin -compress -decompress",
     kJoined, Refuse, nullptr, "it is for compiled shaders of Direct3D"},
    {"-Gch -Gdp -LD -Fx -Fl", kJoined, Refuse, nullptr,
     "it is for effects and libraries; clipc compiles one shader"},
};

}  // namespace

std::span<const Option> ForeignOptions() { return kForeignOptions; }

}  // namespace clipc
