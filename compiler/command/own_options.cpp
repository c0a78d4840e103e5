// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/spelling.h"
#include "compiler/command/binding_options.h"
#include "compiler/command/option_actions.h"
#include "compiler/compile/check_lowering.h"
#include "compiler/compile/explain.h"
#include "compiler/compile/suggest.h"

// The options of clipc.
namespace clipc {
namespace {

constexpr std::string_view kHlslTarget = "hlsl";

// The target that people mean by the name of an API or of a language.
struct NearTarget {
  std::string_view name, target;
};
constexpr NearTarget kNearTargets[] = {
    {"opengl", "glsl450"}, {"gl", "glsl450"},       {"glsl", "glsl450"},
    {"gles", "essl310"},   {"opengles", "essl310"}, {"es", "essl310"},
    {"essl", "essl310"},   {"webgl", "webgl2"},     {"spirv", "vulkan"}};

void SetTarget(Reading& reading, const std::string& value) {
  HlslOptions& hlsl = reading.command.request.hlsl;
  hlsl.wanted = value == kHlslTarget;
  if (hlsl.wanted) return;
  reading.target = glsl::Target::Parse(value);
  if (reading.target) return;
  std::vector<std::string_view> names(glsl::Target::Names().begin(), glsl::Target::Names().end());
  names.push_back(kHlslTarget);
  const auto* near = std::ranges::find(kNearTargets, value, &NearTarget::name);
  reading.Refuse(fmt::format("unknown target `{}`{}", value,
                             near == std::end(kNearTargets)
                                 ? Suggest(value, names)
                                 : fmt::format("; did you mean `{}`?", near->target)));
}

// Reads "2/4", the number of a shard and the number of shards, or "merge".
void SetShard(Reading& reading, const std::string& value) {
  CommandLine& command = reading.command;
  command.merge_shards = value == "merge";
  if (command.merge_shards) return;
  const std::size_t slash = value.find('/');
  if (slash != value.npos && ReadNumber(value.substr(0, slash), command.shard) &&
      ReadNumber(value.substr(slash + 1), command.shards) && command.shard >= 1 &&
      command.shard <= command.shards)
    return;
  reading.Refuse(fmt::format("`{}`: it needs a part and the number of parts, as `2/4`, or `merge`",
                             AsWritten(reading, value)));
}

// Adds names with commas between them to a list.
template <auto kMember>
void SetNames(Reading& reading, const std::string& value) {
  std::size_t begin = 0;
  while (begin <= value.size()) {
    const std::size_t end = std::min(value.find(',', begin), value.size());
    if (end == begin) {
      reading.Refuse(fmt::format("`{}`: it needs names with commas between them, as `a,b`",
                                 AsWritten(reading, value)));
      return;
    }
    MemberOf(reading, kMember).push_back(value.substr(begin, end - begin));
    begin = end + 1;
  }
}

void SetProfile(Reading& reading, const std::string& value) {
  reading.names_profile = true;
  reading.command.request.first().profile = value;
}

void SetPreprocess(Reading& reading, const std::string& value) {
  reading.preprocess = true;
  reading.preprocess_name = value;
}

// Reads the entry, or glslang's and glslc's -E, which has no value: -o or standard output gets the
// text after preprocessing. An entry has no dot in its name, and a file of a shader has one.
void SetEntryOrPreprocess(Reading& reading, const std::string& value) {
  const bool is_file = value.find('.') != value.npos;
  if (!value.empty() && !is_file) return SetEntry(reading, value);
  if (value.empty() && reading.argument.starts_with('/')) reading.Refuse(NeedsValue(reading));
  reading.preprocesses_only = true;
  if (is_file) reading.command.inputs.push_back(value);
}

template <auto kMember>
void SetForZero(Reading& reading, const std::string& value) {
  MemberOf(reading, kMember) = true;
  if (value != "zero")
    reading.Refuse(fmt::format("`{}={}`: the only value is `zero`", reading.option, value));
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
    reading.Refuse(fmt::format("unknown warning `{}`{}", name, Suggest(name, views)));
  }
}

// Reads the name of the pixel shader's GLSL, which asks for a pair.
void SetPixelOutput(Reading& reading, const std::string& value) {
  reading.command.pixel_output = value;
  if (value.empty()) reading.Refuse("--pixel-output needs the name of a file, or `.frag`");
}

// Reads the entry or the file of a shader between the first one and the pixel shader.
template <Stage kStage, std::string MiddleShader::* kMember>
void SetMiddle(Reading& reading, const std::string& value) {
  constexpr auto kAt = std::ranges::find(kMiddleStages, kStage) - kMiddleStages;
  reading.command.middle[kAt].*kMember = value;
  if (value.empty() && kMember == &MiddleShader::output)
    reading.Refuse(fmt::format("{} needs the name of a file, or `{}`", reading.option,
                               InfoOf(kStage).extension));
}

// Reads words of [partitioning(..)] and of [outputtopology(..)].
void SetTessellation(Reading& reading, const std::string& value) {
  TessellationOptions into;
  const auto once = [&](bool is_second, std::string_view attribute) {
    if (is_second)
      reading.Refuse(fmt::format("`{}` has two words of [{}]; give one", AsWritten(reading, value),
                                 attribute));
  };
  for (std::string_view rest = value; !rest.empty();) {
    const std::string_view word = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    const auto* cut = std::ranges::find(ir::kPartitionings, word);
    const auto* joined = std::ranges::find(ir::kOutputTopologies, word);
    if (cut != std::end(ir::kPartitionings)) {
      once(into.partitioning.has_value(), "partitioning");
      into.partitioning = static_cast<ir::Partitioning>(cut - ir::kPartitionings);
    } else if (joined != std::end(ir::kOutputTopologies)) {
      once(into.topology.has_value(), "outputtopology");
      into.topology = static_cast<ir::OutputTopology>(joined - ir::kOutputTopologies);
    } else {
      reading.Refuse(fmt::format("`{}`: `{}` is not a word of [partitioning] or [outputtopology]",
                                 AsWritten(reading, value), word));
    }
  }
  TessellationOptions& all = reading.command.request.tessellation;
  if (into.partitioning) all.partitioning = into.partitioning;
  if (into.topology) all.topology = into.topology;
}

// Without a value it is glslang's -D, which says that the text is HLSL.
void Define(Reading& reading, const std::string& value) {
  if (!value.empty()) reading.command.request.defines.push_back(value);
}

constexpr Named<bool> kDepthRanges[] = {{false, "zero-to-one"}, {true, "negative-one-to-one"}};
constexpr Named<bool> kMinPrecisions[] = {{false, "full"}, {true, "relaxed"}};
constexpr Named<glsl::BlockStyle> kBlockStyles[] = {{glsl::BlockStyle::kNamed, "named"},
                                                    {glsl::BlockStyle::kPlain, "plain"},
                                                    {glsl::BlockStyle::kFlat, "flat"}};
constexpr Named<MessageFormat> kFormats[] = {{MessageFormat::kText, "text"},
                                             {MessageFormat::kMsvc, "msvc"},
                                             {MessageFormat::kJson, "json"},
                                             {MessageFormat::kSarif, "sarif"}};
constexpr Named<DumpStage> kStages[] = {{DumpStage::kTokens, "tokens"},
                                        {DumpStage::kAst, "ast"},
                                        {DumpStage::kIr, "ir"},
                                        {DumpStage::kGlsl, "glsl"},
                                        {DumpStage::kTable, "table"}};

using enum Option::Form;
using Action = CommandLine::Action;
using Request = ProgramRequest;

void SetHelpTopic(Reading& reading, const std::string& value) {
  CommandLine& command = reading.command;
  command.action = Action::kHelp;
  command.help_topic = value;
  std::vector<std::string_view> topics;
  for (const Option& option : OwnOptions())
    if (option.IsTopic()) topics.push_back(option.metavar);
  topics.push_back(kCompilersTopic);
  if (std::ranges::find(topics, value) == topics.end())
    reading.Refuse(fmt::format("unknown topic `{}`{}", value, Suggest(value, topics)));
}

void SetExplained(Reading& reading, const std::string& value) {
  CommandLine& command = reading.command;
  command.action = Action::kExplain;
  command.explained = value;
  if (Explain(value).empty())
    reading.Refuse(fmt::format("no message is called `{}`{}", value, SuggestDiagnostic(value)));
}

// The options in the order of --help.
constexpr Option kOwnOptions[] = {
    Topic("language", "the shader and its language"),
    {"-T", kJoinedOrSeparate, SetProfile, "<PROFILE>",
     "vs_2_0 .. vs_6_9 (vs_5_0), ps_2_0 .., gs_ and cs_4_0 .., hs_ and ds_5_0 .., "
     "vs_4_0_level_9_1"},
    {"-E", kOptional, SetEntryOrPreprocess, "<NAME>", "entry function (main)"},
    {"-D", kDefinition, Define, "<NAME[=VALUE]>", "define a macro"},
    {"-I", kJoinedOrSeparate, Set<&IncludeOptions::dirs>, "<DIR>", "look for includes here too"},
    {"-include", kSeparate, Set<&IncludeOptions::forced>, "<FILE>", "include FILE first"},
    {"-HV", kJoinedOrSeparate, Choose<&LanguageOptions::version, kLanguageNames>, "<YEAR>",
     "2016, 2017, 2018 or 2021 (2021): from shader model 6 on"},
    {"-Zpc", kFlag, SetTo<&LanguageOptions::packing, MatrixPacking::kColumnMajor>, "",
     "matrices are column-major in memory (the default)"},
    {"-Zpr", kFlag, SetTo<&LanguageOptions::packing, MatrixPacking::kRowMajor>, "",
     "matrices are row-major in memory"},
    {"--shadow-samplers", kEquals, SetNames<&LanguageOptions::shadow_samplers>, "<A>",
     "A or A,B: samplers of Direct3D 9 whose tex2Dproj compares depths"},
    {"-Gis", kFlag, Set<&StyleOptions::precise>, "",
     "the outputs and what they depend on are `precise`"},
    {"-P", kOptional, SetPreprocess, "<FILE>", "write the preprocessed HLSL to FILE, and stop"},
    {"-H", kFlag, Set<&CommandLine::show_includes>, "", "print the files that are included"},
    {"-fsyntax-only", kFlag, Set<&CommandLine::syntax_only>, "", "write no file"},
    Topic("output", "what is written"),
    {"-o", kJoinedOrSeparate, Set<&CommandLine::output>, "<FILE>",
     "the GLSL: a file, standard output (-, the default), or a folder for several files"},
    {"--target", kEquals, SetTarget, "<GLSL>",
     "glsl120 .. glsl460 (glsl450), vulkan, essl100, essl300 .. essl320, webgl1, webgl2, hlsl"},
    {"-spirv", kFlag, SetSpirv<true>, "",
     "write SPIR-V instead of GLSL, for Vulkan; so does a .spv file"},
    {"-G", kFlag, SetSpirv<false>, "", "write SPIR-V for OpenGL 4.5"},
    {"-fspv-target-env", kEquals, SetVulkanVersion, "<V>", "vulkan1.0 .. vulkan1.3 (vulkan1.1)"},
    {"--min-precision", kEquals, Choose<&StyleOptions::relaxed_precision, kMinPrecisions>, "<BITS>",
     "of half, min16float and the like: full (32 bits, the default), or relaxed"},
    {"-Zi", kFlag, Set<&OutputOptions::source_lines>, "",
     "with the lines of the HLSL as comments in the GLSL"},
    {"-Fc", kJoinedOrSeparate, Set<&CommandLine::listing>, "<FILE>",
     "write the GLSL with these comments to FILE"},
    {"-Fh", kJoinedOrSeparate, Set<&CommandLine::header>, "<FILE>",
     "write the GLSL as a C string to FILE; of an effect, its tables for effect-runtime/effect.h "
     "too"},
    {"-Vn", kJoinedOrSeparate, Set<&CommandLine::variable>, "<NAME>",
     "the name of the variable that -Fh writes (g_ and the entry's name)"},
    {"--validate", kFlag, SetTo<&Reading::validate, true>, "",
     "compile the GLSL with glslang before writing it"},
    {"--no-validate", kFlag, SetTo<&Reading::validate, false>},
    {"--wrapper-entry", kEquals, Set<&HlslOptions::wrapper_entry>, "<NAME>",
     "with --target=hlsl: the entry function that writes the clip distances"},
    Topic("planes", "what becomes of clip planes"),
    {"--lower", kEquals, Choose<&PlaneOptions::lowering, kLoweringNames>, "<HOW>",
     "clip planes: clip-distance, level9 (the default of level_9_x), near-plane, discard or none"},
    {"--plane-space", kEquals, Choose<&PlaneOptions::space, kPlaneSpaceNames>, "<SPACE>",
     "the planes' space: clip (the default, fxc's), xyw1 or object, which lose less precision"},
    {"--position-input", kEquals, Set<&PlaneOptions::position_input>, "<SEM>",
     "the semantic of the input that --plane-space=object clips by (POSITION0)"},
    {"--fragment", kEquals, Set<&CommandLine::fragment>, "<FILE>",
     "with --lower=discard: add the discard to this GLSL; written as .frag"},
    {"--variants", kFlag, SetTo<&PlaneOptions::variants, kMaxClipPlanes>, "",
     "one shader for each number of clip planes: x.0.vert, x.1.vert ..; =N: up to N planes"},
    {"--variants=", kJoined, SetNumber<&PlaneOptions::variants, 0, kMaxClipPlanes>},
    {"--plane-distances", kEquals, SetNumber<&HlslOptions::plane_distances, 1, kMaxClipDistances>,
     "<N>", "with --target=hlsl: N clip distances, 0 for those without a plane"},
    Topic("position", "the position, and numbers of vertices"),
    {"--depth-range", kEquals, Choose<&passes::ClipSpaceOptions::negative_one_to_one, kDepthRanges>,
     "<RANGE>", "zero-to-one (as the HLSL writes it, the default) or negative-one-to-one"},
    {"--flip-y", kFlag, Set<&passes::ClipSpaceOptions::flip_y>, "",
     "negate gl_Position.y, after the clip planes"},
    {"--invariant", kFlag, Set<&StyleOptions::invariant>, "",
     "declare gl_Position `invariant`: equal positions in every pass"},
    {"--base-vertex", kEquals, SetForZero<&StyleOptions::base_vertex_is_zero>, "zero",
     "no draw has a base vertex: SV_VertexID is the API's own number"},
    {"--base-instance", kEquals, SetForZero<&StyleOptions::base_instance_is_zero>, "zero",
     "no draw has a base instance: SV_InstanceID is the API's own number"},
    Topic("linking", "outputs, and the pixel shader that reads them"),
    {"--pixel-shader", kEquals, Set<&ShaderSource::path>, "<FILE>",
     "fit this pixel shader: HLSL, GLSL or SPIR-V"},
    {"--pixel-entry", kEquals, Set<&ShaderSource::entry>, "<NAME>",
     "its entry function (main; of SPIR-V the only one); --pixel-profile=NAME (ps_5_0 beside "
     "vs_5_0)"},
    {"--pixel-output", kEquals, SetPixelOutput, "<FILE>",
     "write it too: HLSL, by default of the same file; a file, or .frag beside the other"},
    {"--pixel-profile", kEquals, Set<&ShaderSource::profile>},
    {"--geometry-entry", kEquals, SetMiddle<Stage::kGeometry, &MiddleShader::entry>, "<N>",
     "a stage before it, to --geometry-output=FILE; so too hull, domain; --planes-in-last-stage"},
    {"--geometry-output", kEquals, SetMiddle<Stage::kGeometry, &MiddleShader::output>},
    {"--hull-entry", kEquals, SetMiddle<Stage::kHull, &MiddleShader::entry>},
    {"--hull-output", kEquals, SetMiddle<Stage::kHull, &MiddleShader::output>},
    {"--domain-entry", kEquals, SetMiddle<Stage::kDomain, &MiddleShader::entry>},
    {"--domain-output", kEquals, SetMiddle<Stage::kDomain, &MiddleShader::output>},
    {"--tessellation", kEquals, SetTessellation},
    {"--planes-in-last-stage", kFlag, Set<&PlaneOptions::in_last_stage>},
    {"--keep-outputs", kFlag, Set<&LinkOptions::keep_outputs>, "",
     "also those that it does not read"},
    {"--zero-unwritten", kFlag, Set<&LinkOptions::zero_unwritten>, "",
     "write zeros to what the pixel shader reads and the vertex shader does not write"},
    {"--names", kEquals, Set<&StyleOptions::names>, "<STYLE>",
     "of outputs and blocks: hlslcc (the default), dxc, spirv-cross, or vs_{semantic}{index}"},
    {"--blocks", kEquals, Choose<&StyleOptions::blocks, kBlockStyles>, "<FORM>",
     "cbuffers: named (with an instance name, the default), plain or flat uniforms"},
    {"--bindings", kEquals, Bind<AddPreset>, "<NAME>",
     "the bindings of dxc, nvrhi or sdl, with target vulkan"},
    {"--pixel-bindings", kEquals, Bind<SetLaterBase, false>, "<N>",
     "a number, added to the bindings of a pixel or geometry shader alone (256, 512; GL 16, 32)"},
    {"--separable", kFlag, Set<&StyleOptions::separable>, "",
     "redeclare gl_PerVertex, for glUseProgramStages"},
    Topic("application", "what the application reads"),
    {"--table", kEquals, Set<&CommandLine::tables>, "<FILE>",
     "write the clip table: .json, .bin (Direct3D's record) or .h"},
    {"--reflect", kEquals, Set<&CommandLine::reflections>, "<FILE>",
     "write inputs, outputs, buffers and planes as JSON, or with .h buffers as C structs"},
    {"--struct-prefix", kEquals, Set<&CommandLine::struct_prefix>, "<NAME>",
     "what the names of these structs begin with"},
    Topic("builds", "make rules, and many shaders"),
    {"-MD", kFlag, Set<&CommandLine::write_dependencies>, "",
     "write a make rule with the files read, beside the output"},
    {"-MF", kJoinedOrSeparate, SetDependencyFile, "<FILE>", "write that rule to FILE"},
    {"-MT", kJoinedOrSeparate, Set<&CommandLine::dependency_target>, "<NAME>",
     "the target of that rule (the output file)"},
    {"-M", kFlag, Set<&CommandLine::only_dependencies>, "",
     "write only that rule, to standard output or to -MF's file"},
    {"-j", kJoinedOrSeparate, SetNumber<&CommandLine::jobs, 1, 256>, "<N>",
     "compile N of several files at once"},
    {"--batch", kEquals, Set<&CommandLine::batch>, "<FILE>",
     "compile the shaders of a JSON manifest; as -D 'A={0,1}', it writes an index of the outputs"},
    {"--effect", kFlag, Set<&CommandLine::effect>, "",
     "compile every pass of an effect (.fx), or those of --technique=NAME and --pass=NAME"},
    {"--technique", kEquals, Set<&CommandLine::technique>},
    {"--pass", kEquals, Set<&CommandLine::pass>},
    {"--effect-dialect", kEquals, Choose<&CommandLine::effect_dialect, kEffectDialects>},
    {"-k", kFlag, Set<&CommandLine::keep_going>, "",
     "compile the other shaders after one that has errors"},
    {"--index", kEquals, Set<&CommandLine::index>, "<FILE>",
     "the index of the outputs, as JSON (index.json beside them)"},
    {"--resume", kFlag, Set<&CommandLine::resume>, "",
     "compile only the shaders that a run which was interrupted or failed did not"},
    {"--shard", kEquals, SetShard, "<I/N>",
     "compile the I-th of N parts of the shaders; =merge: make one index of those of all parts"},
    {"--watch", kFlag, Set<&CommandLine::watch>, "",
     "compile again what changes, or reads what changes, until an interrupt"},
    Topic("limits", "shaders that nobody trusts"),
    {"--sandbox-includes", kEquals, Set<&IncludeOptions::sandbox>, "<D>",
     "read includes from the folder D only"},
    {"--max-seconds", kEquals, SetNumber<&Limits::seconds, 1, 1u << 20>, "<N>",
     "give up a shader after so many seconds"},
    {"--max-bytes", kEquals, SetNumber<&Limits::bytes, 1, 1u << 31>, "<N>",
     "refuse a shader whose text is longer, includes and all"},
    {"--max-tokens", kEquals, SetNumber<&Limits::tokens, 1, 1u << 31>, "<N>",
     "refuse a shader whose macros make more tokens (4194304)"},
    Topic("messages", "what is printed"),
    {"--diagnostics", kEquals, Choose<&CommandLine::format, kFormats>, "<FORM>",
     "text, msvc, json or sarif; on standard error"},
    {"-W", kJoined, SetWarning, "<NAME>",
     "turn a warning on; -Wno-<NAME> turns it off, and -Werror makes errors of warnings"},
    {"-w", kFlag, Set<&WarningOptions::no_warnings>, "", "print no warnings"},
    {"--explain", kEquals, SetExplained, "<NAME>",
     "explain a message by its name, or by fxc's code: its rule, an example and the fix"},
    {"--help", kFlag, SetTo<&CommandLine::action, Action::kHelp>, "", "print this"},
    {"--help=", kJoined, SetHelpTopic, "<TOPIC>",
     "print one of these topics, such as planes, or compilers: other compilers' options"},
    {"--version", kFlag, SetTo<&CommandLine::action, Action::kVersion>, "", "print the version"},
    Topic("stages", "a look into clipc"),
    {"--dump", kEquals, Choose<&DebugOptions::dump, kStages>, "<STAGE>",
     "print tokens, ast, ir, glsl or table and stop there"},
    {"--dump-after", kEquals, Set<&DebugOptions::dump_after>, "<PASS>",
     "print the program after a pass"},
    {"--stop-after", kEquals, Set<&DebugOptions::stop_after>, "<PASS>", "stop after a pass"},
    {"--verify", kFlag, Set<&DebugOptions::verify>, "",
     "check the program's form after every pass"},
};

}  // namespace

std::span<const Option> OwnOptions() { return kOwnOptions; }

}  // namespace clipc
