// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/pass_on.h"

#include <algorithm>
#include <span>
#include <utility>

#include "ir/access.h"
#include "tools/draw/pass_patch.h"

namespace clipc::draw {
namespace {

using namespace ir;

// Whether the draw call gives the input, and no vertex has it.
bool IsOfPrimitive(Builtin builtin) {
  return builtin == Builtin::kPrimitiveId || builtin == Builtin::kEmitterId ||
         builtin == Builtin::kControlPointId || builtin == Builtin::kUntranslated;
}

// Makes the vertex shader that passes the inputs on, and gives it their values.
class PassOnWriter {
 public:
  PassOnWriter(const Shader& shader, const RandomInputs& random, PassOnFor api)
      : shader_(shader), program_(shader.lowered), random_(random), api_(api) {
    const int size = VerticesOfOne(program_);
    made_.vertices = static_cast<int>(random.vertices.size()) / size * size;
  }

  PassedOn Write() && {
    for (std::size_t i = 0; i < program_.inputs.size(); ++i) {
      const IoVar& input = program_.inputs[i];
      if (IsOfPrimitive(input.builtin) || !shader_.info.inputs.at(i).is_used) continue;
      Pass(i, input);
    }
    made_.vertex = declarations_ + "\nvoid main() {\n" + body_ + "}\n";
    return std::move(made_);
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
      if (api_ == PassOnFor::kVulkan) declarations_ += LocationText(made_.attributes.size());
      declarations_ += "in " + TypeText(*type) + " " + name + ";\n";
      const std::string index = is_array ? "[" + std::to_string(element) + "]" : "";
      body_ += "    " + target + index + " = " + name + ";\n";
      PassedOn::Attribute& attribute = made_.attributes.emplace_back();
      attribute.name = name;
      attribute.kind = KindOf(type->scalar);
      const std::uint32_t size = type->Components();
      for (const auto& vertex : std::span(random_.vertices).first(made_.vertices)) {
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
    if (info.location) declarations_ += LocationText(*info.location);
    declarations_ += QualifierOf(input, type.scalar) + "out ";
    declarations_ += PrecisionText(api_);
    declarations_ += TypeText(type) + " " + info.name + ";\n";
    return info.name;
  }

  const Shader& shader_;
  const Program& program_;
  const RandomInputs& random_;
  const PassOnFor api_;
  PassedOn made_;
  std::string declarations_, body_;
};

}  // namespace

WordKind KindOf(Scalar scalar) {
  const Scalar kind = BaseOf(scalar);
  return kind == Scalar::kFloat ? WordKind::kFloat
         : kind == Scalar::kInt ? WordKind::kInt
                                : WordKind::kUint;
}

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

std::string LocationText(std::size_t location) {
  return "layout(location = " + std::to_string(location) + ") ";
}

std::string_view PrecisionText(PassOnFor api) {
  return api == PassOnFor::kOpenGlEs ? "highp " : "";
}

int VerticesOfOne(const Program& program) {
  return static_cast<int>(std::max(1u, VerticesRead(program)));
}

PassedOn PassOn(const Shader& shader, const RandomInputs& random, PassOnFor api) {
  return clipc::InfoOf(shader.lowered.stage).reads_patches
             ? PassPatch(shader, random, api)
             : PassOnWriter(shader, random, api).Write();
}

int MostEmitted(const Emission& emission, int vertices) {
  const auto size = static_cast<int>(InfoOf(emission.input).vertices);
  return vertices / size * static_cast<int>(emission.instances) *
         static_cast<int>(emission.max_vertices);
}

}  // namespace clipc::draw
