// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "compiler/command/binding_options.h"
#include "compiler/command/option_actions.h"

// The options that people know from fxc, dxc, glslang and C compilers.
namespace clipc {
namespace {

using signature::PositionName;

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

// Reads glslc's --target-spv: spv1.0 to spv1.6, for the Vulkan version that another option names.
void SetSpirvVersion(Reading& reading, const std::string& value) {
  const std::string_view prefix = value.starts_with("spirv") ? "spirv1." : "spv1.";
  std::uint32_t minor = 0;
  if (value.starts_with(prefix) && ReadNumber(value.substr(prefix.size()), minor) && minor <= 6) {
    reading.vulkan_option = reading.option;
    reading.spirv.version = minor;
    return;
  }
  reading.Refuse(fmt::format("unknown value `{}` of {}; there is `spv1.0` to `spv1.6`", value,
                             reading.option));
}

// Reads what the SPIR-V is for, as glslang and glslc say it: it is written without a further -V.
void SetSpirvFor(Reading& reading, const std::string& value) {
  const bool is_opengl = value.starts_with("opengl");
  is_opengl ? SetSpirv<false>(reading, value) : SetSpirv<true>(reading, value);
  if (is_opengl || value == "vulkan" || value == "vulkan100") return;
  value.starts_with("spirv1.") ? SetSpirvVersion(reading, value) : SetVulkanVersion(reading, value);
}

// -Gec and -Ges exclude each other, as in fxc.
template <PositionName kName>
void SetPositionName(Reading& reading, const std::string&) {
  PositionName& name = reading.command.request.language.position_name;
  if (name != PositionName::kSystemValue && name != kName)
    reading.Refuse("-Gec and -Ges contradict each other");
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
  reading.Refuse(fmt::format("unknown option `-O{}`", value));
}

// Requires the one value that clipc has, by either of its names, of those that another compiler
// knows.
template <const auto& kValue>
void RequireValue(Reading& reading, const std::string& value) {
  if (value != kValue)
    reading.Refuse(fmt::format("`{}`: clipc has `{}` only", AsWritten(reading, value), kValue));
}

// Reads the stage as glslang, glslc or Slang calls it.
void SetStage(Reading& reading, const std::string& value) {
  reading.stage = StageOfExtension(value);
  for (std::size_t i = 0; i < kStageCount && !reading.stage; ++i) {
    if (value == kStages[i].name) reading.stage = static_cast<Stage>(i);
  }
  if (value == "fragment") reading.stage = Stage::kPixel;
  if (!reading.stage)
    reading.Refuse(
        fmt::format("`{}`: clipc compiles vertex, hull, domain, geometry, pixel and compute "
                    "shaders; use dxc or "
                    "glslang for other ones",
                    AsWritten(reading, value)));
}

// SPIR-V is always written so.
void SetNanClamp(Reading& reading, const std::string&) { reading.spirv_option = reading.option; }

// Reads glslang's -S with a stage, or glslc's, which has no value: a listing of the SPIR-V.
void SetStageOrListing(Reading& reading, const std::string& value) {
  const bool is_file = value.find('.') != value.npos;
  if (!value.empty() && !is_file) return SetStage(reading, value);
  reading.writes_spirv = true;
  reading.command.spirv_form = CommandLine::SpirvForm::kListing;
  if (is_file) reading.command.inputs.push_back(value);
}

// Keeps the bindings of what the shader does not read.
void KeepBindings(Reading& reading, const std::string&) {
  reading.vulkan_option = reading.option;
  reading.bindings.keeps_unread = true;
}

// Gives each element of an array of textures a binding of its own.
void SplitArrays(Reading& reading, const std::string&) {
  reading.vulkan_option = reading.option;
  reading.bindings.splits_arrays = true;
}

// Reads a text that is put before the shader, one of several.
void AddPreamble(Reading& reading, const std::string& value) {
  std::string& preamble = reading.command.request.includes.preamble;
  preamble += preamble.empty() ? value : '\n' + value;
}

// Reads glslc's -mfmt: the form of the SPIR-V, which glslc always writes.
constexpr Named<CommandLine::SpirvForm> kSpirvForms[] = {{CommandLine::SpirvForm::kBinary, "bin"},
                                                         {CommandLine::SpirvForm::kNumbers, "num"},
                                                         {CommandLine::SpirvForm::kInBraces, "c"}};
void SetSpirvForm(Reading& reading, const std::string& value) {
  reading.writes_spirv = true;
  Choose<&CommandLine::spirv_form, kSpirvForms>(reading, value);
}

// Reads dxc's -fspv-debug. `rich` was an older set of instructions than that of `vulkan`.
constexpr Named<SpirvDebug> kSpirvDebugs[] = {
    {SpirvDebug::kFile, "file"},  {SpirvDebug::kSource, "source"},
    {SpirvDebug::kLine, "line"},  {SpirvDebug::kTool, "tool"},
    {SpirvDebug::kSet, "rich"},   {SpirvDebug::kSetAndSource, "rich-with-source"},
    {SpirvDebug::kSet, "vulkan"}, {SpirvDebug::kSetAndSource, "vulkan-with-source"}};
void SetSpirvDebug(Reading& reading, const std::string& value) {
  reading.command.request.outputs.source_lines = true;
  Choose<&SpirvRequest::debug, kSpirvDebugs>(reading, value);
}

void SetSpirvReflection(Reading& reading, const std::string&) {
  reading.spirv_option = reading.option;
  reading.spirv.has_reflection = true;
}

// Reads glslc's -x hlsl, or glslang's -x, which has no value: SPIR-V as numbers.
void SetLanguage(Reading& reading, const std::string& value) {
  if (value == "hlsl") return;
  if (!value.empty() && value.find('.') == value.npos) {
    reading.Refuse(fmt::format("`{}`: clipc has `hlsl` only", AsWritten(reading, value)));
    return;
  }
  reading.spirv_option = reading.option;
  reading.command.spirv_form = CommandLine::SpirvForm::kNumbers;
  if (!value.empty()) reading.command.inputs.push_back(value);
}

// Reads what is added to the bindings of images or storage blocks, which are kinds of GLSL and not
// of HLSL.
template <char kKind>
void ShiftKind(Reading& reading, const std::string& value) {
  reading.kind_shifts.push_back(reading.option);
  Bind<AddKindShift<kKind>>(reading, value);
}

// Reads glslc's -std=450core, which is about GLSL that it reads.
void SetGlslVersion(Reading& reading, const std::string& value) {
  if (!value.empty() && value.find_first_not_of("0123456789") > 0) {
    HasNoEffect(reading, value);
  } else {
    reading.unknown.emplace_back(reading.argument, "`-std=hlsl2021` is a version of HLSL");
  }
}

// The same formats, as Clang calls them.
constexpr Named<MessageFormat> kClangFormats[] = {{MessageFormat::kText, "clang"},
                                                  {MessageFormat::kMsvc, "msvc"},
                                                  {MessageFormat::kJson, "json"},
                                                  {MessageFormat::kSarif, "sarif"}};
constexpr char kShift[] = "two numbers, or a number and `all`";
constexpr char kKindShift[] = "a number, or numbers each with its set";
constexpr char kRegisterSets[] =
    "registers, each with its set and its binding, `t0 1 2`, or one set for all";
constexpr char kFollowRegisters[] = "bindings follow the registers; `--reflect` tells them";
constexpr std::string_view kUtf8 = "utf8", kDeclared = "decl", kAny = "any",
                           kReserveAll = "reserve-all";

using enum Option::Form;
using Action = CommandLine::Action;
using Request = ProgramRequest;

// The options that clipc has, by other names too; then those without effect; then those refused.
constexpr Option kForeignOptions[] = {
    Topic(kCompilersTopic, "options of fxc, dxc, glslang and glslc, with their meaning"),
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
    {"-fcbuffer-binding-base -fubo-binding-base", kNumbers, Bind<AddKindShift<'b'>>, nullptr,
     kKindShift},
    {"-fsampler-binding-base", kNumbers, Bind<AddKindShift<'s'>>, nullptr, kKindShift},
    {"-ftexture-binding-base", kNumbers, Bind<AddKindShift<'t'>>, nullptr, kKindShift},
    {"-fuav-binding-base", kNumbers, Bind<AddKindShift<'u'>>, nullptr, kKindShift},
    {"--shift-image-binding --sib -fimage-binding-base", kNumbers, ShiftKind<glsl::kImages>,
     nullptr, kKindShift},
    {"--shift-ssbo-binding --sbb -fssbo-binding-base", kNumbers, ShiftKind<glsl::kStorageBlocks>,
     nullptr, kKindShift},
    {"--resource-set-binding --rsb -fresource-set-binding", kRegisters, Bind<AddRegisters>, nullptr,
     kRegisterSets},
    {"--auto-sampled-textures -fauto-combined-image-sampler", kFlag, Set<&Reading::joins_samplers>},
    {"--hlsl-iomap -fhlsl-iomap", kFlag, Set<&Reading::maps_registers>},
    {"-fvk-use-gl-layout", kFlag, SetTo<&StyleOptions::layout, glsl::BufferLayout::kGl>},
    {"-fvk-use-scalar-layout", kFlag, SetTo<&StyleOptions::layout, glsl::BufferLayout::kScalar>},
    {"-fvk-use-dx-layout", kFlag, SetTo<&StyleOptions::layout, glsl::BufferLayout::kDirect3D>},
    {"-V", kJoined, SetVulkanSpirv},
    {"--target-env --client", kEquals, SetSpirvFor},
    {"--target-spv", kEquals, SetSpirvVersion},
    {"-fspv-entrypoint-name", kEquals, Set<&SpirvRequest::entry>},
    {"--nan-clamp -fnan-clamp", kFlag, SetNanClamp},
    {"-mfmt", kEquals, SetSpirvForm},
    {"--source-entrypoint --sep", kSeparate, Set<&Reading::source_entry>},
    {"-Fo", kJoinedOrSeparate, Set<&CommandLine::output>},
    {"-e", kSeparate, SetEntry},
    {"-fentry-point", kEquals, SetEntry},
    {"-isystem -iquote", kSeparate, Set<&IncludeOptions::dirs>},
    {"-U", kJoinedOrSeparate, Undefine},
    {"-std=hlsl", kJoined, Choose<&LanguageOptions::version, kLanguageNames>},
    {"--invert-y --iy -finvert-y -fvk-invert-y", kFlag, Set<&passes::ClipSpaceOptions::flip_y>},
    {"-g -gVS", kFlag, Set<&OutputOptions::source_lines>},
    {"-fspv-debug", kEquals, SetSpirvDebug},
    {"-fspv-reflect -fhlsl-functionality1 -fhlsl_functionality1", kFlag, SetSpirvReflection},
    {"-fspv-preserve-bindings -fpreserve-bindings", kFlag, KeepBindings},
    {"-fspv-preserve-interface", kFlag, Set<&Reading::preserves_interface>},
    {"-matrix-layout-row-major", kFlag, SetTo<&LanguageOptions::packing, MatrixPacking::kRowMajor>},
    {"-matrix-layout-column-major", kFlag,
     SetTo<&LanguageOptions::packing, MatrixPacking::kColumnMajor>},
    {"-S", kOptional, SetStageOrListing},
    {"-stage", kSeparate, SetStage},
    {"--preamble-text --P", kEquals, AddPreamble},
    {"-fshader-stage", kEquals, SetStage},
    {"-flegacy-macro-expansion -legacy-macro-expansion", kFlag,
     Set<&LanguageOptions::legacy_macro_expansion>},
    {"-fspv-flatten-resource-arrays --flatten-uniform-arrays --fua", kFlag, SplitArrays},
    {"-fspv-use-legacy-buffer-matrix-order", kFlag, Set<&LanguageOptions::byte_matrices_by_row>},
    {"--vn", kSeparate, Set<&CommandLine::variable>},
    {"-MMD", kFlag, Set<&CommandLine::write_dependencies>},
    {"-MM", kFlag, Set<&CommandLine::only_dependencies>},
    {"-MQ", kJoinedOrSeparate, Set<&CommandLine::dependency_target>},
    {"--depfile", kEquals, SetDependencyFile},
    {"-Gec", kFlag, SetPositionName<PositionName::kBoth>},
    {"-Ges", kFlag, SetPositionName<PositionName::kStrict>},
    {"-Vi", kFlag, Set<&CommandLine::show_includes>},
    {"-Fi", kJoinedOrSeparate, Set<&Reading::preprocess_output>},
    {"-Fe", kJoinedOrSeparate, Set<&CommandLine::messages>},
    {"-Vd", kFlag, SetTo<&Reading::validate, false>},
    {"-WX", kFlag, Set<&WarningOptions::warnings_are_errors>},
    {"-no-warnings", kFlag, Set<&WarningOptions::no_warnings>},
    {"-h -? -help", kFlag, SetTo<&CommandLine::action, Action::kHelp>},
    {"--stdin", kFlag, AddStandardInput},
    {"-fdiagnostics-format", kEquals, Choose<&CommandLine::format, kClangFormats>},
    {"-fcolor-diagnostics", kFlag, SetTo<&CommandLine::colour, true>},
    {"-fno-color-diagnostics", kFlag, SetTo<&CommandLine::colour, false>},
    {"-x", kOptional, SetLanguage},
    {"-encoding", kSeparate, RequireValue<kUtf8>},
    {"-fvk-stage-io-order", kEquals, RequireValue<kDeclared>},
    {"-fhlsl-unused-resource-bindings", kEquals, RequireValue<kReserveAll>},
    {"-denorm", kSeparate, RequireValue<kAny>},

    Topic(kCompilersTopic, "the same, without effect: clipc always does so, or GLSL has none"),
    // Options for what clipc always does: buffers keep Direct3D's layout, SV_VertexID and
    // SV_InstanceID begin at 0, SV_Position.w is Direct3D's, resources are mapped by register, and
    // those without one, inputs and outputs have numbers too; a texture may have no sampler.
    {"--hlsl-offsets -fhlsl-offsets -fvk-support-nonzero-base-instance "
     "-fvk-support-nonzero-base-vertex -fvk-use-dx-position-w --hlsl-dx-position-w "
     "--hlsl-dx9-compatible -fvk-auto-shift-bindings --auto-map-bindings --amb "
     "--auto-map-locations --aml -fauto-bind-uniforms -fauto-map-locations -pedantic "
     "-fdiagnostics-show-option",
     kFlag, Ignore},
    {"-MP", kFlag, Ignore},
    // Options for the code, the listing or the effort of another compiler.
    {"-nologo -Zss -Zsb -Zs -Cc -c -Gpp -all_resources_bound -all-resources-bound "
     "-enable_unbounded_descriptor_tables -res_may_alias -res-may-alias -Qembed_debug "
     "-Qsource_in_debug_module -Qpdb_in_private -Qkeep_reflect_in_dxil -fcgl "
     "-ffinite-math-only -fno-finite-math-only -enable-payload-qualifiers "
     "-disable-payload-qualifiers -pack-optimized -pack_optimized -pack-prefix-stable "
     "-pack_prefix_stable -l -C --quiet",
     kFlag, Ignore},
    {"-Qstrip_ -errorReport", kJoined, Ignore},
    {"-Oconfig", kEquals, Ignore},
    {"-O", kJoined, SetOptimisation},

    Topic(kCompilersTopic, "the same, with a warning that says what is lost"),
    {"-Fd", kJoinedOrSeparate, HasNoEffect, nullptr,
     "GLSL has no debug database; -Zi keeps the lines of the HLSL"},
    {"-Gfa", kFlag, HasNoEffect, nullptr,
     "GLSL has no such mode; `[flatten]` on a statement reaches Vulkan's drivers"},
    {"-Gfp", kFlag, HasNoEffect, nullptr,
     "GLSL has no such mode; `[branch]` on a statement reaches Vulkan's drivers"},
    {"-Ni -No -Lx", kFlag, HasNoEffect, nullptr, "the listing is GLSL"},
    {"-q", kFlag, HasNoEffect, nullptr, "`--reflect` writes the reflection as JSON"},
    {"-fspv-extension", kEquals, HasNoEffect, nullptr,
     "the SPIR-V has the extensions that the shader needs"},
    {"-ferror-limit", kEquals, HasNoEffect, nullptr, "a compile ends at the 50th error"},
    {"-fspv-max-id", kEquals, HasNoEffect, nullptr, "the SPIR-V has as many ids as it needs"},
    {"-fspv-reduce-load-size -fspv-fix-func-call-arguments", kFlag, HasNoEffect, nullptr,
     "clipc leaves optimisation to the driver"},
    {"-std", kEquals, SetGlslVersion, nullptr, "it is about GLSL that is read"},
    {"-d -t", kFlag, HasNoEffect, nullptr, "it is glslang's; a macro is `-D`, a profile `-T`"},
    {"-flimit -flimit-file", kEquals, HasNoEffect, nullptr, "clipc counts no limits of devices"},
    {"--no-storage-format --nsf -fspv-use-unknown-image-format", kFlag, HasNoEffect, nullptr,
     "an image has the format of its texels"},
    {"-rootsig-define -force-rootsig-ver -force_rootsig_ver", kSeparate, HasNoEffect, nullptr,
     "GLSL has no root signature"},
    {"-Gch -Gdp", kFlag, HasNoEffect, nullptr, "it is for effects"},
    {"--no-link --lto", kFlag, HasNoEffect, nullptr, "there is one shader to link"},
    {"--keep-uncalled --ku", kFlag, HasNoEffect, nullptr,
     "functions that nothing calls are left out"},

    // Options whose meaning clipc does not have, which no topic lists.
    Topic("", ""),
    {"-Entry -entry", kJoined, Refuse, nullptr, "did you mean `-E`?"},
    {"-Define -define", kJoined, Refuse, nullptr, "did you mean `-D`?"},
    {"-Target -target -profile -Profile", kJoined, Refuse, nullptr,
     "did you mean `-T` or `--target`?"},
    {"-Include", kJoined, Refuse, nullptr, "did you mean `-I` or `-include`?"},
    {"-opt-", kJoined, Refuse, nullptr, "clipc leaves optimisation to the driver"},
    {"-output -Output", kJoined, Refuse, nullptr, "did you mean `-o`?"},
    {"-fspv-print-all", kFlag, Refuse, nullptr, "`--dump-after` prints the program after a pass"},
    {"-fspv-use-vulkan-memory-model", kFlag, Refuse, nullptr,
     "the memory model is GLSL450, where `globallycoherent` is `coherent`; for the other one run "
     "`clipc --target=hlsl` before dxc"},
    {"-fspv-enable-maximal-reconvergence", kFlag, Refuse, nullptr,
     "glslang writes no such mode; run `clipc --target=hlsl` before dxc"},
    {"-fspv-", kJoined, Refuse, nullptr, "clipc writes SPIR-V in one way"},
    {"-fvk-bind-resource-heap -fvk-bind-sampler-heap -fvk-bind-counter-heap", kTwo, Refuse, nullptr,
     "GLSL has no objects without a declaration; declare arrays of them with registers"},
    {"-fvk-", kJoined, Refuse, nullptr, kFollowRegisters},
    {"--shift-", kJoined, Refuse, nullptr, kFollowRegisters},
    {"-enable-16bit-types --hlsl-enable-16bit-types -fhlsl-16bit-types", kFlag, Refuse, nullptr,
     "`half` and `min16float` are computed and stored at 32 bits"},
    {"-Fre", kJoinedOrSeparate, Refuse, nullptr, "`--reflect` writes the reflection as JSON"},
    {"-Frs -Fsh -setrootsignature -extractrootsignature -verifyrootsignature -getprivate "
     "-setprivate -dumpbin -compress -decompress",
     kJoined, Refuse, nullptr, "it is for compiled shaders of Direct3D"},
    {"-Fx", kJoinedOrSeparate, Refuse, nullptr, "`-Fc` writes a listing"},
    {"-ast-dump", kFlag, Refuse, nullptr, "`--dump=ast` prints the syntax tree"},
    {"-LD -Fl", kJoined, Refuse, nullptr,
     "it is for effects and libraries; clipc compiles one shader"},
};

}  // namespace

std::span<const Option> ForeignOptions() { return kForeignOptions; }

}  // namespace clipc
