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
  reading.unknown.emplace_back(reading.argument, reading.advice);
}

// Reads glslang's -V and -V100: the version of Vulkan's GLSL, of which there is one.
void SetVulkanSpirv(Reading& reading, const std::string& value) {
  if (value.empty() || value == "100") return SetSpirv<true>(reading, value);
  reading.unknown.emplace_back(reading.argument, "did you mean `-V`?");
}

// Reads what the SPIR-V is for, as glslang and glslc say it: it is written without a further -V.
void SetSpirvFor(Reading& reading, const std::string& value) {
  const bool is_opengl = value.starts_with("opengl");
  is_opengl ? SetSpirv<false>(reading, value) : SetSpirv<true>(reading, value);
  if (!is_opengl && value != "vulkan" && value != "vulkan100") SetVulkanVersion(reading, value);
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

// Requires the one value that clipc has, by either of its names, of those that another compiler
// knows.
template <const auto& kValue, const auto& kOtherName = kValue>
void RequireValue(Reading& reading, const std::string& value) {
  if (value != kValue && value != kOtherName)
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
constexpr std::string_view kHlsl = "hlsl", kVert = "vert", kVertex = "vertex", kUtf8 = "utf8";

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
    {"-V", kJoined, SetVulkanSpirv},
    {"--target-env --client", kEquals, SetSpirvFor},
    {"--source-entrypoint --sep", kSeparate, Set<&Reading::source_entry>},
    {"-Fo", kJoinedOrSeparate, Set<&CommandLine::output>},
    {"-e", kSeparate, SetEntry},
    {"-fentry-point", kEquals, SetEntry},
    {"-isystem -iquote", kSeparate, Set<&IncludeOptions::dirs>},
    {"-U", kJoinedOrSeparate, Undefine},
    {"-std=hlsl", kJoined, Choose<&LanguageOptions::version, kLanguageNames>},
    {"--invert-y --iy -finvert-y -fvk-invert-y", kFlag, Set<&passes::ClipSpaceOptions::flip_y>},
    {"-g -gVS", kFlag, Set<&OutputOptions::source_lines>},
    {"-fspv-debug", kEquals, SetTo<&OutputOptions::source_lines, true>},
    {"-fspv-preserve-interface", kFlag, Set<&Reading::preserves_interface>},
    {"-matrix-layout-row-major", kFlag, SetTo<&LanguageOptions::packing, MatrixPacking::kRowMajor>},
    {"-matrix-layout-column-major", kFlag,
     SetTo<&LanguageOptions::packing, MatrixPacking::kColumnMajor>},
    {"-stage", kSeparate, RequireValue<kVertex, kVert>},
    {"-flegacy-macro-expansion -legacy-macro-expansion", kFlag,
     Set<&LanguageOptions::legacy_macro_expansion>},
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
    {"-fshader-stage", kEquals, RequireValue<kVertex, kVert>},
    {"-fspv-entrypoint-name", kEquals, RequireValue<kSpirvEntry>},
    {"-encoding", kSeparate, RequireValue<kUtf8>},

    // Options for what clipc always does: buffers keep Direct3D's layout, SV_VertexID and
    // SV_InstanceID begin at 0, resources are mapped by register, and those without one, inputs
    // and outputs have numbers too.
    {"-fvk-use-dx-layout --hlsl-offsets -fhlsl-offsets -fvk-support-nonzero-base-instance "
     "-fvk-support-nonzero-base-vertex --hlsl-iomap -fhlsl-iomap --auto-map-bindings --amb "
     "--auto-map-locations --aml -fauto-bind-uniforms -fauto-map-locations -pedantic "
     "-fdiagnostics-show-option",
     kFlag, Ignore},
    // Options for the code, the listing or the effort of another compiler.
    {"-nologo -Zss -Zsb -Zs -Cc -c -Gpp -all_resources_bound -all-resources-bound "
     "-enable_unbounded_descriptor_tables -res_may_alias -res-may-alias -Qembed_debug "
     "-Qsource_in_debug_module -Qpdb_in_private -Qkeep_reflect_in_dxil -l -C --quiet",
     kFlag, Ignore},
    {"-Qstrip_ -errorReport", kJoined, Ignore},
    {"-Oconfig", kEquals, Ignore},
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
    {"-fspv-reflect", kFlag, HasNoEffect, nullptr, "`--reflect` writes the reflection as JSON"},
    {"-fspv-extension", kEquals, HasNoEffect, nullptr,
     "the SPIR-V has the extensions that the shader needs"},
    {"-ferror-limit", kEquals, HasNoEffect, nullptr, "a compile ends at the 50th error"},
    {"-fspv-max-id", kEquals, HasNoEffect, nullptr, "the SPIR-V has as many ids as it needs"},
    {"-fspv-reduce-load-size -fspv-fix-func-call-arguments", kFlag, HasNoEffect, nullptr,
     "clipc leaves optimisation to the driver"},
    {"-fspv-preserve-bindings -fpreserve-bindings", kFlag, HasNoEffect, nullptr,
     "bindings that nothing reads are left out"},
    {"-fvk-use-dx-position-w", kFlag, HasNoEffect, nullptr, "it is for pixel shaders"},
    {"--keep-uncalled --ku", kFlag, HasNoEffect, nullptr,
     "functions that nothing calls are left out"},

    // Options whose meaning clipc does not have.
    {"-Entry -entry", kJoined, Refuse, nullptr, "did you mean `-E`?"},
    {"-Define -define", kJoined, Refuse, nullptr, "did you mean `-D`?"},
    {"-Target -target -profile -Profile", kJoined, Refuse, nullptr,
     "did you mean `-T` or `--target`?"},
    {"-Include", kJoined, Refuse, nullptr, "did you mean `-I` or `-include`?"},
    {"-opt-", kJoined, Refuse, nullptr, "clipc leaves optimisation to the driver"},
    {"-output -Output", kJoined, Refuse, nullptr, "did you mean `-o`?"},
    {"-fspv-", kJoined, Refuse, nullptr, "the SPIR-V is what glslang makes of the GLSL"},
    {"-fvk-use-gl-layout -fvk-use-scalar-layout", kFlag, Refuse, nullptr,
     "buffers keep the layout of Direct3D, as with -fvk-use-dx-layout"},
    {"-fvk-", kJoined, Refuse, nullptr, kFollowRegisters},
    {"--shift-image-binding --sib --shift-ssbo-binding --sbb", kNumbers, Refuse, nullptr, kByKind},
    {"--shift-", kJoined, Refuse, nullptr, kFollowRegisters},
    {"-enable-16bit-types", kFlag, Refuse, nullptr,
     "`half` and `min16float` are computed and stored at 32 bits"},
    {"-Fe", kJoinedOrSeparate, Refuse, nullptr, "messages go to standard error"},
    {"-Fre", kJoinedOrSeparate, Refuse, nullptr, "`--reflect` writes the reflection as JSON"},
    {"-Frs -Fsh -setrootsignature -extractrootsignature -verifyrootsignature -getprivate "
     "-setprivate -dumpbin -compress -decompress",
     kJoined, Refuse, nullptr, "it is for compiled shaders of Direct3D"},
    {"-Fx", kJoinedOrSeparate, Refuse, nullptr, "`-Fc` writes a listing"},
    {"-q", kFlag, Refuse, nullptr, "`--reflect` writes the reflection as JSON"},
    {"-mfmt", kEquals, Refuse, nullptr, "`-Fh` writes a header of C"},
    {"-ast-dump", kFlag, Refuse, nullptr, "`--dump=ast` prints the syntax tree"},
    {"-Gch -Gdp -LD -Fl", kJoined, Refuse, nullptr,
     "it is for effects and libraries; clipc compiles one shader"},
};

}  // namespace

std::span<const Option> ForeignOptions() { return kForeignOptions; }

}  // namespace clipc
