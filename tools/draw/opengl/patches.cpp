// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/opengl/patches.h"

#include <algorithm>
#include <utility>

#include "ir/access.h"
#include "tools/draw/opengl/geometry.h"

namespace clipc::draw {
namespace {

using namespace ir;

constexpr std::string_view kPoint = "test_point";
constexpr std::pair<std::string_view, std::string_view> kFactors[] = {
    {"gl_TessLevelOuter", "test_outer"}, {"gl_TessLevelInner", "test_inner"}};

void Replace(std::string& text, std::string_view old, std::string_view with) {
  for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + with.size()))
    text.replace(at, old.size(), with);
}

// The declarations of the factors as data. Where outputs have locations, they lie after all others.
std::string FactorsText(const GlslInfo& info, std::string_view direction) {
  const bool is_located = std::ranges::any_of(
      info.outputs, [](const auto& output) { return output.location.has_value(); });
  std::string text;
  for (const auto& [location, name] :
       {std::pair("24", "test_outer[4]"), std::pair("28", "test_inner[2]")}) {
    if (is_located) text += std::string("layout(location = ") + location + ") ";
    text += "patch " + std::string(direction) + " float " + name + ";\n";
  }
  return text;
}

// The hull shader, which gives its factors as data: the tessellator makes a point of each control
// point, the points of a line.
std::string WithFactorsAsData(std::string text, const Shader& shader) {
  const std::uint32_t points = shader.lowered.tessellation.output_points;
  for (const auto& [factors, name] : kFactors) Replace(text, factors, name);
  const std::size_t main = text.find("void main()");
  text.insert(main, FactorsText(shader.info, "out") + "\n");
  const std::string segments = std::to_string(std::max(points, 2u) - 1);
  text.insert(text.rfind('}'),
              "    gl_TessLevelOuter[0] = 1.0;\n    gl_TessLevelOuter[1] = " + segments + ".0;\n");
  return text;
}

// Makes the evaluation shader that takes the outputs to where they are captured.
class TakeOut {
 public:
  TakeOut(const Shader& shader, const Version& version) : shader_(shader), is_es_(version.es) {}

  // Adds an output, under the name that it has there.
  std::string Add(const Expected& output) {
    const Program& program = shader_.lowered;
    std::size_t number = 0;
    while (shader_.info.outputs.at(number).name != output.name) ++number;
    const IoVar& io = program.outputs[number];
    const Type& type = program.types[program.vars[io.var].type];
    const std::string name = "taken_" + std::to_string(number);
    const bool is_array = type.kind == TypeKind::kArray;
    const std::string size = is_array ? "[" + std::to_string(type.count) + "]" : "";
    const std::string type_text = TypeText(is_array ? program.types[type.element] : type);
    const std::string precise = is_es_ ? "highp " : "";
    const bool is_float = BaseOf(is_array ? Scalar::kFloat : type.scalar) == Scalar::kFloat;
    declarations_ +=
        (is_float ? "out " : "flat out ") + precise + type_text + " " + name + size + ";\n";
    const std::string qualifier = io.is_of_patch || is_array ? "" : QualifierOf(io, type.scalar);
    const std::string source = Source(io, number, qualifier, precise + type_text);
    if (!is_array) body_ += "    " + name + " = " + source + ";\n";
    for (std::uint32_t i = 0; is_array && i < type.count; ++i) {
      const std::string index = "[" + std::to_string(i) + "]";
      body_ += "    " + name + index + " = " + source + index + ";\n";
    }
    return name;
  }

  std::string Text(const Version& version) const {
    const auto points = shader_.lowered.tessellation.output_points;
    const std::string segments = std::to_string(std::max(points, 2u) - 1);
    return version.Head() + "layout(isolines, equal_spacing, point_mode) in;\n" + declarations_ +
           FactorsText(shader_.info, "in") + "flat out " + (is_es_ ? "highp " : "") + "int " +
           std::string(kPoint) + ";\n\nvoid main() {\n" + "    int point = int(gl_TessCoord.x * " +
           segments + ".0 + 0.5);\n    " + std::string(kPoint) + " = point;\n" + body_ + "}\n";
  }

 private:
  // Declares the input for the output, and returns its value at the control point.
  std::string Source(const IoVar& io, std::size_t number, const std::string& qualifier,
                     const std::string& type) {
    if (io.builtin == Builtin::kTessFactor) return "test_outer";
    if (io.builtin == Builtin::kInsideFactor) return "test_inner";
    const auto& info = shader_.info.outputs.at(number);
    if (io.builtin != Builtin::kNone) return "gl_in[point]." + info.name;
    if (info.location)
      declarations_ += "layout(location = " + std::to_string(*info.location) + ") ";
    declarations_ += qualifier + (io.is_of_patch ? "patch in " : "in ") + type + " " + info.name +
                     (io.is_of_patch ? "" : "[]") + ";\n";
    return io.is_of_patch ? info.name : info.name + "[point]";
  }

  const Shader& shader_;
  std::string declarations_, body_;
  bool is_es_ = false;
};

// The values of the points in the order of the control points, which `numbers` has by patch. A
// line has two points at least.
void Order(Captured& output, const Captured& numbers, std::size_t points) {
  const std::size_t of_patch = std::max<std::size_t>(points, 2);
  const std::size_t size = static_cast<std::size_t>(output.layout.Words()) * output.count;
  const std::size_t patches = numbers.words.size() / of_patch;
  std::vector<std::uint32_t> words(patches * points * size);
  for (std::size_t i = 0; i < patches * of_patch; ++i) {
    const std::size_t point = numbers.words[i];
    if (point >= points) continue;
    std::copy_n(
        output.words.begin() + static_cast<std::ptrdiff_t>(i * size), size,
        words.begin() + static_cast<std::ptrdiff_t>((i / of_patch * points + point) * size));
  }
  output.words = std::move(words);
}

}  // namespace

std::vector<Captured> MakePatches(const std::string& control,
                                  std::span<const Expected* const> outputs, const Trial& trial,
                                  Inputs inputs) {
  const Tessellation& tessellation = trial.shader.lowered.tessellation;
  const int size = std::max<int>(static_cast<int>(tessellation.input_points), 1);
  const Version version = VersionOf(control);
  TakePrimitives(trial.inputs, size, inputs);
  PatchRun run;
  run.vertex = PassOnText(version, trial.shader, trial.inputs, inputs);
  run.control = WithFactorsAsData(control, trial.shader);
  run.patch_vertices = size;
  run.most_points =
      inputs.vertices / size * static_cast<int>(std::max(tessellation.output_points, 2u));
  TakeOut take_out(trial.shader, version);
  std::vector<std::string> names;
  for (const Expected* output : outputs) names.push_back(take_out.Add(*output));
  names.emplace_back(kPoint);
  run.evaluation = take_out.Text(version);
  std::vector<Captured> captured = CapturePatches(run, names, inputs);
  const Captured numbers = std::move(captured.back());
  captured.pop_back();
  for (Captured& output : captured) Order(output, numbers, tessellation.output_points);
  return captured;
}

}  // namespace clipc::draw
