// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "compiler/effect/effect_json.h"

#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/compile/facts_json.h"
#include "compiler/compile/json_writer.h"
#include "compiler/effect/vulkan_states.h"

namespace clipc {
namespace {

class EffectPrinter {
 public:
  explicit EffectPrinter(const EffectFacts& facts) : facts_(facts) {}

  std::string Print() && {
    json_.Object([&] {
      json_.Member("version", 1);
      json_.Member("effect", facts_.effect);
      json_.Member("target", facts_.target);
      json_.ListOf("techniques", facts_.techniques,
                   [&](const EffectTechniqueFact& fact) { Technique(fact); });
      json_.ListOf("parameters", facts_.parameters,
                   [&](const EffectParameterFact& fact) { Parameter(fact); });
    });
    return std::move(json_).Finish();
  }

 private:
  void State(const ast::EffectState& state) {
    json_.Member("name", state.name);
    json_.Member("value", state.text);
  }

  // What only some have: an empty list or text is left out.
  void Text(std::string_view text, JsonKey key) {
    if (!text.empty()) json_.Member(key, text);
  }
  void Texts(const std::vector<std::string>& texts, JsonKey key) {
    if (texts.empty()) return;
    json_.List(key, [&] {
      for (const std::string& text : texts) json_.Text(text);
    });
  }
  void Annotations(const std::vector<ast::Annotation>& annotations) {
    if (annotations.empty()) return;
    json_.ListOf("annotations", annotations, [&](const ast::Annotation& annotation) {
      json_.Member("type", annotation.type);
      json_.Member("name", annotation.name);
      json_.Member("value", annotation.value);
    });
  }

  void Shader(const EffectShaderFact& shader) {
    json_.Object(JsonKey(InfoOf(shader.stage).name), [&] {
      json_.Member("entry", shader.entry);
      json_.Member("profile", shader.profile);
      Text(shader.call, "call");
      if (shader.element) json_.Member("element", *shader.element);
    });
  }

  void Capture(const EffectCaptureFact& capture) {
    json_.Member("stream", capture.stream);
    json_.Member("slot", capture.slot);
    json_.Member("semantic", capture.semantic);
    json_.Member("index", capture.index);
    Text(capture.components, "components");
    Text(capture.name, "name");
  }

  void Program(const EffectProgramFact& program) {
    for (const EffectShaderFact& shader : program.shaders) Shader(shader);
    if (!program.captures.empty())
      json_.ListOf("streamOutput", program.captures,
                   [&](const EffectCaptureFact& capture) { Capture(capture); });
    json_.Member("status", program.is_compiled ? "compiled" : "failed");
    if (!facts_.has_files) return json_.Member("number", program.number);
    json_.Object("files", [&] {
      for (const auto& [kind, file] : program.files) json_.Member(JsonKey(kind), file);
    });
  }

  void Choice(const EffectChoice& choice) {
    json_.ListOf("values", choice.values, [&](const EffectChoice::Value& value) {
      json_.Member("text", value.text);
      json_.Member("count", value.count);
    });
    json_.List("programs", [&] {
      for (const std::optional<std::size_t>& program : choice.programs) json_.NumberOrNull(program);
    });
  }

  void Pass(const EffectPassFact& fact) {
    const ast::EffectPass& pass = fact.text;
    json_.Member("name", pass.name);
    Annotations(pass.annotations);
    if (fact.is_left_out) json_.Member("leftOut", true);
    json_.ListOf("programs", fact.programs, [&](const EffectProgramFact& it) { Program(it); });
    if (!fact.choices.empty())
      json_.ListOf("choices", fact.choices, [&](const EffectChoice& it) { Choice(it); });
    Text(pass.vertex.text, "vertexShader");
    Text(pass.pixel.text, "pixelShader");
    Text(pass.hull.text, "hullShader");
    Text(pass.domain.text, "domainShader");
    Text(pass.geometry.text, "geometryShader");
    Text(pass.compute.text, "computeShader");
    json_.ListOf("states", pass.states, [&](const ast::EffectState& state) { State(state); });
    if (facts_.is_for_vulkan) Vulkan(ReadVulkanStates(facts_, pass));
    Texts(pass.not_read, "notRead");
  }

  void Vulkan(const std::vector<VulkanState>& states) {
    if (states.empty()) return;
    json_.Object("vulkan", [&] {
      for (const auto& [member, value] : states)
        std::visit([&](auto number) { json_.Member(JsonKey(member), number); }, value);
    });
  }

  void Technique(const EffectTechniqueFact& technique) {
    json_.Member("name", technique.name);
    json_.Member("kind", technique.kind);
    Text(technique.group, "group");
    Annotations(technique.annotations);
    Texts(technique.not_read, "notRead");
    json_.ListOf("passes", technique.passes, [&](const EffectPassFact& pass) { Pass(pass); });
  }

  void Parameter(const EffectParameterFact& fact) {
    const ast::EffectParameter& parameter = fact.text;
    json_.Member("name", parameter.name);
    json_.Member("type", parameter.type);
    Text(parameter.semantic, "semantic");
    Annotations(parameter.annotations);
    Text(parameter.value, "value");
    Text(HexadecimalDigits(fact.initial), "default");
    const auto add_states = [&](const std::vector<ast::EffectState>& states) {
      json_.ListOf("states", states, [&](const ast::EffectState& state) { State(state); });
    };
    if (parameter.is_block) add_states(parameter.states);
    if (!parameter.elements.empty()) json_.ListOf("elements", parameter.elements, add_states);
    std::vector<std::string> shaders;
    for (const ast::EffectShader& shader : parameter.shaders) shaders.push_back(shader.text);
    Texts(shaders, "shaders");
  }

  const EffectFacts& facts_;
  JsonWriter json_;
};

}  // namespace

std::string EffectJson(const EffectFacts& facts) { return EffectPrinter(facts).Print(); }

}  // namespace clipc
