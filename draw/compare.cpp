// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "draw/compare.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

#include "draw/memory.h"
#include "ir/scalar.h"

namespace clipc::draw {
namespace {

constexpr std::size_t kMistakesKept = 4;

// GLSL 1.20 has no attributes and varyings of ints: they pass as floats.
std::uint32_t AsFloat(std::uint32_t word, ir::Scalar kind) {
  const double number = kind == ir::Scalar::kInt ? static_cast<std::int32_t>(word) : static_cast<double>(word);
  return std::bit_cast<std::uint32_t>(static_cast<float>(number));
}

void GiveAttributes(const Shader& shader, const RandomInputs& random, Inputs& inputs) {
  const ir::Program& program = shader.lowered;
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    if (program.inputs[i].builtin != ir::Builtin::kNone) continue;
    const glsl::GlslInfo::Variable& written = shader.info.inputs.at(i);
    const ir::Type& type = program.types[program.vars[program.inputs[i].var].type];
    const ir::Scalar kind = ir::BaseOf(type.scalar);
    Inputs::Attribute attribute{written.name, {}};
    for (int vertex = 0; vertex < inputs.vertices; ++vertex) {
      for (std::uint32_t k = 0; k < type.Components(); ++k) {
        const auto word = static_cast<std::uint32_t>(random.vertices[vertex][i][k]);
        attribute.words.push_back(written.integer_as_float ? AsFloat(word, kind) : word);
      }
    }
    inputs.attributes.push_back(std::move(attribute));
  }
}

double LargestOf(const Expected& expected) {
  double largest = 0;
  for (const double number : expected.numbers) {
    if (std::isfinite(number)) largest = std::max(largest, std::abs(number));
  }
  return largest;
}

std::string Describe(const Expected& expected, std::size_t index, std::uint32_t got, const char* why) {
  const std::size_t components = static_cast<std::size_t>(expected.components);
  const bool is_float = expected.kind == ir::Scalar::kFloat;
  const auto number = [&](std::uint32_t word) { return ir::NumberOf(word, is_float ? ir::Scalar::kFloat : expected.kind); };
  char text[256];
  std::snprintf(text, sizeof text, "vertex %zu, %s[%zu]: OpenGL %.9g, expected %.9g (%.17g in double)%s",
                index / components, expected.name.c_str(), index % components, number(got),
                number(expected.words[index]), expected.numbers[index], why);
  return text;
}

// Mesa 22.3 does not capture cull distances: there they are an output like any other.
std::string Capturable(std::string text) {
  constexpr std::string_view kCull = "gl_CullDistance";
  for (std::size_t at = text.find(kCull); at != std::string::npos; at = text.find(kCull, at)) {
    text.replace(at, kCull.size(), "cull_distance");
  }
  return text;
}

class Comparer {
 public:
  explicit Comparer(const Tolerance& tolerance) : tolerance_(tolerance) {}

  void Compare(const Expected& expected, const Captured& captured) {
    const Shape shape = ShapeOf(captured.type);
    if (shape.Words() * captured.count != expected.components || captured.words.size() != expected.words.size()) {
      return Fail(expected.name + " has another number of components");
    }
    const double largest = LargestOf(expected);
    for (std::size_t i = 0; i < expected.words.size(); ++i) {
      ++result_.values;
      if (expected.open[i]) {
        ++result_.undefined;
      } else if (expected.kind == ir::Scalar::kFloat) {
        CompareFloat(expected, i, captured.words[i], largest);
      } else if (captured.words[i] ==
                 (shape.kind == Shape::Kind::kFloat ? AsFloat(expected.words[i], expected.kind) : expected.words[i])) {
        ++result_.equal;
      } else {
        Fail(Describe(expected, i, captured.words[i], ""));
      }
    }
  }

  Comparison& result() { return result_; }

 private:
  void CompareFloat(const Expected& expected, std::size_t index, std::uint32_t word, double largest) {
    const float got = std::bit_cast<float>(word), want = std::bit_cast<float>(expected.words[index]);
    if (std::isnan(want)) {
      ++result_.undefined;
      return;
    }
    if (got == want) {
      ++result_.equal;
      return;
    }
    const double number = expected.numbers[index];
    const double unit = 0x1p-24 * std::max(std::abs(number), largest);
    const double error = std::abs(got - number) / unit;
    const double allowed = std::max(tolerance_.ulps * unit, tolerance_.roundings * RoundingOf(expected, index));
    if (!(std::abs(got - number) <= allowed)) return Fail(Describe(expected, index, word, ""));
    result_.worst = std::max(result_.worst, error);
  }

  // How far the evaluator's own float32 result is from the double one, at worst in the vector that `index` belongs to.
  static double RoundingOf(const Expected& expected, std::size_t index) {
    const auto size = static_cast<std::size_t>(expected.components);
    const std::size_t first = index / size * size;
    double worst = 0;
    for (std::size_t i = first; i < first + size; ++i) {
      const double rounding = std::abs(std::bit_cast<float>(expected.words[i]) - expected.numbers[i]);
      if (std::isfinite(rounding)) worst = std::max(worst, rounding);
    }
    return worst;
  }

  void Fail(std::string what) {
    ++result_.wrong;
    if (result_.mistakes.size() < kMistakesKept) result_.mistakes.push_back(std::move(what));
  }

  Tolerance tolerance_;
  Comparison result_;
};

}  // namespace

Comparison CompareWithOpenGl(Device& device, const Shader& shader, const std::vector<Expected>& expected,
                             const RandomInputs& random, const RandomOptions& draw, const Tolerance& tolerance) {
  std::string text = ForOpenGl(shader.glsl);
  if (std::ranges::any_of(shader.info.objects, [](const auto& object) { return object.set.has_value(); })) {
    throw NotForTarget("OpenGL does not take the textures and buffers of a shader for Vulkan");
  }
  text = Capturable(std::move(text));
  const Gl& gl = device.Use(VersionOf(text).api);
  Inputs inputs;
  inputs.instances = draw.instances;
  inputs.vertices = draw.vertices;
  inputs.first_vertex = draw.first_vertex;
  inputs.base_instance = draw.base_instance;
  GiveAttributes(shader, random, inputs);
  GiveConstants(shader.lowered, shader.info, random.cbuffers, inputs);
  GiveTextures(shader.lowered, shader.info, random.textures, inputs);
  GiveBuffers(shader.lowered, shader.info, random.buffers, inputs);
  std::vector<std::string> names;
  std::vector<const Expected*> outputs;  // what nothing is written to cannot be captured
  for (const Expected& output : expected) {
    if (std::ranges::find(output.open, false) == output.open.end()) continue;
    outputs.push_back(&output);
    names.push_back(Capturable(output.name));
  }
  Comparer comparer(tolerance);
  comparer.result().vertices = static_cast<int>(random.vertices.size());
  if (outputs.empty()) return comparer.result();
  const std::vector<Captured> captured = Capture(gl, text, names, inputs);
  for (std::size_t i = 0; i < outputs.size(); ++i) comparer.Compare(*outputs[i], captured[i]);
  return comparer.result();
}

}  // namespace clipc::draw
