// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/domain.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "tools/draw/feed.h"
#include "tools/draw/opengl/geometry.h"
#include "tools/draw/pass_on.h"

namespace clipc::draw {
namespace {

using namespace ir;

// Far more than the factors of kFactors make of a patch.
constexpr int kMostPoints = 128;
constexpr std::string_view kCoordinate = "clipc_coordinate", kPatch = "clipc_patch";

// Makes the vertex shader and the hull shader that pass the inputs of a domain shader on, and gives
// the vertex shader their values.
class PatchMaker {
 public:
  PatchMaker(const Shader& shader, const RandomInputs& random, Inputs& inputs)
      : shader_(shader), program_(shader.lowered), random_(random), inputs_(inputs) {}

  PatchRun Make(const std::string& domain) {
    const Version version = VersionOf(domain);
    is_es_ = version.es;
    const auto size = static_cast<int>(std::max(1u, program_.tessellation.output_points));
    TakePrimitives(random_, size, inputs_);
    for (std::size_t i = 0; i < program_.inputs.size(); ++i) {
      if (!IsOfTessellator(program_.inputs[i].builtin) && shader_.info.inputs.at(i).is_used)
        Pass(i, program_.inputs[i]);
    }
    const auto set = [&](const char* name, int count, const float* factors) {
      for (int i = 0; i < count; ++i)
        of_patch_ += std::string("    ") + name + "[" + std::to_string(i) +
                     "] = " + std::to_string(factors[i]) + ";\n";
    };
    set("gl_TessLevelOuter", 4, kEdgeFactors);
    set("gl_TessLevelInner", 2, kInsideFactors);
    // Mesa's gl_PerVertex of OpenGL ES is another one in stages without the extension.
    constexpr std::string_view kDistances = "#extension GL_EXT_clip_cull_distance : require\n";
    const std::string first =
        version.Head() + (domain.find(kDistances) == domain.npos ? "" : std::string(kDistances));
    PatchRun run;
    run.vertex = first + vertex_ + "\nvoid main() {\n" + vertex_body_ + "}\n";
    run.control = first + "layout(vertices = " + std::to_string(size) + ") out;\n" + control_ +
                  "\nvoid main() {\n" + control_body_ + of_patch_ + "}\n";
    run.evaluation = WithPoints(domain);
    run.patch_vertices = size;
    run.most_points = inputs_.vertices / size * kMostPoints;
    return run;
  }

  // The text with points in place of triangles and lines.
  static std::string WithPoints(std::string text) {
    const std::size_t end = text.find(") in;", text.find("_spacing"));
    const std::string layout = text.substr(0, end);
    if (layout.rfind("point_mode") == std::string::npos) text.insert(end, ", point_mode");
    return text;
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
    const std::string words = std::string(is_es_ ? "highp " : "") + TypeText(*type) + " ";
    const std::string target = Target(number, input, is_float, words);
    for (std::uint32_t element = 0; element < count; ++element) {
      const std::string suffix = std::to_string(number) + "_" + std::to_string(element);
      const std::string value = "value_" + suffix, passed = "pass_" + suffix;
      const std::string flat = is_float ? "" : "flat ";
      vertex_ += "in " + words + value + ";\n" + flat + "out " + words + passed + ";\n";
      vertex_body_ += "    " + passed + " = " + value + ";\n";
      control_ += flat + "in " + words + passed + "[];\n";
      const std::string index = is_array ? "[" + std::to_string(element) + "]" : "";
      (input.is_of_patch ? of_patch_ : control_body_) +=
          "    " + target + index + " = " + passed +
          (input.is_of_patch ? "[0];\n" : "[gl_InvocationID];\n");
      Give(value, number, element * type->Components(), type->Components());
    }
  }

  void Give(const std::string& name, std::size_t number, std::uint32_t first, std::uint32_t size) {
    Inputs::Attribute& attribute = inputs_.attributes.emplace_back();
    attribute.name = name;
    for (int vertex = 0; vertex < inputs_.vertices; ++vertex) {
      const IoBits& bits = random_.vertices[static_cast<std::size_t>(vertex)][number];
      for (std::uint32_t k = 0; k < size; ++k)
        attribute.words.push_back(static_cast<std::uint32_t>(bits[first + k]));
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
    if (info.location) control_ += "layout(location = " + std::to_string(*info.location) + ") ";
    control_ += input.is_of_patch ? "patch out " : Qualifier(input, is_float) + "out ";
    control_ += words + info.name + (input.is_of_patch ? ";\n" : "[];\n");
    return info.name + (input.is_of_patch ? "" : "[gl_InvocationID]");
  }

  static std::string Qualifier(const IoVar& input, bool is_float) {
    if (!is_float || input.interpolation == Interpolation::kNoInterpolation) return "flat ";
    if (input.interpolation == Interpolation::kNoPerspective) return "noperspective ";
    return input.centroid ? "centroid " : input.sample ? "sample " : "";
  }

  const Shader& shader_;
  const Program& program_;
  const RandomInputs& random_;
  Inputs& inputs_;
  std::string vertex_, vertex_body_, control_, control_body_, of_patch_;
  bool is_es_ = false;
};

// The text with the place of the point and the number of the patch as further outputs.
std::string WithPlace(std::string text, bool is_es) {
  const std::string precision = is_es ? "highp " : "";
  const std::size_t main = text.rfind("void main()");
  text.insert(text.find('{', main) + 1,
              "\n    clipc_coordinate = gl_TessCoord;\n"
              "    clipc_patch = float(gl_PrimitiveID);\n");
  text.insert(main, "out " + precision + "vec3 clipc_coordinate;\nout " + precision +
                        "float clipc_patch;\n");
  return text;
}

}  // namespace

std::vector<DomainPoint> PointsOf(harness::OpenGl& opengl, const Shader& shader,
                                  const RandomInputs& random) {
  const std::string text = ForOpenGl(shader.glsl);
  const Version version = VersionOf(text);
  opengl.Use(version.api);
  Inputs inputs = MakeInputs(shader.lowered, shader.info, random, RandomOptions());
  PatchRun run = PatchMaker(shader, random, inputs).Make(text);
  run.evaluation = WithPlace(run.evaluation, version.es);
  const std::string names[] = {std::string(kCoordinate), std::string(kPatch)};
  const std::vector<Captured> captured = CapturePatches(run, names, inputs);
  std::vector<DomainPoint> points(captured[1].words.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::copy_n(captured[0].words.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                points[i].at.begin());
    points[i].patch = static_cast<std::uint32_t>(std::bit_cast<float>(captured[1].words[i]));
  }
  return points;
}

std::vector<Captured> Evaluate(const std::string& domain, std::span<const std::string> names,
                               const Trial& trial, Inputs inputs) {
  const PatchRun run = PatchMaker(trial.shader, trial.inputs, inputs).Make(domain);
  return CapturePatches(run, names, inputs);
}

}  // namespace clipc::draw
