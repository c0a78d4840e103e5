// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/pass_patch.h"

#include <algorithm>
#include <utility>

namespace clipc::draw {
namespace {

using namespace ir;

constexpr std::string_view kPoint = "test_point";

// Makes the vertex shader and the hull shader that pass the inputs of a domain shader on.
class PatchMaker {
 public:
  PatchMaker(const Shader& shader, const RandomInputs& random, PassOnFor api)
      : shader_(shader), program_(shader.lowered), random_(random), api_(api) {}

  PassedOn Make() && {
    const int size = VerticesOfOne(program_);
    made_.vertices = static_cast<int>(random_.vertices.size()) / size * size;
    for (std::size_t i = 0; i < program_.inputs.size(); ++i) {
      if (!IsOfTessellator(program_.inputs[i].builtin) && shader_.info.inputs.at(i).is_used)
        Pass(i, program_.inputs[i]);
    }
    of_patch_ += FactorValuesText();
    made_.vertex = vertex_ + "\nvoid main() {\n" + vertex_body_ + "}\n";
    made_.hull = "layout(vertices = " + std::to_string(size) + ") out;\n" + control_ +
                 "\nvoid main() {\n" + control_body_ + of_patch_ + "}\n";
    return std::move(made_);
  }

 private:
  static bool IsOfTessellator(Builtin builtin) {
    return builtin == Builtin::kPrimitiveId || builtin == Builtin::kDomainLocation ||
           builtin == Builtin::kTessFactorInput || builtin == Builtin::kInsideFactorInput ||
           builtin == Builtin::kUntranslated;
  }

  void Pass(std::size_t number, const IoVar& input) {
    const Type* type = &program_.types[program_.vars[input.var].type];
    const bool is_array = type->kind == TypeKind::kArray;
    const std::uint32_t count = is_array ? type->count : 1;
    if (is_array) type = &program_.types[type->element];
    const bool is_float = BaseOf(type->scalar) == Scalar::kFloat;
    const std::string words = std::string(PrecisionText(api_)) + TypeText(*type) + " ";
    const std::string target = Target(number, input, is_float, words);
    for (std::uint32_t element = 0; element < count; ++element) {
      const std::string suffix = std::to_string(number) + "_" + std::to_string(element);
      const std::string value = "value_" + suffix, passed = "pass_" + suffix;
      const std::string flat = is_float ? "" : "flat ";
      const std::string location =
          api_ == PassOnFor::kVulkan ? LocationText(made_.attributes.size()) : "";
      vertex_ += location + "in " + words + value + ";\n";
      vertex_ += location + flat + "out " + words + passed + ";\n";
      vertex_body_ += "    " + passed + " = " + value + ";\n";
      control_ += location + flat + "in " + words + passed + "[];\n";
      const std::string index = is_array ? "[" + std::to_string(element) + "]" : "";
      (input.is_of_patch ? of_patch_ : control_body_) +=
          "    " + target + index + " = " + passed +
          (input.is_of_patch ? "[0];\n" : "[gl_InvocationID];\n");
      made_.attributes.push_back({value, KindOf(type->scalar), {}});
      Give(number, element * type->Components(), type->Components());
    }
  }

  void Give(std::size_t number, std::uint32_t first, std::uint32_t size) {
    for (int vertex = 0; vertex < made_.vertices; ++vertex) {
      const IoBits& bits = random_.vertices[static_cast<std::size_t>(vertex)][number];
      for (std::uint32_t k = 0; k < size; ++k)
        made_.attributes.back().words.push_back(static_cast<std::uint32_t>(bits[first + k]));
    }
  }

  // Declares the output for the input, and returns what is assigned.
  std::string Target(std::size_t number, const IoVar& input, bool is_float,
                     const std::string& words) {
    switch (input.builtin) {
      case Builtin::kPositionInput: return "gl_out[gl_InvocationID].gl_Position";
      case Builtin::kPointSizeInput: return "gl_out[gl_InvocationID].gl_PointSize";
      case Builtin::kClipDistanceInput: return "gl_out[gl_InvocationID].gl_ClipDistance";
      case Builtin::kCullDistanceInput: return "gl_out[gl_InvocationID].gl_CullDistance";
      default: break;
    }
    const auto& info = shader_.info.inputs.at(number);
    if (input.reader && !input.reader->IsWhole())
      throw DrawError("an input that is a part of another, which no test draws with");
    if (info.location) control_ += LocationText(*info.location);
    control_ += input.is_of_patch ? "patch out " : Qualifier(input, is_float) + "out ";
    control_ += words + info.name + (input.is_of_patch ? ";\n" : "[];\n");
    return info.name + (input.is_of_patch ? "" : "[gl_InvocationID]");
  }

  static std::string Qualifier(const IoVar& input, bool is_float) {
    return QualifierOf(input, is_float ? Scalar::kFloat : Scalar::kInt);
  }

  const Shader& shader_;
  const Program& program_;
  const RandomInputs& random_;
  const PassOnFor api_;
  PassedOn made_;
  std::string vertex_, vertex_body_, control_, control_body_, of_patch_;
};

// Makes the domain shader that takes the outputs of a hull shader to where they are captured.
class OutTaker {
 public:
  OutTaker(const Shader& shader, PassOnFor api) : shader_(shader), api_(api) {}

  // Adds an output, under the name that it has there.
  std::string Add(const std::string& output) {
    const Program& program = shader_.lowered;
    std::size_t number = 0;
    while (shader_.info.outputs.at(number).name != output) ++number;
    const IoVar& io = program.outputs[number];
    const Type& type = program.types[program.vars[io.var].type];
    const std::string name = "taken_" + std::to_string(number);
    const bool is_array = type.kind == TypeKind::kArray;
    const std::string size = is_array ? "[" + std::to_string(type.count) + "]" : "";
    const std::string type_text = TypeText(is_array ? program.types[type.element] : type);
    const std::string words = std::string(PrecisionText(api_)) + type_text;
    const bool is_float = BaseOf(is_array ? Scalar::kFloat : type.scalar) == Scalar::kFloat;
    Declare((is_float ? "out " : "flat out ") + words + " " + name + size,
            is_array ? type.count : 1);
    const std::string qualifier = io.is_of_patch || is_array ? "" : QualifierOf(io, type.scalar);
    const std::string source = Source(io, number, qualifier, words);
    if (!is_array) body_ += "    " + name + " = " + source + ";\n";
    for (std::uint32_t i = 0; is_array && i < type.count; ++i) {
      const std::string index = "[" + std::to_string(i) + "]";
      body_ += "    " + name + index + " = " + source + index + ";\n";
    }
    return name;
  }

  std::string Text() {
    const std::string point(kPoint);
    Declare("flat out " + std::string(PrecisionText(api_)) + "int " + point, 1);
    return "layout(isolines, equal_spacing, point_mode) in;\n" + declarations_ +
           FactorsText(shader_, "in", api_) + "\nvoid main() {\n" +
           "    int point = int(gl_TessCoord.x * " + std::to_string(SegmentsOf(shader_.lowered)) +
           ".0 + 0.5);\n    " + point + " = point;\n" + body_ + "}\n";
  }

 private:
  // Declares an output, which takes so many locations.
  void Declare(const std::string& output, std::uint32_t count) {
    if (api_ == PassOnFor::kVulkan)
      declarations_ += LocationText(std::exchange(next_, next_ + count));
    declarations_ += output + ";\n";
  }

  // Declares the input for the output, and returns its value at the control point.
  std::string Source(const IoVar& io, std::size_t number, const std::string& qualifier,
                     const std::string& type) {
    if (io.builtin == Builtin::kTessFactor) return std::string(kFactors[0].name);
    if (io.builtin == Builtin::kInsideFactor) return std::string(kFactors[1].name);
    const auto& info = shader_.info.outputs.at(number);
    if (io.builtin != Builtin::kNone) return "gl_in[point]." + info.name;
    if (info.location) declarations_ += LocationText(*info.location);
    declarations_ += qualifier + (io.is_of_patch ? "patch in " : "in ") + type + " " + info.name +
                     (io.is_of_patch ? "" : "[]") + ";\n";
    return io.is_of_patch ? info.name : info.name + "[point]";
  }

  const Shader& shader_;
  const PassOnFor api_;
  std::string declarations_, body_;
  std::uint32_t next_ = 0;
};

}  // namespace

std::string FactorValuesText() {
  std::string text;
  for (const FactorsAsData& factors : kFactors) {
    for (std::uint32_t i = 0; i < factors.count; ++i) {
      const float value = (&factors == kFactors ? kEdgeFactors : kInsideFactors)[i];
      text += "    " + std::string(factors.builtin) + "[" + std::to_string(i) +
              "] = " + std::to_string(value) + ";\n";
    }
  }
  return text;
}

PassedOn PassPatch(const Shader& shader, const RandomInputs& random, PassOnFor api) {
  return PatchMaker(shader, random, api).Make();
}

std::uint32_t SegmentsOf(const Program& hull) {
  return std::max(hull.tessellation.output_points, 2u) - 1;
}

std::string FactorsText(const Shader& hull, std::string_view direction, PassOnFor api) {
  const bool is_located =
      api == PassOnFor::kVulkan || std::ranges::any_of(hull.info.outputs, [](const auto& output) {
        return output.location.has_value();
      });
  std::string text;
  for (const FactorsAsData& data : kFactors) {
    if (is_located) text += LocationText(data.location);
    text += "patch " + std::string(direction) + " float " + std::string(data.name) + "[" +
            std::to_string(data.count) + "];\n";
  }
  return text;
}

TakenOut TakeOut(const Shader& hull, const std::vector<std::string>& outputs, PassOnFor api) {
  OutTaker taker(hull, api);
  TakenOut taken;
  for (const std::string& output : outputs) taken.names.push_back(taker.Add(output));
  taken.names.emplace_back(kPoint);
  taken.text = taker.Text();
  return taken;
}

std::vector<Captured> InOrder(const Program& hull, std::vector<Captured> captured) {
  const Captured numbers = std::move(captured.back());
  captured.pop_back();
  const std::size_t points = hull.tessellation.output_points;
  const std::size_t of_patch = std::max<std::size_t>(points, 2);  // a line has two points at least
  const std::size_t patches = numbers.words.size() / of_patch;
  for (Captured& output : captured) {
    const std::size_t size = static_cast<std::size_t>(output.layout.Words()) * output.count;
    Words words(patches * points * size);
    for (std::size_t i = 0; i < patches * of_patch; ++i) {
      const std::size_t point = numbers.words[i];
      if (point >= points) continue;
      std::copy_n(
          output.words.begin() + static_cast<std::ptrdiff_t>(i * size), size,
          words.begin() + static_cast<std::ptrdiff_t>((i / of_patch * points + point) * size));
    }
    output.words = std::move(words);
  }
  return captured;
}

}  // namespace clipc::draw
