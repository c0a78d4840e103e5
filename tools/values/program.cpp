// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/values/program.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "base/stage.h"

namespace clipc::values {
namespace {

using Json = nlohmann::json;

std::string ProfileOf(const std::string& stage, Model model) {
  std::string profile = stage + "_" + std::string(kModels[model]);
  std::ranges::replace(profile, '.', '_');
  return profile;
}

// 2 of "t2".
std::uint32_t NumberOf(const std::string& name) {
  return static_cast<std::uint32_t>(std::strtoul(name.c_str() + 1, nullptr, 10));
}

// Cuts "[3]" off "float2[3]", the outermost array first, and returns 3, or 0 of another type.
std::uint32_t CutArray(std::string& type) {
  const std::size_t open = type.find('[');
  if (open == type.npos) return 0;
  const std::size_t close = type.find(']', open);
  const auto count = static_cast<std::uint32_t>(std::strtoul(type.c_str() + open + 1, nullptr, 10));
  type.erase(open, close + 1 - open);
  return count;
}

// The registers that Direct3D 9 gives the members of a buffer: each begins one, also in a struct.
class Registers {
 public:
  Registers(const Json& structs, ConstantBuffer& buffer) : structs_(structs), buffer_(buffer) {}

  // fxc gives registers to the members that a shader reads, and to those that need the most of them
  // first.
  void PlaceAll(const Json& buffer, const std::string& glsl) {
    const std::string instance = buffer.at("glsl").value("instance", "");
    std::vector<Json> members;
    for (const Json& member : buffer.at("members")) {
      const std::string name = member.value("glsl", "");
      const std::string tail = name.substr(std::min(name.find('.'), name.size()));
      if (glsl.find(instance + tail.substr(0, tail.find('['))) != glsl.npos)
        members.push_back(member);
    }
    std::ranges::stable_sort(members, std::greater{},
                             [&](const Json& member) { return CountOf(TypeOf(member)); });
    std::uint32_t number = 0;
    for (const Json& member : members) {
      Place(TypeOf(member), member.at("offset"), number);
      number += CountOf(TypeOf(member));
    }
  }

 private:
  std::uint32_t CountOf(std::string type) const {
    if (const std::uint32_t count = CutArray(type)) return count * CountOf(type);
    if (const Json* fields = FieldsOf(type)) {
      std::uint32_t sum = 0;
      for (const Json& field : *fields) sum += CountOf(TypeOf(field));
      return sum;
    }
    return RegisterCountOf(type).registers;
  }

  void Place(std::string type, std::uint32_t byte, std::uint32_t number) {
    if (const std::uint32_t count = CutArray(type)) {
      const std::uint32_t registers = CountOf(type), stride = (BytesOf(type) + 15) / 16 * 16;
      for (std::uint32_t i = 0; i < count; ++i)
        Place(type, byte + i * stride, number + i * registers);
      return;
    }
    if (const Json* fields = FieldsOf(type)) {
      for (const Json& field : *fields) {
        Place(TypeOf(field), byte + field.at("offset").get<std::uint32_t>(), number);
        number += CountOf(TypeOf(field));
      }
      return;
    }
    const RegisterCount count = RegisterCountOf(type);
    for (std::uint32_t i = 0; i < count.registers; ++i) {
      for (std::uint32_t k = 0; k < count.components; ++k) {
        buffer_.components.push_back({byte + 16 * i + 4 * k, 4 * (number + i) + k,
                                      type.find("bool") != type.npos  ? 'b'
                                      : type.find("int") != type.npos ? 'i'
                                                                      : 'f'});
      }
    }
  }

  struct RegisterCount {
    std::uint32_t registers = 1, components = 1;
  };

  // The type of a member, with the word that a field beside it says.
  static std::string TypeOf(const Json& member) {
    return (member.value("rowMajor", false) ? "row_major " : "") +
           member.at("type").get<std::string>();
  }

  const Json* FieldsOf(const std::string& type) const {
    for (const Json& each : structs_) {
      if (each.at("name") == type) return &each.at("fields");
    }
    return nullptr;
  }

  // Of a scalar, a vector or a matrix: "row_major float3x4".
  static RegisterCount RegisterCountOf(const std::string& type) {
    const std::size_t by = type.rfind('x');
    const bool is_matrix = by != type.npos && by + 2 == type.size() && by > 0 &&
                           std::isdigit(static_cast<unsigned char>(type[by - 1])) != 0;
    const auto digit = [&](std::size_t at) { return static_cast<std::uint32_t>(type[at] - '0'); };
    if (is_matrix) {
      const std::uint32_t rows = digit(by - 1), columns = digit(by + 1);
      return type.starts_with("row_major") ? RegisterCount{rows, columns}
                                           : RegisterCount{columns, rows};
    }
    const bool is_vector = std::isdigit(static_cast<unsigned char>(type.back())) != 0 &&
                           !type.ends_with("16") && !type.ends_with("10") && !type.ends_with("12");
    return {1, is_vector ? digit(type.size() - 1) : 1};
  }

  std::uint32_t BytesOf(std::string type) const {
    if (const std::uint32_t count = CutArray(type)) {
      const std::uint32_t bytes = BytesOf(type);
      return (count - 1) * ((bytes + 15) / 16 * 16) + bytes;
    }
    if (const Json* fields = FieldsOf(type)) {
      std::uint32_t bytes = 0;
      for (const Json& field : *fields)
        bytes = std::max(bytes, field.at("offset").get<std::uint32_t>() + BytesOf(TypeOf(field)));
      return bytes;
    }
    const RegisterCount count = RegisterCountOf(type);
    return 16 * (count.registers - 1) + 4 * count.components;
  }

  const Json& structs_;
  ConstantBuffer& buffer_;
};

void AddBuffers(const Json& reflection, const std::string& text, CompiledPair& pair) {
  for (const Json& each : reflection.at("cbuffers")) {
    if (!each.at("used").get<bool>()) continue;
    const Json& glsl = each.at("glsl");
    if (!glsl.contains("block"))
      throw std::runtime_error("the buffer " + each.at("name").get<std::string>() +
                               " is not a block");
    ConstantBuffer buffer{glsl.at("block"), NumberOf(each.at("register")), each.at("size"), {}};
    Registers registers(reflection.at("structs"), buffer);
    registers.PlaceAll(each, text);
    pair.buffers.push_back(std::move(buffer));
  }
}

void AddObjects(const Json& reflection, CompiledPair& pair) {
  for (const Json& each : reflection.at("resources")) {
    if (!each.contains("glsl") || !each.contains("texture")) continue;
    const Json& texture = each.at("texture");
    Object object;
    object.name = each.at("glsl");
    object.binding = each.value("binding", 0u);
    object.type = texture.at("type");
    while (const std::uint32_t count = CutArray(object.type)) object.count *= count;
    const std::string place = texture.at("register");
    object.number = NumberOf(place);
    object.is_storage = place.starts_with('u');
    if (place.starts_with('s')) object.samplers.push_back(object.number);
    if (each.contains("sampler")) {
      const Json& sampler = each.at("sampler");
      object.samplers.push_back(NumberOf(sampler.at("register")));
      object.compares = sampler.at("type").get<std::string>().starts_with("SamplerComparison");
    }
    pair.objects.push_back(std::move(object));
  }
}

void AddInputs(const Json& reflection, CompiledPair& pair) {
  for (const Json& input : reflection.at("inputs")) {
    if (!input.contains("location")) continue;
    const std::string type = input.at("type");
    pair.inputs.push_back({input.at("semantic"), input.at("index"), input.at("location"),
                           type.starts_with("int") || type.starts_with("uint")});
  }
}

// What the shader, whose GLSL is `text`, reads.
void AddUses(const Json& reflection, const std::string& text, CompiledPair& pair) {
  AddBuffers(reflection, text, pair);
  AddObjects(reflection, pair);
}

}  // namespace

CompiledPair PairCompiler::Compile(const ShaderTexts& texts, Model model) {
  if (!texts.between.empty()) return CompileProgram(texts, model);
  library::Request request;
  request.path = "vertex.hlsl";
  request.text = texts.vertex;
  request.pixel_text = texts.pixel;
  request.options = {"-T",
                     ProfileOf("vs", model),
                     "--pixel-shader=pixel.hlsl",
                     "--pixel-profile=" + ProfileOf("ps", model),
                     "--pixel-output=.frag",
                     "--zero-unwritten"};
  request.options.insert(request.options.end(), texts.options.begin(), texts.options.end());
  const library::Result result = compiler_.Compile(request);
  CompiledPair pair;
  if (!result.ok()) {
    pair.refusal = result.messages();
    return pair;
  }
  pair.vertex = result.glsl();
  pair.pixel = result.Get(CLIPC_PART_PIXEL);
  const Json reflection = Json::parse(result.Get(CLIPC_PART_REFLECTION));
  AddInputs(reflection, pair);
  AddUses(reflection, pair.vertex, pair);
  AddUses(reflection.at("pixelShader"), pair.pixel, pair);
  return pair;
}

// The stages of a program are entries of one file, in which each stage is a namespace.
CompiledPair PairCompiler::CompileProgram(const ShaderTexts& texts, Model model) {
  library::Request request;
  request.path = "program.hlsl";
  std::string text;
  const auto add = [&](const std::string& stage, const std::string& part) {
    text += "namespace " + stage + "_ {\n" + part + "}\n";
    return stage + "_::main";
  };
  request.options = {"-T", ProfileOf("vs", model), "-E", add("vertex", texts.vertex)};
  request.options.push_back("--pixel-entry=" + add("pixel", texts.pixel));
  request.options.emplace_back("--pixel-output=.frag");
  request.options.emplace_back("--zero-unwritten");
  for (const auto& [stage, part] : texts.between) {
    request.options.push_back("--" + stage + "-entry=" + add(stage, part));
    const auto* known = std::ranges::find(kStages, stage, &StageInfo::name);
    request.options.push_back("--" + stage + "-output=" + std::string(known->extension));
  }
  request.text = text;
  request.options.insert(request.options.end(), texts.options.begin(), texts.options.end());
  const library::Result result = compiler_.Compile(request);
  CompiledPair pair;
  if (!result.ok()) {
    pair.refusal = result.messages();
    return pair;
  }
  const Json reflection = Json::parse(result.Get(CLIPC_PART_REFLECTION));
  AddInputs(reflection, pair);
  for (std::size_t i = 0; const clipc_shader* shader = result.shader(i); ++i) {
    const std::string stage = shader->stage, glsl(shader->text.data, shader->text.size);
    (stage == "vertex" ? pair.vertex : stage == "pixel" ? pair.pixel : pair.between[stage]) = glsl;
    AddUses(i == 0 ? reflection : reflection.at(stage + "Shader"), glsl, pair);
  }
  return pair;
}

CompiledPair PairCompiler::CompileCompute(const std::string& text, Model model,
                                          const std::vector<std::string>& options) {
  library::Request request;
  request.path = "compute.hlsl";
  request.text = text;
  request.options = {"-T", ProfileOf("cs", model)};
  request.options.insert(request.options.end(), options.begin(), options.end());
  const library::Result result = compiler_.Compile(request);
  CompiledPair compiled;
  if (!result.ok()) {
    compiled.refusal = result.messages();
    return compiled;
  }
  compiled.compute = result.glsl();
  const Json reflection = Json::parse(result.Get(CLIPC_PART_REFLECTION));
  AddUses(reflection, compiled.compute, compiled);
  return compiled;
}

std::string PairCompiler::WhyRefused(const std::string& text, const std::string& stage, Model model,
                                     const std::vector<std::string>& options) {
  library::Request request;
  request.path = "shader.hlsl";
  request.text = text;
  request.options = {"-T", ProfileOf(stage, model)};
  request.options.insert(request.options.end(), options.begin(), options.end());
  const library::Result result = compiler_.Compile(request);
  return result.ok() ? "" : std::string(result.messages());
}

}  // namespace clipc::values
