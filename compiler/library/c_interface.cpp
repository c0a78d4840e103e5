// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <array>
#include <deque>
#include <exception>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "clip-table/write.h"
#include "compiler/clipc.h"
#include "compiler/clipc_effect.h"
#include "compiler/command/options.h"
#include "compiler/command/structs.h"
#include "compiler/command/usage.h"
#include "compiler/compile/compile.h"
#include "compiler/compile/facts_json.h"
#include "compiler/compile/message.h"
#include "compiler/compile/token_digest.h"
#include "compiler/effect/compile_effect.h"
#include "compiler/effect/effect_json.h"
#include "compiler/library/effect_structs.h"
#include "compiler/library/result_structs.h"

// NOLINTBEGIN(readability-identifier-naming): names of the C interface.
struct clipc_compiler {
  clipc::Compiler compiler;
};

struct clipc_result {
  mutable std::array<std::string, CLIPC_PART_EFFECT_HEADER + 1> parts;
  std::optional<clipc::Facts> facts;
  std::optional<clipc::EffectFacts> effect_facts;
  std::vector<clipc::Message> messages;
  mutable std::vector<clipc_shader> shaders;  // their texts and words are parts, or in `middle`
  std::deque<std::pair<std::string, std::string>> middle;
  std::vector<std::unique_ptr<clipc_result>> variants;
  std::vector<std::unique_ptr<clipc_result>> programs;  // of an effect; null: it has errors
  // Made when they are first asked for, as the JSON of the facts is.
  mutable std::optional<std::vector<clipc_diagnostic>> diagnostics;
  mutable std::unique_ptr<clipc::ReflectionStructs> reflection;
  mutable std::unique_ptr<clipc::EffectStructs> effect;
};

namespace {

using clipc::clip_table::Format;

clipc_status StatusOf(clipc::Status status) {
  switch (status) {
    case clipc::Status::kOk: return CLIPC_COMPILED;
    case clipc::Status::kErrors: return CLIPC_HAS_ERRORS;
    case clipc::Status::kBadRequest: return CLIPC_BAD_REQUEST;
    case clipc::Status::kCancelled: return CLIPC_CANCELLED;
  }
  return CLIPC_HAS_ERRORS;
}

// The request with the members that this library knows; those that the caller does not are zero.
clipc_request Known(const clipc_request& request) {
  clipc_request known{};
  std::copy_n(reinterpret_cast<const char*>(&request), std::min(request.size, sizeof known),
              reinterpret_cast<char*>(&known));
  return known;
}

// Returns the option, of those given, that only a program can follow: it names an input or an
// output, or is about several shaders. Empty if there is none.
std::string ProgramsOption(const clipc::CommandLine& command) {
  const auto named = [](const std::string& file) { return !file.empty(); };
  if (!command.inputs.empty()) return command.inputs[0];
  if (named(command.output)) return "-o";
  if (!command.tables.empty()) return "--table";
  for (const std::string& reflection : command.reflections)
    if (reflection != ".h") return "--reflect";
  if (named(command.header) && !(command.effect && command.header == ".h")) return "-Fh";
  if (command.spirv_form == clipc::CommandLine::SpirvForm::kListing) return "-S";
  if (command.spirv_form != clipc::CommandLine::SpirvForm::kBinary) return "-mfmt";
  if (named(command.listing)) return "-Fc";
  if (named(command.messages)) return "-Fe";
  if (named(command.preprocessed) && command.preprocessed != ".i") return "-P";
  if (named(command.fragment)) return "--fragment";
  if (named(command.pixel_output) && command.pixel_output != ".frag") return "--pixel-output";
  for (std::size_t i = 0; i < command.middle.size(); ++i) {
    const std::string& output = command.middle[i].output;
    const clipc::StageInfo& stage = clipc::InfoOf(clipc::kMiddleStages[i]);
    if (named(output) && output != stage.extension) return fmt::format("--{}-output", stage.name);
  }
  if (command.write_dependencies || named(command.dependency_file)) return "-MD";
  if (command.only_dependencies) return "-M";
  if (named(command.batch)) return "--batch";
  if (named(command.index)) return "--index";
  if (command.shards != 1 || command.merge_shards) return "--shard";
  if (command.resume) return "--resume";
  if (command.keep_going) return "-k";
  if (command.watch) return "--watch";
  if (command.show_includes) return "-H";
  if (command.syntax_only) return "-fsyntax-only";
  if (command.request.debug.changes_result()) return "--dump";
  if (command.action == clipc::CommandLine::Action::kHelp) return "--help";
  if (command.action == clipc::CommandLine::Action::kExplain) return "--explain";
  if (command.action == clipc::CommandLine::Action::kVersion) return "--version";
  return {};
}

std::string Hex(const clipc::TokenDigest& digest) {
  return fmt::format("{:016x}{:016x}", digest[0], digest[1]);
}

// The options that decide a result beside the text: without macros, which are in the text, and
// folders of includes. Empty if a file has more options.
std::vector<std::string> DecisiveOptions(const clipc_request& from,
                                         const clipc::ProgramRequest& request) {
  std::vector<std::string> options = {CLIPC_VERSION};
  for (std::size_t i = 0; i < from.option_count; ++i) {
    const std::string_view option = from.options[i];
    if (option.starts_with('@')) return {};
    const auto is_that = [&](const std::string& value) {
      if (option.substr(2) == value) return true;
      const bool is_next = option.size() == 2 && i + 1 < from.option_count;
      return is_next && from.options[i + 1] == value && ++i > 0;
    };
    const auto is_one_of = [&](const std::vector<std::string>& values) {
      return std::ranges::any_of(values, is_that);
    };
    const std::string_view name = option.substr(1, 1);
    if (name == "D" && is_one_of(request.defines)) continue;
    if (name == "I" && is_one_of(request.includes.dirs)) continue;
    options.emplace_back(option);
  }
  return options;
}

// The first mistake in the options.
clipc::Result<> ReadRequest(const clipc_request& from, clipc::CommandLine& command) {
  clipc::ParsedCommandLine parsed = clipc::ParseCommandLine({from.options, from.option_count});
  if (!parsed.result) return parsed.result;
  if (const std::string option = ProgramsOption(parsed.command); !option.empty()) {
    return clipc::Problem{
        fmt::format("`{}` is for the program; the library compiles one shader or effect, and what "
                    "comes out is memory",
                    option)};
  }
  if (clipc::Result<> middle = clipc::CheckMiddle(parsed.command); !middle) return middle;
  command = std::move(parsed.command);
  clipc::ProgramRequest& to = command.request;
  clipc::ShaderSource& first = to.first();
  first.path = from.path ? from.path : "";
  if (from.text) first.text.emplace(from.text, from.text_size);
  if (!from.text && !from.path) return clipc::Problem{"there is no shader"};
  if (from.pixel_text && to.neighbour) {
    to.neighbour->text.emplace(from.pixel_text, from.pixel_text_size);
  } else if (from.pixel_text && !to.shaders.back().path.empty() && to.shaders.size() > 1) {
    to.shaders.back().text.emplace(from.pixel_text, from.pixel_text_size);
  }
  to.outputs.facts = true;
  to.outputs.preprocess = !command.preprocessed.empty();
  to.planes.given_to_device = true;
  if (from.read_include) {
    to.includes.read = [=](const std::string& path) -> std::optional<std::string> {
      clipc_bytes bytes{};
      if (!from.read_include(from.read_include_context, path.c_str(), &bytes)) return std::nullopt;
      return std::string(bytes.data, bytes.size);
    };
  }
  if (from.is_cancelled)
    to.limits.is_cancelled = [=] { return from.is_cancelled(from.is_cancelled_context) != 0; };
  std::vector<std::string> options = DecisiveOptions(from, to);
  if (from.is_known && !options.empty()) {
    to.is_known = [=](const clipc::TokenDigest& text) {
      std::vector<std::string> all = options;
      all.push_back(Hex(text));
      return from.is_known(from.is_known_context, Hex(clipc::DigestOf(all)).c_str()) != 0;
    };
  }
  return {};
}

// Fills the shaders of a program, and the parts that are the first one and the pixel shader: texts,
// and SPIR-V where there is some.
void Fill(std::vector<clipc::ShaderOutput> shaders, clipc_part first_text, clipc_result& to) {
  for (clipc::ShaderOutput& shader : shaders) {
    const bool is_first = &shader == &shaders.front();
    const bool is_fragment = shader.stage.value_or(clipc::Stage::kPixel) == clipc::Stage::kPixel;
    if (!is_first && !is_fragment) to.middle.emplace_back();
    std::string& text = is_first      ? to.parts[first_text]
                        : is_fragment ? to.parts[CLIPC_PART_DISCARD]
                                      : to.middle.back().first;
    std::string& spirv = is_first      ? to.parts[CLIPC_PART_SPIRV]
                         : is_fragment ? to.parts[CLIPC_PART_PIXEL_SPIRV]
                                       : to.middle.back().second;
    text = std::move(shader.text);
    spirv.assign(reinterpret_cast<const char*>(shader.spirv.data()), 4 * shader.spirv.size());
    if (!shader.stage) continue;
    to.shaders.push_back({clipc::InfoOf(*shader.stage).name.data(),
                          {text.data(), text.size()},
                          {spirv.data(), spirv.size()},
                          nullptr});
  }
}

void Fill(clipc::Outputs outputs, bool is_hlsl, clipc_result& to) {
  Fill(std::move(outputs.shaders), is_hlsl ? CLIPC_PART_HLSL : CLIPC_PART_GLSL, to);
  for (std::vector<clipc::ShaderOutput>& variant : outputs.variants) {
    clipc_result& part = *to.variants.emplace_back(std::make_unique<clipc_result>());
    Fill(std::move(variant), CLIPC_PART_GLSL, part);
  }
  to.facts = std::move(outputs.facts);
  if (!outputs.table) return;
  const std::pair<int, Format> forms[] = {{CLIPC_PART_TABLE_JSON, Format::kJson},
                                          {CLIPC_PART_TABLE_BINARY, Format::kBinary},
                                          {CLIPC_PART_TABLE_HEADER, Format::kHeader}};
  for (const auto& [part, form] : forms) {
    if (auto text = clipc::clip_table::Write(*outputs.table, form, "")) to.parts[part] = *text;
  }
}

void Fill(clipc::CompileResult compiled, bool is_hlsl, clipc_result& to) {
  to.parts[CLIPC_PART_MESSAGES] = std::move(compiled.text);
  to.parts[CLIPC_PART_MESSAGES_JSON] = clipc::RenderJson(compiled.messages);
  for (const std::string& file : compiled.dependencies)
    to.parts[CLIPC_PART_DEPENDENCIES] += file + '\n';
  if (compiled.outputs) Fill(*std::move(compiled.outputs), is_hlsl, to);
  to.parts[CLIPC_PART_PREPROCESSED] = std::move(compiled.preprocessed);
  to.messages = std::move(compiled.messages);
}

clipc_status Refuse(const std::string& problem, clipc_result& to) {
  to.parts[CLIPC_PART_MESSAGES] = "clipc: error: " + problem + "\n";
  to.messages = {clipc::UsageMessage(problem)};
  to.parts[CLIPC_PART_MESSAGES_JSON] = clipc::RenderJson(to.messages);
  return CLIPC_BAD_REQUEST;
}

clipc_status CompileEffect(clipc::Compiler& compiler, clipc::CommandLine command,
                           clipc_result& to) {
  command.inputs = {command.request.first().path};
  clipc::Result<clipc::CompiledEffect> compiled = clipc::CompileEffect(command, compiler);
  if (!compiled) return Refuse(compiled.problem(), to);
  const clipc_status status = StatusOf(compiled->messages.status);
  Fill(std::move(compiled->messages), false, to);
  for (clipc::CompileResult& program : compiled->programs) {
    std::unique_ptr<clipc_result>& part = to.programs.emplace_back();
    if (!program.outputs) continue;
    part = std::make_unique<clipc_result>();
    Fill(std::move(program), false, *part);
    if (part->facts && !command.reflections.empty())
      part->parts[CLIPC_PART_STRUCTS] = clipc::WriteStructs(*part->facts, command.struct_prefix);
  }
  if (compiled->facts) to.parts[CLIPC_PART_EFFECT] = clipc::EffectJson(*compiled->facts);
  to.effect_facts = std::move(compiled->facts);
  to.parts[CLIPC_PART_EFFECT_HEADER] = std::move(compiled->header);
  return status;
}

clipc_status Compile(clipc::Compiler& compiler, const clipc_request& from, clipc_result& to) {
  clipc::CommandLine command;
  if (const clipc::Result<> read = ReadRequest(from, command); !read)
    return Refuse(read.problem(), to);
  if (command.effect) return CompileEffect(compiler, std::move(command), to);
  clipc::CompileResult compiled = compiler.Compile(command.request);
  const clipc_status status = compiled.is_repeated ? CLIPC_KNOWN : StatusOf(compiled.status);
  Fill(std::move(compiled), command.request.hlsl.wanted, to);
  if (to.facts && !command.reflections.empty())
    to.parts[CLIPC_PART_STRUCTS] = clipc::WriteStructs(*to.facts, command.struct_prefix);
  return status;
}

// The reflection of a shader of the result; null where there is none.
const clipc_reflection* ReflectionOf(const clipc_result& result, std::size_t shader) {
  if (!result.facts || shader >= result.facts->stages.size()) return nullptr;
  if (!result.reflection)
    result.reflection = std::make_unique<clipc::ReflectionStructs>(*result.facts);
  return &result.reflection->shader(shader);
}

}  // namespace

extern "C" {

uint32_t clipc_abi(void) { return CLIPC_ABI; }
const char* clipc_version(void) { return CLIPC_VERSION; }

clipc_compiler* clipc_compiler_create(void) {
  try {
    return new clipc_compiler;
  } catch (const std::exception&) {
    return nullptr;
  }
}

void clipc_compiler_free(clipc_compiler* compiler) { delete compiler; }

clipc_status clipc_compile(clipc_compiler* compiler, const clipc_request* request,
                           clipc_result** result) {
  *result = new (std::nothrow) clipc_result;
  if (!*result) return CLIPC_NO_MEMORY;
  try {
    return Compile(compiler->compiler, Known(*request), **result);
  } catch (const std::exception&) {
    delete std::exchange(*result, nullptr);
    return CLIPC_NO_MEMORY;
  }
}

void clipc_result_free(clipc_result* result) { delete result; }

clipc_bytes clipc_result_get(const clipc_result* result, clipc_part part) {
  const auto index = static_cast<std::size_t>(part);
  if (index >= result->parts.size()) return {"", 0};
  if (part == CLIPC_PART_REFLECTION && result->facts && result->parts[index].empty()) {
    try {
      result->parts[index] = clipc::FactsJson(*result->facts);
    } catch (const std::exception&) {
      return {"", 0};
    }
  }
  return {result->parts[index].data(), result->parts[index].size()};
}

const clipc_result* clipc_result_variant(const clipc_result* result, size_t planes) {
  return planes < result->variants.size() ? result->variants[planes].get() : nullptr;
}

const clipc_diagnostic* clipc_result_diagnostic(const clipc_result* result, size_t index) {
  try {
    auto& diagnostics = result->diagnostics;
    if (!diagnostics) diagnostics = clipc::ToDiagnostics(result->messages);
    return index < diagnostics->size() ? &(*diagnostics)[index] : nullptr;
  } catch (const std::exception&) {
    return nullptr;
  }
}

const clipc_reflection* clipc_result_reflection(const clipc_result* result) {
  try {
    return ReflectionOf(*result, 0);
  } catch (const std::exception&) {
    return nullptr;
  }
}

const clipc_shader* clipc_result_shader(const clipc_result* result, size_t index) {
  if (index >= result->shaders.size()) return nullptr;
  try {
    clipc_shader& shader = result->shaders[index];
    shader.reflection = ReflectionOf(*result, index);
    return &shader;
  } catch (const std::exception&) {
    return nullptr;
  }
}

const clipc_effect* clipc_result_effect(const clipc_result* result) {
  if (!result->effect_facts) return nullptr;
  try {
    if (!result->effect) {
      std::vector<const clipc_result*> programs;
      for (const auto& program : result->programs) programs.push_back(program.get());
      result->effect =
          std::make_unique<clipc::EffectStructs>(*result->effect_facts, std::move(programs));
    }
    return &result->effect->effect();
  } catch (const std::exception&) {
    return nullptr;
  }
}

}  // extern "C"
// NOLINTEND(readability-identifier-naming)
