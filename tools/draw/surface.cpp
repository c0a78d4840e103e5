// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/surface.h"

#include <algorithm>
#include <regex>

#include "ir/scalar.h"
#include "tools/draw/opengl/program.h"
#include "tools/draw/textures.h"

namespace clipc::draw {
namespace {

using namespace ir;

// The size of a cell. No pixel's centre lies on its diagonal, and the area is a power of two, by
// which drivers divide without an error.
constexpr int kCellWidth = 4, kCellHeight = 2;
constexpr int kColumns = kSurfaceWidth / kCellWidth, kRows = kSurfaceHeight / kCellHeight;

// A value that changes linearly over a cell.
struct Slope {
  float first = 0, along_x = 0,
        along_y = 0;  // of the first pixel's centre, and from one to another
  // At a place in pixels from the corner of the cell.
  float At(float x, float y) const { return first + along_x * (x - 0.5f) + along_y * (y - 0.5f); }
};

struct Corner {
  int x, y;  // in cells, from that corner of the cell
};

class SurfaceMaker {
 public:
  SurfaceMaker(const Program& program, const RandomOptions& options, RandomValues& values)
      : program_(program), options_(options), values_(values) {}

  Surface Make() {
    Surface surface;
    surface.pixels.resize(std::size_t{kSurfaceWidth} * kSurfaceHeight);
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) AddCell(column, row, surface);
    }
    for (std::size_t i = 0; i < surface.pixels.size(); ++i) {
      const PixelPlace place = PlaceOf(i);
      surface.pixels[i] = Pixel(place.x, place.y);
    }
    return surface;
  }

 private:
  // One component of an input: a slope, or the value of the whole cell.
  struct Component {
    Slope slope;
    std::uint64_t value = 0, other = 0;  // of a flat input: its value, and what it must not be
  };
  struct Cell {
    bool is_front = true;
    Slope inverse_w;  // what changes linearly in the image
    Slope depth;
    std::vector<std::vector<Component>> inputs;  // by index into Program::inputs
  };

  const Type& TypeOf(const IoVar& input) const {
    return program_.types[program_.vars[input.var].type];
  }
  bool IsFlat(const IoVar& input) const {
    return !IsFloat(TypeOf(input).scalar) || input.interpolation == Interpolation::kNoInterpolation;
  }

  // A multiple of `unit` that is at most `most` units from 0.
  float Random(int most, float unit) {
    return static_cast<float>(static_cast<int>(values_.Below(2 * most + 1)) - most) * unit;
  }

  Slope RandomSlope() {
    if (options_.quarters) return {Random(8, 0.25f), Random(2, 0.25f), Random(2, 0.25f)};
    // Now and then the values are whole numbers, or equal.
    if (values_.Below(4) == 0) return {Random(1, 1), Random(1, 0.25f), Random(1, 0.25f)};
    constexpr float kUnit = 0x1p-12f;
    return {Random(4096, kUnit), Random(1024, kUnit), Random(1024, kUnit)};
  }

  Cell RandomCell() {
    constexpr float kPowers[] = {0.5f, 1, 2, 4};
    Cell cell;
    cell.is_front = values_.Below(2) == 0;
    const float inverse_w = kPowers[values_.Below(4)];
    // Along the cell w becomes twice as large.
    const float along_x = options_.perspective ? -inverse_w / (2 * kCellWidth) : 0;
    cell.inverse_w = {inverse_w + along_x / 2, along_x, 0};
    cell.depth = {0.5f + Random(128, 0x1p-10f), Random(32, 0x1p-10f), Random(32, 0x1p-10f)};
    for (const IoVar& input : program_.inputs) {
      std::vector<Component>& components = cell.inputs.emplace_back();
      const Scalar kind = BaseOf(TypeOf(input).scalar);
      for (std::uint32_t i = 0; i < TypeOf(input).Components(); ++i) {
        Component& component = components.emplace_back();
        if (IsFlat(input))
          component.value = values_.Next(kind), component.other = values_.Next(kind);
        else
          component.slope = RandomSlope();
      }
    }
    return cell;
  }

  void AddCell(int column, int row, Surface& surface) {
    const Cell& cell = cells_.emplace_back(RandomCell());
    // Clockwise is the front in Direct3D.
    std::array<Corner, 6> corners = {{{0, 0}, {1, 0}, {0, 1}, {1, 0}, {1, 1}, {0, 1}}};
    if (!cell.is_front) std::swap(corners[0], corners[2]), std::swap(corners[3], corners[5]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto [x, y] = corners[i];
      const auto px = static_cast<float>(kCellWidth * x), py = static_cast<float>(kCellHeight * y);
      const float right = 2.0f * static_cast<float>(column + x) / kColumns - 1,
                  up = 1 - 2.0f * static_cast<float>(row + y) / kRows;
      Surface::Vertex& vertex = surface.vertices.emplace_back();
      const float w = 1 / cell.inverse_w.At(px, py);
      vertex.position = {right * w, up * w, cell.depth.At(px, py) * w, w};
      // A flat input has the value of the first vertex in Direct3D, that of the last in OpenGL.
      vertex.values = Values(cell, px, py, i % 3 == 1);
    }
  }

  // With perspective, what changes linearly is the quotient of the value and w.
  static float Interpolated(const IoVar& input, const Cell& cell, const Slope& slope, float x,
                            float y) {
    const double left = cell.inverse_w.At(0, y), here = cell.inverse_w.At(x, y);
    const bool is_linear = input.interpolation == Interpolation::kNoPerspective;
    return static_cast<float>(slope.At(x, y) * (is_linear ? 1 : left / here));
  }

  std::vector<IoBits> Values(const Cell& cell, float x, float y, bool is_between) const {
    std::vector<IoBits> values;
    for (std::size_t i = 0; i < program_.inputs.size(); ++i) {
      IoBits& bits = values.emplace_back();
      for (std::size_t k = 0; k < cell.inputs[i].size() && k < bits.size(); ++k) {
        const Component& component = cell.inputs[i][k];
        if (IsFlat(program_.inputs[i]))
          bits[k] = is_between ? component.other : component.value;
        else
          bits[k] = BitsOf(Interpolated(program_.inputs[i], cell, component.slope, x, y));
      }
    }
    return values;
  }

  std::vector<IoBits> Pixel(int column, int row) const {
    const int number = row / kCellHeight * kColumns + column / kCellWidth;
    const Cell& cell = cells_[static_cast<std::size_t>(number)];
    const float x = static_cast<float>(column % kCellWidth) + 0.5f,
                y = static_cast<float>(row % kCellHeight) + 0.5f;
    std::vector<IoBits> values = Values(cell, x, y, false);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Builtin builtin = program_.inputs[i].builtin;
      if (builtin != Builtin::kNone) values[i] = {};
      if (builtin == Builtin::kPixelPosition) {
        const float position[] = {static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f,
                                  cell.depth.At(x, y), 1 / cell.inverse_w.At(x, y)};
        for (std::size_t k = 0; k < 4; ++k) values[i][k] = BitsOf(position[k]);
      }
      if (builtin == Builtin::kFrontFacing) values[i][0] = cell.is_front ? 1 : 0;
      const auto samples = static_cast<std::uint64_t>(options_.samples);
      if (builtin == Builtin::kCoverageInput) values[i][0] = (std::uint64_t{1} << samples) - 1;
      if (builtin == Builtin::kSampleCount) values[i][0] = samples;
      if (builtin == Builtin::kPrimitiveId) {
        const bool is_second = x / kCellWidth + y / kCellHeight > 1;
        values[i][0] = static_cast<std::uint64_t>(2 * number + (is_second ? 1 : 0));
      }
    }
    return values;
  }

  const Program& program_;
  const RandomOptions& options_;
  RandomValues& values_;
  std::vector<Cell> cells_;
};

}  // namespace

std::string NameOfFeed(std::optional<std::size_t> input) {
  return "feed_" + (input ? std::to_string(*input) : "position");
}

Surface MakeSurface(const Program& program, const RandomOptions& options, RandomValues& values) {
  return SurfaceMaker(program, options, values).Make();
}

PixelPlace PlaceOf(std::size_t index) {
  constexpr int kQuads = kSurfaceWidth / 2;
  const int quad = static_cast<int>(index / kQuadPixels), in_quad = static_cast<int>(index % 4);
  return {2 * (quad % kQuads) + in_quad % 2, 2 * (quad / kQuads) + in_quad / 2};
}

std::string SurfaceVertexShader(const Shader& shader, const std::string& glsl,
                                const SurfaceSpace& space) {
  const Version version = VersionOf(glsl);
  const char* const attribute = version.number < (version.es ? 300 : 130) ? "attribute " : "in ";
  std::string declarations, statements;
  const auto add = [&](const std::string& type, std::optional<std::size_t> input) {
    if (space.is_vulkan)
      declarations += "layout(location = " + std::to_string(input ? *input + 1 : 0) + ") ";
    declarations += attribute + type + " " + NameOfFeed(input) + ";\n";
  };
  add("vec4", std::nullopt);
  for (std::size_t i = 0; i < shader.lowered.inputs.size(); ++i) {
    if (shader.lowered.inputs[i].builtin != Builtin::kNone) continue;
    const std::string& name = shader.info.inputs.at(i).name;
    std::smatch found;
    const std::regex declared("\n((?:.*[^\\w\n])?)(in|varying) ((?:highp )?)(\\w+) " + name + ";");
    if (!std::regex_search(glsl, found, declared)) continue;
    add(found[4].str(), i);
    declarations += found[1].str() + (found[2] == "in" ? "out " : "varying ") + found[3].str() +
                    found[4].str() + " " + name + ";\n";
    statements += "  " + name + " = " + NameOfFeed(i) + ";\n";
  }
  const std::string y = space.flips_y ? "-feed_position.y" : "feed_position.y";
  const std::string z =
      space.is_vulkan ? "feed_position.z" : "2.0 * feed_position.z - feed_position.w";
  return version.Line() + declarations + "void main() {\n" + statements +
         "  gl_Position = vec4(feed_position.x, " + y + ", " + z + ", feed_position.w);\n}\n";
}

void GiveSurface(const Program& program, const Surface& surface, Inputs& inputs) {
  inputs.vertices = static_cast<int>(surface.vertices.size());
  inputs.instances = 1;
  inputs.first_vertex = inputs.base_instance = 0;
  Words positions;
  for (const Surface::Vertex& vertex : surface.vertices) {
    for (const float value : vertex.position) positions.push_back(BitsOf(value));
  }
  inputs.attributes.push_back({NameOfFeed(std::nullopt), std::move(positions)});
  for (std::size_t i = 0; i < program.inputs.size(); ++i) {
    if (program.inputs[i].builtin != Builtin::kNone) continue;
    const Type& type = program.types[program.vars[program.inputs[i].var].type];
    Inputs::Attribute attribute{NameOfFeed(i), {}};
    for (const Surface::Vertex& vertex : surface.vertices) {
      for (std::uint32_t k = 0; k < type.Components(); ++k)
        attribute.words.push_back(static_cast<std::uint32_t>(vertex.values[i][k]));
    }
    inputs.attributes.push_back(std::move(attribute));
  }
}

std::vector<SurfaceTarget> TargetsOf(const Program& program, const GlslInfo& info) {
  std::vector<SurfaceTarget> targets;
  for (std::size_t i = 0; i < program.outputs.size(); ++i) {
    const IoVar& output = program.outputs[i];
    const Type& type = program.types[program.vars[output.var].type];
    SurfaceTarget target{.name = info.outputs.at(i).name};
    switch (output.builtin) {
      case Builtin::kNone:
        target.number = output.location;
        target.kind = KindOfTexels(BaseOf(type.scalar));
        target.components = static_cast<int>(type.Components());
        break;
      case Builtin::kDepth:
      case Builtin::kDepthGreaterEqual:
      case Builtin::kDepthLessEqual: target.is_depth = true, target.components = 1; break;
      default: continue;
    }
    targets.push_back(std::move(target));
  }
  return targets;
}

Captured PixelsOf(const Words& image, const SurfaceTarget& target, bool last_row_first) {
  Captured captured{target.name, {target.kind, 1, target.components}, 1, {}};
  const int components = target.is_depth ? 1 : 4;
  for (std::size_t i = 0; i < std::size_t{kSurfaceWidth} * kSurfaceHeight; ++i) {
    const auto [x, y] = PlaceOf(i);
    const int row = last_row_first ? kSurfaceHeight - 1 - y : y;
    const auto first = image.begin() + std::ptrdiff_t{row * kSurfaceWidth + x} * components;
    captured.words.insert(captured.words.end(), first, first + target.components);
  }
  return captured;
}

}  // namespace clipc::draw
