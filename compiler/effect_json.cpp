// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "compiler/effect_passes.h"

namespace clipc {
namespace {

using EffectJson = nlohmann::ordered_json;

EffectJson ListOf(const std::vector<ast::NamedText>& texts) {
  EffectJson list = EffectJson::array();
  for (const auto& [name, value] : texts) list.push_back({{"name", name}, {"value", value}});
  return list;
}

EffectJson ListOf(const std::vector<ast::Annotation>& annotations) {
  EffectJson list = EffectJson::array();
  for (const auto& [type, name, value] : annotations)
    list.push_back({{"type", type}, {"name", name}, {"value", value}});
  return list;
}

// A member that only some have: an empty list or text is left out.
template <typename Value>
void AddUnlessEmpty(EffectJson& object, const char* name, const Value& value) {
  if (value.empty()) return;
  if constexpr (requires { ListOf(value); }) {
    object[name] = ListOf(value);
  } else {
    object[name] = value;
  }
}

EffectJson HalfOf(const EffectHalf& half) {
  const ast::EffectShader& shader = *half.shader;
  EffectJson json = {{"entry", shader.function}, {"profile", shader.profile}};
  AddUnlessEmpty(json, "call", shader.call);
  if (half.element) json["element"] = *half.element;
  return json;
}

// What the effect's JSON calls a file of a batch: the stage, whether it is GLSL or SPIR-V, and the
// number of a variant.
std::string FileKind(std::string_view kind, bool is_pixel_alone) {
  if (kind == "fragment.spirv") return "fragment";
  for (const std::string_view first : {"glsl", "spirv"}) {
    if (kind == first || (kind.starts_with(first) && kind[first.size()] == '.'))
      return (is_pixel_alone ? "fragment" : "vertex") + std::string(kind.substr(first.size()));
  }
  return std::string(kind);
}

EffectJson ProgramOf(const EffectProgram& program, const BatchEntry& entry) {
  EffectJson json = EffectJson::object();
  if (program.vertex) json["vertex"] = HalfOf(*program.vertex);
  if (program.pixel) json["pixel"] = HalfOf(*program.pixel);
  const bool is_compiled = entry.status == BatchStatus::kCompiled;
  json["status"] = is_compiled ? "compiled" : "failed";
  json["files"] = EffectJson::object();
  for (const auto& [kind, file] : entry.files)
    json["files"][FileKind(kind, !program.vertex)] = file;
  return json;
}

EffectJson PassOf(const ast::EffectPass& pass, const PassPrograms& programs,
                  const std::vector<BatchEntry>& entries) {
  EffectJson json = {{"name", pass.name}};
  AddUnlessEmpty(json, "annotations", pass.annotations);
  if (programs.is_left_out) json["leftOut"] = true;
  json["programs"] = EffectJson::array();
  for (const EffectProgram& program : programs.programs)
    json["programs"].push_back(ProgramOf(program, entries[program.group]));
  AddUnlessEmpty(json, "vertexShader", pass.vertex.text);
  AddUnlessEmpty(json, "pixelShader", pass.pixel.text);
  AddUnlessEmpty(json, "otherShaders", pass.other_shaders);
  json["states"] = ListOf(pass.states);
  AddUnlessEmpty(json, "notRead", pass.not_read);
  return json;
}

EffectJson TechniqueOf(const ast::EffectTechnique& technique) {
  EffectJson json = {{"name", technique.name}, {"kind", technique.kind}};
  AddUnlessEmpty(json, "group", technique.group);
  AddUnlessEmpty(json, "annotations", technique.annotations);
  AddUnlessEmpty(json, "notRead", technique.not_read);
  json["passes"] = EffectJson::array();
  return json;
}

// `initial_values` are those of the programs, by name.
EffectJson ParameterOf(const ast::EffectParameter& parameter,
                       const std::map<std::string, std::string>& initial_values) {
  EffectJson json = {{"name", parameter.name}, {"type", parameter.type}};
  AddUnlessEmpty(json, "semantic", parameter.semantic);
  AddUnlessEmpty(json, "annotations", parameter.annotations);
  AddUnlessEmpty(json, "value", parameter.value);
  if (const auto found = initial_values.find(parameter.name); found != initial_values.end())
    json["default"] = found->second;
  AddUnlessEmpty(json, "states", parameter.states);
  for (const ast::EffectShader& shader : parameter.shaders) json["shaders"].push_back(shader.text);
  return json;
}

}  // namespace

std::string RenderEffect(const ast::Effect& effect, const EffectPrograms& programs,
                         const CommandLine& command, const std::vector<BatchEntry>& entries) {
  EffectJson json = {{"version", 1},
                     {"effect", command.inputs[0]},
                     {"target", command.request.target.name()},
                     {"techniques", EffectJson::array()},
                     {"parameters", EffectJson::array()}};
  std::size_t last = effect.techniques.size();
  for (const PassPrograms& pass : programs.passes) {
    const ast::EffectTechnique& technique = effect.techniques[pass.technique];
    if (pass.technique != last) json["techniques"].push_back(TechniqueOf(technique));
    last = pass.technique;
    json["techniques"].back()["passes"].push_back(
        PassOf(technique.passes[pass.pass], pass, entries));
  }
  std::map<std::string, std::string> initial_values;
  for (const BatchEntry& entry : entries)
    initial_values.insert(entry.initial_values.begin(), entry.initial_values.end());
  for (const ast::EffectParameter& parameter : effect.parameters)
    json["parameters"].push_back(ParameterOf(parameter, initial_values));
  return json.dump(2, ' ', false, EffectJson::error_handler_t::replace) + "\n";
}

}  // namespace clipc
