// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/geometry.h"

#include <array>
#include <utility>

namespace clipc::draw {
namespace {

using namespace ir;

// GLSL's name of a scalar or vector type.
std::string TypeText(const Type& type) {
  const Scalar kind = BaseOf(type.scalar);
  const bool is_float = kind == Scalar::kFloat, is_int = kind == Scalar::kInt;
  if (type.Components() == 1) return is_float ? "float" : is_int ? "int" : "uint";
  const std::string letter = is_float ? "" : is_int ? "i" : "u";
  return letter + "vec" + std::to_string(type.Components());
}

std::string QualifierOf(const IoVar& input, Scalar kind) {
  if (BaseOf(kind) != Scalar::kFloat || input.interpolation == Interpolation::kNoInterpolation)
    return "flat ";
  if (input.interpolation == Interpolation::kNoPerspective) return "noperspective ";
  return input.centroid ? "centroid " : input.sample ? "sample " : "";
}

// Whether the draw call gives the input, and no vertex has it.
bool IsOfPrimitive(Builtin builtin) {
  return builtin == Builtin::kPrimitiveId || builtin == Builtin::kEmitterId;
}

// Makes the vertex shader that passes the inputs on, and gives it their values.
class PassOn {
 public:
  PassOn(const Shader& shader, const RandomInputs& random, Inputs& inputs)
      : shader_(shader), program_(shader.lowered), random_(random), inputs_(inputs) {}

  std::string Text(const Version& version) {
    is_es_ = version.es;
    for (std::size_t i = 0; i < program_.inputs.size(); ++i) {
      const IoVar& input = program_.inputs[i];
      if (IsOfPrimitive(input.builtin) || !shader_.info.inputs.at(i).is_used) continue;
      Pass(i, input);
    }
    const std::string extension =
        is_es_ && version.number < 320 ? "#extension GL_EXT_shader_io_blocks : enable\n" : "";
    return version.Line() + extension + declarations_ + "\nvoid main() {\n" + body_ + "}\n";
  }

 private:
  void Pass(std::size_t number, const IoVar& input) {
    const Type* type = &program_.types[program_.vars[input.var].type];
    const bool is_array = type->kind == TypeKind::kArray;
    const std::uint32_t count = is_array ? type->count : 1;
    if (is_array) type = &program_.types[type->element];
    const std::string target = Target(number, input, *type, count);
    for (std::uint32_t element = 0; element < count; ++element) {
      const std::string name = "value_" + std::to_string(number) + "_" + std::to_string(element);
      declarations_ += "in " + TypeText(*type) + " " + name + ";\n";
      const std::string index = is_array ? "[" + std::to_string(element) + "]" : "";
      body_ += "    " + target + index + " = " + name + ";\n";
      Inputs::Attribute& attribute = inputs_.attributes.emplace_back();
      attribute.name = name;
      const std::uint32_t size = type->Components();
      for (const auto& vertex : random_.vertices) {
        for (std::uint32_t k = 0; k < size; ++k)
          attribute.words.push_back(static_cast<std::uint32_t>(vertex[number][element * size + k]));
      }
    }
  }

  // Declares the output for the input, and returns its name.
  std::string Target(std::size_t number, const IoVar& input, const Type& type,
                     std::uint32_t count) {
    switch (input.builtin) {
      case Builtin::kPositionInput: return "gl_Position";
      case Builtin::kPointSizeInput: return "gl_PointSize";
      case Builtin::kClipDistanceInput:
        declarations_ += "out float gl_ClipDistance[" + std::to_string(count) + "];\n";
        return "gl_ClipDistance";
      case Builtin::kCullDistanceInput:
        declarations_ += "out float gl_CullDistance[" + std::to_string(count) + "];\n";
        return "gl_CullDistance";
      default: break;
    }
    const auto& info = shader_.info.inputs.at(number);
    if (input.reader && !input.reader->IsWhole())
      throw DrawError("an input that is a part of another, which no test draws with");
    if (info.location)
      declarations_ += "layout(location = " + std::to_string(*info.location) + ") ";
    declarations_ += QualifierOf(input, type.scalar) + "out " + (is_es_ ? "highp " : "") +
                     TypeText(type) + " " + info.name + ";\n";
    return info.name;
  }

  const Shader& shader_;
  const Program& program_;
  const RandomInputs& random_;
  Inputs& inputs_;
  std::string declarations_, body_;
  bool is_es_ = false;
};

// The text with points in place of strips.
std::string WithPoints(std::string text) {
  for (const std::string_view strip : {"triangle_strip", "line_strip"}) {
    if (const std::size_t at = text.find(strip); at != text.npos)
      text.replace(at, strip.size(), "points");
  }
  return text;
}

}  // namespace

std::vector<Captured> Emit(const std::string& geometry, std::span<const std::string> names,
                           const Trial& trial, Inputs inputs) {
  constexpr std::array<GLenum, 5> kModes = {GL_POINTS, GL_LINES, GL_TRIANGLES, GL_LINES_ADJACENCY,
                                            GL_TRIANGLES_ADJACENCY};
  const Emission& emission = trial.shader.lowered.emission;
  const auto size = static_cast<int>(InfoOf(emission.input).vertices);
  inputs.attributes.clear();
  inputs.first_vertex = inputs.base_instance = 0;
  inputs.instances = 1;
  inputs.vertices = static_cast<int>(trial.inputs.vertices.size()) / size * size;
  GeometryRun run;
  run.vertex = PassOn(trial.shader, trial.inputs, inputs).Text(VersionOf(geometry));
  for (Inputs::Attribute& attribute : inputs.attributes)
    attribute.words.resize(attribute.words.size() / trial.inputs.vertices.size() *
                           static_cast<std::size_t>(inputs.vertices));
  run.geometry = WithPoints(geometry);
  run.primitive = kModes[static_cast<std::size_t>(emission.input)];
  run.most_vertices = inputs.vertices / size * static_cast<int>(emission.instances) *
                      static_cast<int>(emission.max_vertices);
  return CaptureGeometry(run, names, inputs);
}

}  // namespace clipc::draw
