// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/reference.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <optional>

#include "ir/scalar.h"
#include "tools/draw/dispatch.h"
#include "tools/draw/inputs.h"

namespace clipc::draw {
namespace {

using namespace ir;

template <typename Number>
using Float4 = std::array<Number, 4>;

struct EvaluatorStops : DrawError {
  using DrawError::DrawError;
};

// The outputs of all vertices or pixels, once in float and once in double.
struct Runs {
  std::vector<EvalOutputs> in_float, in_double;
};

// Runs the program for inputs that are evaluated together: those of a vertex, or of a quad.
void Append(const Program& program, std::span<const EvalInputs> together,
            const EvalOptions& options, std::vector<EvalOutputs>& outputs) {
  const auto append = [&](EvalResult result) {
    if (!result) throw EvaluatorStops("the reference evaluator stops: " + result.error);
    outputs.push_back(std::move(result.outputs));
  };
  if (together.size() == 1) return append(RunMain(program, together[0], options));
  std::array<EvalInputs, kQuadPixels> pixels;
  std::ranges::copy(together, pixels.begin());
  for (EvalResult& result : RunQuad(program, pixels, options)) append(std::move(result));
}

// Runs the program for each primitive, and each time that it runs for one, and visits the vertices.
void EmitAll(const Program& program, const EvalInputs& of_all, const RandomInputs& inputs,
             const EvalOptions& options, const std::function<void(EvalVertex&)>& visit) {
  const std::size_t size = InfoOf(program.emission.input).vertices;
  for (std::size_t first = 0; first + size <= inputs.vertices.size(); first += size) {
    for (std::uint32_t instance = 0; instance < program.emission.instances; ++instance) {
      EvalInputs of_one = of_all;
      of_one.vertices.assign(inputs.vertices.begin() + static_cast<std::ptrdiff_t>(first),
                             inputs.vertices.begin() + static_cast<std::ptrdiff_t>(first + size));
      for (const IoVar& input : program.inputs) {
        IoBits& bits = of_one.values.emplace_back();
        if (input.builtin == Builtin::kPrimitiveId) bits[0] = first / size;
        if (input.builtin == Builtin::kEmitterId) bits[0] = instance;
      }
      EvalResult result = RunMain(program, of_one, options);
      if (!result) throw EvaluatorStops("the reference evaluator stops: " + result.error);
      for (EvalVertex& vertex : result.vertices) visit(vertex);
    }
  }
}

// The value of an input that a domain shader does not read at each control point.
IoBits InputAt(const DomainPoint& point, const IoVar& input, const IoBits& of_patch) {
  IoBits bits{};
  switch (input.builtin) {
    case Builtin::kPrimitiveId: bits[0] = point.patch; return bits;
    case Builtin::kDomainLocation: std::ranges::copy(point.at, bits.begin()); return bits;
    case Builtin::kTessFactorInput:
      std::ranges::transform(kEdgeFactors, bits.begin(), [](float each) { return BitsOf(each); });
      return bits;
    case Builtin::kInsideFactorInput:
      std::ranges::transform(kInsideFactors, bits.begin(), [](float each) { return BitsOf(each); });
      return bits;
    default: return of_patch;
  }
}

// Runs the program for each point of a domain.
void EvaluatePoints(const Program& program, const EvalInputs& of_all, const RandomInputs& inputs,
                    const EvalOptions& options, std::vector<EvalOutputs>& outputs) {
  const std::size_t size = std::max(1u, program.tessellation.output_points);
  for (const DomainPoint& point : inputs.points) {
    const auto first = inputs.vertices.begin() + static_cast<std::ptrdiff_t>(point.patch * size);
    EvalInputs of_one = of_all;
    of_one.vertices.assign(first, first + static_cast<std::ptrdiff_t>(size));
    for (std::size_t i = 0; i < program.inputs.size(); ++i)
      of_one.values.push_back(InputAt(point, program.inputs[i], of_one.vertices[0][i]));
    EvalResult result = RunMain(program, of_one, options);
    if (!result) throw EvaluatorStops("the reference evaluator stops: " + result.error);
    outputs.push_back(std::move(result.outputs));
  }
}

// Runs the program for each patch. What a patch has once stands with each of its control points.
void MakeAll(const Program& program, const EvalInputs& of_all, const RandomInputs& inputs,
             const EvalOptions& options, std::vector<EvalOutputs>& outputs) {
  const std::size_t size = std::max(program.tessellation.input_points, 1u);
  for (std::size_t first = 0; first + size <= inputs.vertices.size(); first += size) {
    EvalInputs of_one = of_all;
    of_one.vertices.assign(inputs.vertices.begin() + static_cast<std::ptrdiff_t>(first),
                           inputs.vertices.begin() + static_cast<std::ptrdiff_t>(first + size));
    for (const IoVar& input : program.inputs)
      of_one.values.emplace_back()[0] = input.builtin == Builtin::kPrimitiveId ? first / size : 0;
    PatchResult result = RunPatch(program, of_one, options);
    if (!result) throw EvaluatorStops("the reference evaluator stops: " + result.error);
    for (EvalOutputs& point : result.points) {
      for (std::size_t i = 0; i < program.outputs.size(); ++i) {
        if (!program.outputs[i].is_of_patch) continue;
        point.values[i] = result.points.front().values[i];
        point.numbers[i] = result.points.front().numbers[i];
      }
      outputs.push_back(point);
    }
  }
}

Runs RunAll(const Program& program, const RandomInputs& inputs, double undefined) {
  Runs runs;
  Buffers buffers;
  const auto start = [&] { buffers = inputs.buffers; };
  const auto use = [&](const ObjectRequest& request, std::span<std::uint64_t> result) {
    inputs.UseObject(program, buffers, request, undefined, result);
  };
  if (clipc::InfoOf(program.stage).emits_vertices) {
    for (const bool in_double : {false, true}) {
      auto& outputs = in_double ? runs.in_double : runs.in_float;
      EmitAll(program, {{}, {}, inputs.cbuffers, use, start}, inputs,
              {.in_double = in_double, .undefined = undefined},
              [&](EvalVertex& vertex) { outputs.push_back(std::move(vertex.outputs)); });
    }
    if (runs.in_float.size() != runs.in_double.size())
      throw EvaluatorStops("rounding decides how many vertices the shader emits");
    return runs;
  }
  if (clipc::InfoOf(program.stage).reads_patches) {
    for (const bool in_double : {false, true})
      EvaluatePoints(program, {{}, {}, inputs.cbuffers, use, start}, inputs,
                     {.in_double = in_double, .undefined = undefined},
                     in_double ? runs.in_double : runs.in_float);
    return runs;
  }
  if (clipc::InfoOf(program.stage).makes_patches) {
    for (const bool in_double : {false, true})
      MakeAll(program, {{}, {}, inputs.cbuffers, use, start}, inputs,
              {.in_double = in_double, .undefined = undefined},
              in_double ? runs.in_double : runs.in_float);
    return runs;
  }
  const std::size_t size = clipc::InfoOf(program.stage).has_neighbours ? kQuadPixels : 1;
  for (std::size_t first = 0; first < inputs.vertices.size(); first += size) {
    std::vector<EvalInputs> together;
    for (std::size_t i = first; i < first + size; ++i)
      together.push_back({inputs.vertices[i], {}, inputs.cbuffers, use, start});
    for (const bool in_double : {false, true}) {
      Append(program, together, {.in_double = in_double, .undefined = undefined},
             in_double ? runs.in_double : runs.in_float);
    }
  }
  return runs;
}

void Append(Expected& expected, float value, double number) {
  expected.words.push_back(BitsOf(value));
  expected.numbers.push_back(number);
}

template <typename Number>
Float4<Number> Adjusted(Float4<Number> position, const passes::ClipSpaceOptions& options) {
  if (options.flip_y) position[1] = -position[1];
  if (options.negative_one_to_one) position[2] = 2 * position[2] - position[3];
  return position;
}

template <typename Number>
Number Dot(const Float4<Number>& position, const Float4<float>& plane) {
  Number sum = position[0] * plane[0];
  for (int i = 1; i < 4; ++i) sum = sum + position[i] * plane[i];
  return sum;
}

class Reference {
 public:
  Reference(const Shader& shader, const BuildOptions& options, const RandomInputs& inputs,
            double undefined)
      : shader_(shader),
        options_(options),
        inputs_(inputs),
        undefined_(undefined),
        typed_(RunAll(shader.typed, inputs, undefined)) {}

  std::vector<Expected> Make() {
    const auto& outputs = shader_.lowered.outputs;
    std::vector<Expected> all;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      Expected expected = Empty(i);
      const bool is_drawn = !clipc::InfoOf(shader_.typed.stage).makes_patches;
      if (outputs[i].builtin == Builtin::kPosition && is_drawn) {
        FillPosition(expected, true);
      } else if (const std::optional<std::size_t> own = OwnOutput(outputs[i].var)) {
        Fill(expected, *own, typed_);
      } else if (outputs[i].builtin == Builtin::kClipVertex) {
        FillPosition(expected, false);
      } else {
        FillDistances(expected, i);
      }
      all.push_back(std::move(expected));
    }
    return all;
  }

  bool WroteOutOfBounds(std::size_t vertex) const {
    return typed_.in_float[vertex].wrote_out_of_bounds;
  }

 private:
  // The index of that output among those of the HLSL shader, none for an output that a pass added.
  // Passes may have removed clip distances from the end of the list.
  std::optional<std::size_t> OwnOutput(VarId var) const {
    const auto& list = shader_.typed.outputs;
    const auto found = std::ranges::find(list, var, &IoVar::var);
    return found == list.end() ? std::nullopt : std::optional<std::size_t>(found - list.begin());
  }

  Expected Empty(std::size_t index) const {
    const Program& program = shader_.lowered;
    const Type* type = &program.types[program.vars[program.outputs[index].var].type];
    const bool is_array = type->kind == TypeKind::kArray;
    const auto count = static_cast<int>(is_array ? type->count : type->Components());
    if (is_array) type = &program.types[type->element];
    const Scalar kind = BaseOf(type->scalar);
    if (kind == Scalar::kDouble) throw DrawError("an output of doubles, which no test draws with");
    return {shader_.info.outputs.at(index).name, kind, count, {}, {}, {}};
  }

  void Fill(Expected& expected, std::size_t index, const Runs& runs) const {
    for (std::size_t vertex = 0; vertex < runs.in_float.size(); ++vertex) {
      for (int i = 0; i < expected.components; ++i) {
        if (runs.in_float[vertex].is_discarded) {
          FillCleared(expected, shader_.typed.outputs[index].builtin != Builtin::kNone);
          continue;
        }
        expected.words.push_back(runs.in_float[vertex].values[index][i]);
        expected.numbers.push_back(runs.in_double[vertex].numbers[index][i]);
      }
    }
  }

  // What a render target keeps where a pixel is discarded.
  static void FillCleared(Expected& expected, bool is_depth) {
    const float color = is_depth ? kClearDepth : kClearColor;
    const bool is_float = expected.kind == Scalar::kFloat;
    expected.words.push_back(is_float ? BitsOf(color) : kClearInteger);
    expected.numbers.push_back(is_float ? color : kClearInteger);
  }

  template <typename Number>
  Float4<Number> PositionOf(const EvalOutputs& outputs) const {
    const auto& list = shader_.typed.outputs;
    const auto found = std::ranges::find(list, Builtin::kPosition, &IoVar::builtin);
    if (found == list.end()) throw DrawError("planes without a position");
    Float4<Number> position;
    for (int i = 0; i < 4; ++i)
      position[i] = static_cast<Number>(outputs.numbers[found - list.begin()][i]);
    return position;
  }

  // The vector that the planes are dotted with, by the definition of the plane space.
  template <typename Number>
  Float4<Number> VertexOf(std::size_t vertex, const EvalOutputs& outputs) const {
    if (options_.plane_space != PlaneSpace::kObject) {
      const Float4<Number> p = PositionOf<Number>(outputs);
      return options_.plane_space == PlaneSpace::kClip ? p : Float4<Number>{p[0], p[1], p[3], 1};
    }
    const auto& list = shader_.typed.inputs;
    const auto found = std::ranges::find_if(list, [&](const IoVar& io) {
      return io.semantic + std::to_string(io.index) == options_.position_input;
    });
    if (found == list.end()) throw DrawError("no input " + options_.position_input);
    const Type& type = shader_.typed.types[shader_.typed.vars[found->var].type];
    Float4<Number> raw{0, 0, 0, 1};
    for (std::uint32_t i = 0; i < type.Components(); ++i) {
      float value;
      const auto bits =
          static_cast<std::uint32_t>(inputs_.vertices[vertex][found - list.begin()][i]);
      std::memcpy(&value, &bits, sizeof value);
      raw[i] = value;
    }
    return raw;
  }

  void FillPosition(Expected& expected, bool adjusted) const {
    const passes::ClipSpaceOptions clip_space =
        adjusted ? options_.clip_space : passes::ClipSpaceOptions{};
    for (std::size_t vertex = 0; vertex < typed_.in_float.size(); ++vertex) {
      const auto in_float = Adjusted(PositionOf<float>(typed_.in_float[vertex]), clip_space);
      const auto in_double = Adjusted(PositionOf<double>(typed_.in_double[vertex]), clip_space);
      for (int i = 0; i < 4; ++i) Append(expected, in_float[i], in_double[i]);
    }
  }

  // Planes composed of several constants are read by the evaluator; all others from the bytes that
  // the application uploads.
  void FillDistances(Expected& expected, std::size_t index) const {
    const auto& planes = shader_.typed.clip_planes;
    if (!std::ranges::all_of(planes, &ClipPlane::whole_register)) {
      return Fill(expected, index, RunAll(shader_.lowered, inputs_, undefined_));
    }
    for (std::size_t vertex = 0; vertex < typed_.in_float.size(); ++vertex) {
      for (const ClipPlane& plane : planes) {
        const Float4<float> value = PlaneOf(plane);
        Append(expected, Dot(VertexOf<float>(vertex, typed_.in_float[vertex]), value),
               Dot(VertexOf<double>(vertex, typed_.in_double[vertex]), value));
      }
    }
  }

  Float4<float> PlaneOf(const ClipPlane& plane) const {
    const std::uint32_t at =
        plane.element * shader_.typed.cbuffers[plane.cbuffer].size + plane.offset;
    Float4<float> value;
    std::memcpy(value.data(), inputs_.cbuffers[plane.cbuffer.index].data() + at, sizeof value);
    return value;
  }

  const Shader& shader_;
  const BuildOptions& options_;
  const RandomInputs& inputs_;
  const double undefined_;
  Runs typed_;
};

// Marks values as open that differ in another run, and all values when that run does not end.
template <typename Run>
void MarkOpen(std::vector<Expected>& all, Run&& run) {
  std::vector<Expected> others;
  try {
    others = run();
  } catch (const EvaluatorStops&) {
    for (Expected& value : all) value.open.assign(value.open.size(), true);
    return;
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    // What is undefined may decide how many vertices there are.
    const bool is_other = all[i].words.size() != others[i].words.size();
    for (std::size_t k = 0; k < all[i].words.size(); ++k) {
      if (is_other || all[i].words[k] != others[i].words[k]) all[i].open[k] = true;
    }
  }
}

// Whether reads of textures and buffers may be open.
bool ReadsBorders(const RandomInputs& inputs) {
  return !inputs.buffers.empty() || std::ranges::any_of(inputs.textures, [](const auto& textures) {
    return !std::ranges::all_of(textures.second, &Texture::is_constant);
  });
}

}  // namespace

std::vector<Expected> MakeExpected(const Shader& shader, const BuildOptions& options,
                                   const RandomInputs& inputs) {
  if (clipc::InfoOf(shader.typed.stage).runs_in_groups) return ExpectedOfDispatch(shader, inputs);
  Reference zero(shader, options, inputs, 0);
  std::vector<Expected> all = zero.Make();
  for (Expected& output : all) {
    for (std::size_t k = 0; k < output.words.size(); ++k) {
      output.open.push_back(zero.WroteOutOfBounds(k / output.components));
    }
  }
  if (clipc::InfoOf(shader.typed.stage).draws_pixels) {
    // Nothing reads coverage and the like back.
    const std::vector<SurfaceTarget> targets = TargetsOf(shader.lowered, shader.info);
    for (Expected& output : all) {
      if (std::ranges::find(targets, output.name, &SurfaceTarget::name) == targets.end())
        output.open.assign(output.open.size(), true);
    }
  }
  const auto try_value = [&](double undefined) {
    MarkOpen(all, [&] { return Reference(shader, options, inputs, undefined).Make(); });
  };
  // One other value may happen to give the same: max(0, x) does for any x below 0.
  for (const double undefined : {1.0, 3.0, -2.5}) try_value(undefined);
  const auto has_open = [](const Expected& output) {
    return std::ranges::find(output.open, true) != output.open.end();
  };
  // Of many vertices where the shader reads undefined values, one may give the same for all three.
  // Reads outside of a texture or at the border between two texels are common, and shaders branch
  // on them.
  if (!ReadsBorders(inputs) && std::ranges::none_of(all, has_open)) return all;
  for (const double undefined :
       {0.125, 2.0, 0.25, 5.0, 0.375, -7.5, 0.5, 9.0, 0.625, -4.0, 0.75, 14.0})
    try_value(undefined);
  return all;
}

std::optional<std::size_t> CountPrimitives(const Shader& shader, const RandomInputs& inputs) {
  const Program& program = shader.typed;
  const std::size_t least = InfoOf(program.emission.output).vertices;
  std::size_t count = 0, length = 0;
  Buffers buffers;
  const auto use = [&](const ObjectRequest& request, std::span<std::uint64_t> result) {
    inputs.UseObject(program, buffers, request, 0, result);
  };
  const auto start = [&] { buffers = inputs.buffers; };
  bool has_short = false;
  EmitAll(program, {{}, {}, inputs.cbuffers, use, start}, inputs, {}, [&](EvalVertex& vertex) {
    if (vertex.stream != 0) return;
    if (vertex.starts_strip) has_short = has_short || (length > 0 && length < least);
    length = vertex.starts_strip ? 1 : length + 1;
    if (length >= least) ++count;
  });
  if (has_short || length < least) return std::nullopt;
  return count;
}

}  // namespace clipc::draw
