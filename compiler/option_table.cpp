// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/option_table.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <tuple>
#include <type_traits>

#include <fmt/format.h>

#include "base/spelling.h"
#include "compiler/binding_options.h"
#include "compiler/suggest.h"

namespace clipc {
namespace {

using rules::PositionName;

// ---- what an option does with its value

// Ignores an option for the code of another compiler, which GLSL has no use for.
void Ignore(Reading&, const std::string&) {}

void HasNoEffect(Reading& reading, const std::string&) {
  reading.without_effect.push_back({reading.option, reading.advice});
}

void Refuse(Reading& reading, const std::string&) {
  reading.error = fmt::format("unknown option `{}`; {}", reading.option, reading.advice);
}

template <typename Owner, typename Value>
Value& MemberOf(Reading& reading, Value Owner::* member) {
  CommandLine& command = reading.command;
  CompileRequest& request = command.request;
  return std::get<Owner&>(std::tie(reading, reading.spirv, command, request, request.includes,
                                   request.language, request.planes, request.style,
                                   request.style.clip_space, request.link,
                                   request.link.pixel_shader, request.outputs, request.warnings,
                                   request.limits, request.debug)).*
         member;
}

// Sets a member: a flag becomes true, a list gets one more value, a text is replaced.
template <auto kMember>
void Set(Reading& reading, const std::string& value) {
  auto& member = MemberOf(reading, kMember);
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
  MemberOf(reading, kMember) = kValue;
}

// Reads one of the words of a table.
template <auto kMember, const auto& kNames>
void Choose(Reading& reading, const std::string& value) {
  if (const auto choice = EnumeratorOf(value, kNames)) {
    MemberOf(reading, kMember) = *choice;
    return;
  }
  std::vector<std::string_view> names;
  for (const auto& named : kNames) names.emplace_back(named.name);
  reading.error =
      fmt::format("unknown value `{}` of {}{}", value, reading.option, Suggest(value, names));
}

// Reads a number from kLeast to kMost.
template <auto kMember, unsigned kLeast, unsigned kMost>
void SetNumber(Reading& reading, const std::string& value) {
  std::uint32_t number = 0;
  if (ReadNumber(value, number) && number >= kLeast && number <= kMost) {
    MemberOf(reading, kMember) = number;
    return;
  }
  reading.error = fmt::format("`{}{}`: it must be a number from {} to {}", reading.option, value,
                              kLeast, kMost);
}

void SetTarget(Reading& reading, const std::string& value) {
  reading.target = glsl::Target::Parse(value);
  if (!reading.target) {
    reading.error =
        fmt::format("unknown target `{}`{}", value, Suggest(value, glsl::Target::Names()));
  }
}

// Reads "2/4", the number of a shard and the number of shards.
void SetShard(Reading& reading, const std::string& value) {
  CommandLine& command = reading.command;
  const std::size_t slash = value.find('/');
  if (slash != value.npos && ReadNumber(value.substr(0, slash), command.shard) &&
      ReadNumber(value.substr(slash + 1), command.shards) && command.shard >= 1 &&
      command.shard <= command.shards)
    return;
  reading.error = fmt::format("`{} {}`: it takes a part and the number of parts, as `2/4`",
                              reading.option, value);
}

void SetDependencyFile(Reading& reading, const std::string& value) {
  reading.command.write_dependencies = true;
  reading.command.dependency_file = value;
}

void SetPreprocess(Reading& reading, const std::string& value) {
  reading.preprocess = true;
  reading.preprocess_name = value;
}

template <bool kForVulkan>
void SetSpirv(Reading& reading, const std::string&) {
  reading.writes_spirv = true;
  reading.spirv_for_vulkan = kForVulkan;
}

template <auto kMember>
void SetForZero(Reading& reading, const std::string& value) {
  MemberOf(reading, kMember) = true;
  if (value != "zero")
    reading.error = fmt::format("`{}={}`: it takes `zero`", reading.option, value);
}

// Reads a rule for bindings. The advice of the option says what it takes.
template <bool (*kRead)(glsl::BindingRules&, std::string_view)>
void Bind(Reading& reading, const std::string& value) {
  reading.vulkan_option = reading.option;
  if (!kRead(reading.bindings, value))
    reading.error = fmt::format("`{} {}`: it takes {}", reading.option, value, reading.advice);
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

// Reads -Wno-clip-plane-twice, -Werror, -Werror=... and -Wno-error=...
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
  if (NearNames(name, views).empty()) {
    reading.foreign_warnings.push_back("-W" + value);
  } else {
    reading.error = fmt::format("unknown warning `{}`{}", name, Suggest(name, views));
  }
}

// ---- the table

constexpr Named<bool> kDepthRanges[] = {{false, "zero-to-one"}, {true, "negative-one-to-one"}};
constexpr Named<glsl::BlockStyle> kBlockStyles[] = {{glsl::BlockStyle::kNamed, "named"},
                                                    {glsl::BlockStyle::kPlain, "plain"},
                                                    {glsl::BlockStyle::kFlat, "flat"}};
constexpr Named<MessageFormat> kFormats[] = {{MessageFormat::kText, "text"},
                                             {MessageFormat::kMsvc, "msvc"},
                                             {MessageFormat::kJson, "json"},
                                             {MessageFormat::kSarif, "sarif"}};
// The same formats, as Clang calls them.
constexpr Named<MessageFormat> kClangFormats[] = {{MessageFormat::kText, "clang"},
                                                  {MessageFormat::kMsvc, "msvc"},
                                                  {MessageFormat::kJson, "json"},
                                                  {MessageFormat::kSarif, "sarif"}};
constexpr Named<DumpStage> kStages[] = {{DumpStage::kTokens, "tokens"},
                                        {DumpStage::kAst, "ast"},
                                        {DumpStage::kIr, "ir"},
                                        {DumpStage::kGlsl, "glsl"},
                                        {DumpStage::kTable, "table"}};
constexpr Named<VulkanVersion> kVulkanVersions[] = {{VulkanVersion::k1_0, "vulkan1.0"},
                                                    {VulkanVersion::k1_1, "vulkan1.1"},
                                                    {VulkanVersion::k1_2, "vulkan1.2"},
                                                    {VulkanVersion::k1_3, "vulkan1.3"}};
void SetVulkanVersion(Reading& reading, const std::string& value) {
  reading.vulkan_option = reading.option;
  Choose<&SpirvRequest::vulkan, kVulkanVersions>(reading, value);
}

constexpr char kShift[] = "two numbers, or a number and `all`";
constexpr char kStageShift[] = "a number, or numbers each with its set";
constexpr char kByKind[] =
    "clipc shifts by register: `--shift-texture-binding` moves t, `--shift-uav-binding` u";
constexpr char kFollowRegisters[] = "bindings follow the registers; `--reflect` tells them";
constexpr std::string_view kHlsl = "hlsl", kVert = "vert", kVertex = "vertex";

using enum Option::Form;
using Action = CommandLine::Action;
using Request = CompileRequest;

// The options of --help, in its order; then other spellings and other compilers' options.
constexpr Option kOptions[] = {
    {"-T", kJoinedOrSeparate, Set<&LanguageOptions::profile>, "<PROFILE>",
     "vs_2_0 .. vs_6_8 (vs_5_0), vs_4_0_level_9_0, _9_1, _9_3"},
    {"-E", kJoinedOrSeparate, Set<&LanguageOptions::entry>, "<NAME>", "entry function (main)"},
    {"-D", kJoinedOrSeparate, Set<&Request::defines>, "<NAME[=VALUE]>", "define a macro"},
    {"-I", kJoinedOrSeparate, Set<&IncludeOptions::dirs>, "<DIR>", "look for includes here too"},
    {"-include", kSeparate, Set<&IncludeOptions::forced>, "<FILE>", "include FILE first"},
    {"-HV", kJoinedOrSeparate, Choose<&LanguageOptions::version, kLanguageNames>, "<YEAR>",
     "2016, 2017, 2018 or 2021 (2021): from shader model 6 on"},
    {"-Zpc", kFlag, SetTo<&LanguageOptions::packing, MatrixPacking::kColumnMajor>, "",
     "matrices are column-major in memory (the default)"},
    {"-Zpr", kFlag, SetTo<&LanguageOptions::packing, MatrixPacking::kRowMajor>, "",
     "matrices are row-major in memory"},
    {"-o", kJoinedOrSeparate, Set<&CommandLine::output>, "<FILE>",
     "the GLSL: a file, standard output (-, the default), or a folder for several files"},
    {"--target", kEquals, SetTarget, "<GLSL>",
     "glsl120 .. glsl460 (glsl450), vulkan, essl100, essl300 .. essl320, webgl1, webgl2"},
    {"--lower", kEquals, Choose<&PlaneOptions::lowering, kLoweringNames>, "<HOW>",
     "clip planes: clip-distance, level9 (the default of level_9_x), near-plane, discard or none"},
    {"--plane-space", kEquals, Choose<&PlaneOptions::space, kPlaneSpaceNames>, "<SPACE>",
     "the planes' space: clip (the default, fxc's), xyw1 or object, which lose fewer digits"},
    {"--position-input", kEquals, Set<&PlaneOptions::position_input>, "<SEMANTIC>",
     "the input that --plane-space=object clips by (POSITION0)"},
    {"--fragment", kEquals, Set<&CommandLine::fragment>, "<FILE>",
     "with --lower=discard: add the discard to this GLSL; written as .frag"},
    {"--variants", kFlag, SetTo<&PlaneOptions::variants, kMaxClipPlanes>, "",
     "one shader for each number of clip planes: x.0.vert, x.1.vert .."},
    {"--variants=", kJoined, SetNumber<&PlaneOptions::variants, 0, kMaxClipPlanes>, "<N>",
     "the same, up to N planes"},
    {"--depth-range", kEquals, Choose<&passes::ClipSpaceOptions::negative_one_to_one, kDepthRanges>,
     "<RANGE>", "zero-to-one (as the HLSL writes it, the default) or negative-one-to-one"},
    {"--flip-y", kFlag, Set<&passes::ClipSpaceOptions::flip_y>, "",
     "negate gl_Position.y, after the clip planes"},
    {"--separable", kFlag, Set<&StyleOptions::separable>, "",
     "redeclare gl_PerVertex, for glUseProgramStages"},
    {"--blocks", kEquals, Choose<&StyleOptions::blocks, kBlockStyles>, "<FORM>",
     "cbuffers: named (with an instance name, the default), plain or flat uniforms"},
    {"--bindings", kEquals, Bind<AddPreset>, "<NAME>",
     "the bindings of dxc, nvrhi or sdl, with target vulkan"},
    {"--names", kEquals, Set<&StyleOptions::names>, "<STYLE>",
     "of outputs and blocks: hlslcc (the default), dxc, spirv-cross, or vs_{semantic}{index}"},
    {"--pixel-shader", kEquals, Set<&PixelShader::path>, "<FILE>",
     "fit this pixel shader: HLSL, GLSL or SPIR-V"},
    {"--pixel-entry", kEquals, Set<&PixelShader::entry>, "<NAME>",
     "its entry function (main; of SPIR-V the only one)"},
    {"--keep-outputs", kFlag, Set<&LinkOptions::keep_outputs>, "",
     "also those that it does not read"},
    {"--zero-unwritten", kFlag, Set<&LinkOptions::zero_unwritten>},  // its error names it
    {"-Zi", kFlag, Set<&OutputOptions::source_lines>, "",
     "with the lines of the HLSL as comments in the GLSL"},
    {"-Fc", kJoinedOrSeparate, Set<&CommandLine::listing>, "<FILE>",
     "write the GLSL with these comments to FILE"},
    {"-Fh", kJoinedOrSeparate, Set<&CommandLine::header>, "<FILE>",
     "write the GLSL as a C string to FILE; -Vn NAME names it (g_ and the entry's name)"},
    {"-Vn", kJoinedOrSeparate, Set<&CommandLine::variable>},
    {"-spirv", kFlag, SetSpirv<true>, "",
     "write SPIR-V instead of GLSL, for Vulkan; so does a .spv file"},
    {"-G", kFlag, SetSpirv<false>, "", "write SPIR-V for OpenGL 4.5"},
    {"-fspv-target-env", kEquals, SetVulkanVersion, "<VERSION>",
     "vulkan1.0 .. vulkan1.3 (vulkan1.1)"},
    {"--table", kEquals, Set<&CommandLine::table>, "<FILE>",
     "write the clip table: .json, .bin (Direct3D's record) or .h"},
    {"--reflect", kEquals, Set<&CommandLine::reflection>, "<FILE>",
     "write inputs, outputs, buffers and planes as JSON, or with .h buffers as C structs"},
    {"-MD", kFlag, Set<&CommandLine::write_dependencies>, "",
     "write a make rule with the files read, beside the output"},
    {"-MF", kJoinedOrSeparate, SetDependencyFile, "<FILE>", "write that rule to FILE"},
    {"-MT", kJoinedOrSeparate, Set<&CommandLine::dependency_target>, "<NAME>",
     "the target of that rule (the output file)"},
    {"-M", kFlag, Set<&CommandLine::only_dependencies>, "",
     "write only that rule, to standard output or to -MF's file"},
    {"-H", kFlag, Set<&CommandLine::show_includes>, "", "print the files that are included"},
    {"-P", kOptional, SetPreprocess, "<FILE>", "write the preprocessed HLSL to FILE, and stop"},
    {"-fsyntax-only", kFlag, Set<&CommandLine::syntax_only>, "", "write no file"},
    {"--sandbox-includes", kEquals, Set<&IncludeOptions::sandbox>, "<DIR>",
     "read includes from this folder only"},
    {"--validate", kFlag, SetTo<&Reading::validate, true>, "",
     "compile the GLSL with glslang before writing it (the default for several files)"},
    {"--no-validate", kFlag, SetTo<&Reading::validate, false>, "",
     "do not run glslang (the default for a single file)"},
    {"-j", kJoinedOrSeparate, SetNumber<&CommandLine::jobs, 1, 256>, "<N>",
     "compile N of several files at once"},
    {"--batch", kEquals, Set<&CommandLine::batch>, "<FILE>",
     "compile the shaders of a JSON manifest; as -D 'A={0,1}', it writes an index of the outputs"},
    {"--diagnostics", kEquals, Choose<&CommandLine::format, kFormats>, "<FORM>",
     "text, msvc, json or sarif; on standard error"},
    {"-W", kJoined, SetWarning, "<NAME>",
     "-Wno-<NAME> and -W<NAME>: a warning off and on; -Werror: warnings are errors"},
    {"-w", kFlag, Set<&WarningOptions::no_warnings>, "", "print no warnings"},
    {"--dump", kEquals, Choose<&DebugOptions::dump, kStages>, "<STAGE>",
     "print tokens, ast, ir, glsl or table and stop there"},
    {"--help", kFlag, SetTo<&CommandLine::action, Action::kHelp>, "", "print this"},
    {"--version", kFlag, SetTo<&CommandLine::action, Action::kVersion>, "", "print the version"},

    // Options for permutations, for untrusted shaders and for people who work on clipc, and other
    // spellings.
    {"--index", kEquals, Set<&CommandLine::index>},
    {"-k", kFlag, Set<&CommandLine::keep_going>},
    {"--shard", kEquals, SetShard},
    {"--max-seconds", kEquals, SetNumber<&Limits::seconds, 1, 1u << 20>},
    {"--max-bytes", kEquals, SetNumber<&Limits::bytes, 1, 1u << 31>},
    {"--max-tokens", kEquals, SetNumber<&Limits::tokens, 1, 1u << 31>},
    {"--dump-after", kEquals, Set<&DebugOptions::dump_after>},
    {"--stop-after", kEquals, Set<&DebugOptions::stop_after>},
    {"--verify", kFlag, Set<&DebugOptions::verify>},
    {"-Gis", kFlag, Set<&StyleOptions::precise>},
    {"--invariant", kFlag, Set<&StyleOptions::invariant>},
    {"--base-vertex", kEquals, SetForZero<&StyleOptions::base_vertex_is_zero>},
    {"--base-instance", kEquals, SetForZero<&StyleOptions::base_instance_is_zero>},
    {"-fvk-bind-register", kFour, Bind<AddRegister>, nullptr,
     "a register such as b0, its space, a binding and a set"},
    {"-fvk-bind-globals", kTwo, Bind<SetGlobals>, nullptr, "a binding and a set"},
    {"-auto-binding-space", kSeparate, Bind<SetUnplaced>, nullptr, "a set"},
    {"-fvk-b-shift", kTwo, Bind<AddShift<'b'>>, nullptr, kShift},
    {"-fvk-s-shift", kTwo, Bind<AddShift<'s'>>, nullptr, kShift},
    {"-fvk-t-shift", kTwo, Bind<AddShift<'t'>>, nullptr, kShift},
    {"-fvk-u-shift", kTwo, Bind<AddShift<'u'>>, nullptr, kShift},
    {"--shift-ubo-binding --shift-UBO-binding --sub --shift-cbuffer-binding --scb", kNumbers,
     Bind<AddStageShift<'b'>>, nullptr, kStageShift},
    {"--shift-sampler-binding --ssb", kNumbers, Bind<AddStageShift<'s'>>, nullptr, kStageShift},
    {"--shift-texture-binding --stb", kNumbers, Bind<AddStageShift<'t'>>, nullptr, kStageShift},
    {"--shift-uav-binding --shift-UAV-binding --suavb", kNumbers, Bind<AddStageShift<'u'>>, nullptr,
     kStageShift},
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

// Calls visit(spelling) for each name of each option.
constexpr void ForEachSpelling(auto visit) {
  for (const Option& option : kOptions) {
    std::string_view names = option.names;
    while (!names.empty()) {
      const std::string_view name = names.substr(0, names.find(' '));
      visit(Spelling{name, &option});
      names.remove_prefix(std::min(name.size() + 1, names.size()));
    }
  }
}

constexpr std::size_t CountSpellings() {
  std::size_t count = 0;
  ForEachSpelling([&](const Spelling&) { ++count; });
  return count;
}

constexpr auto kSpellings = [] {
  std::array<Spelling, CountSpellings()> all;
  auto next = all.begin();
  ForEachSpelling([&](const Spelling& spelling) { *next++ = spelling; });
  return all;
}();

}  // namespace

std::span<const Option> Options() { return kOptions; }

std::span<const Spelling> Spellings() { return kSpellings; }

Spelling FindOption(std::string_view argument) {
  Spelling found;
  for (const Spelling& spelling : Spellings()) {
    if (!argument.starts_with(spelling.name)) continue;
    const std::string_view rest = argument.substr(spelling.name.size());
    const Option::Form form = spelling.option->form;
    const bool fits = rest.empty() || form == kJoined || form == kJoinedOrSeparate ||
                      form == kOptional ||
                      ((form == kEquals || form == kNumbers) && rest.starts_with('='));
    if (fits && spelling.name.size() > found.name.size()) found = spelling;
  }
  return found;
}

}  // namespace clipc
