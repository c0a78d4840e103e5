// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/position_trial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "ir/evaluate.h"
#include "ir/scalar.h"

namespace clipc::signature {
namespace {

using Position = std::array<double, 4>;

class Trial {
 public:
  Trial(const Program& program, VarId input) : program_(program) {
    vertex_ = IndexOf(program.inputs, &IoVar::var, input);
    position_ = IndexOf(program.outputs, &IoVar::builtin, Builtin::kPosition);
    inputs_.read_object = [](const ObjectRequest& request, std::span<std::uint64_t> result) {
      // The result is a hash of the place, since a texture is seldom the same everywhere.
      std::uint64_t hash = 14695981039346656037u;
      for (const std::uint64_t word : request.words) hash = (hash ^ word) * 1099511628211u;
      for (std::uint64_t& word : result) {
        hash = hash * 6364136223846793005u + 1442695040888963407u;
        word = BitsOf(static_cast<float>(hash >> 40) * 0x1p-24f);
      }
    };
    for (const CbufferId id : program.cbuffers.ids()) {
      const Cbuffer& cbuffer = program.cbuffers[id];
      std::vector<std::uint8_t>& bytes =
          inputs_.cbuffers.emplace_back(std::size_t{cbuffer.size} * cbuffer.count);
      for (std::size_t at = 0; at + 4 <= bytes.size(); at += 4) {
        const auto word = static_cast<std::uint32_t>(BitsOf(Next()));
        std::memcpy(&bytes[at], &word, 4);
      }
    }
  }

  std::string Run() {
    for (int round = 0; round < 4; ++round) {
      for (const IoVar& input : program_.inputs) inputs_.values.push_back(Value(input));
      if (std::string why = OtherInputs(); !why.empty()) return why;
      if (Bends()) return "the middle of two vertices is not drawn in the middle";
      inputs_.values.clear();
    }
    return {};
  }

 private:
  template <typename Member, typename T>
  static std::size_t IndexOf(const IoVars& list, Member member, T value) {
    const auto found = std::ranges::find(list, value, member);
    return found == list.end() ? 0 : static_cast<std::size_t>(found - list.begin());
  }

  // Returns a pseudo-random multiple of 1/256 in [-2, 2): the middle of two of them is a float too.
  float Next() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<float>(state_ >> 54) / 256 - 2;
  }

  IoBits Value(const IoVar& input) {
    const Type& type = program_.types[program_.vars[input.var].type];
    IoBits bits{};
    for (std::uint32_t i = 0; i < type.Components(); ++i) {
      const float value = Next();
      bits[i] = BaseOf(type.scalar) == Scalar::kFloat
                    ? BitsOf(value)
                    : static_cast<std::uint64_t>(std::fabs(value) * 2);
    }
    if (type.Components() == 4 && program_.inputs[vertex_].var == input.var) bits[3] = BitsOf(1.0f);
    return bits;
  }

  // The position for the inputs in inputs_; nullopt if the shader does not run to its end, or a
  // component is not a finite number.
  std::optional<Position> PositionNow() const {
    const EvalResult result = RunMain(program_, inputs_, {.step_limit = 20'000, .in_double = true});
    if (!result) return std::nullopt;
    Position position;
    for (int i = 0; i < 4; ++i) {
      position[i] = result.outputs.numbers[position_][i];
      if (!std::isfinite(position[i])) return std::nullopt;
    }
    return position;
  }

  static bool Differ(const Position& a, const Position& b) {
    double size = 0, difference = 0;
    for (int i = 0; i < 4; ++i) {
      size = std::max({size, std::fabs(a[i]), std::fabs(b[i])});
      difference = std::max(difference, std::fabs(a[i] - b[i]));
    }
    return difference > 1e-6 * size;
  }

  std::string OtherInputs() {
    const std::optional<Position> before = PositionNow();
    if (!before) return {};
    for (std::size_t i = 0; i < program_.inputs.size(); ++i) {
      if (i == vertex_) continue;
      const IoBits kept = inputs_.values[i];
      for (int tries = 0; tries < 3; ++tries) {
        inputs_.values[i] = Value(program_.inputs[i]);
        const std::optional<Position> after = PositionNow();
        if (!after || !Differ(*before, *after)) continue;
        const IoVar& input = program_.inputs[i];
        const bool is_system = input.builtin != Builtin::kNone;
        return fmt::format("it depends on `{}{}` too", input.semantic,
                           is_system ? "" : std::to_string(input.index));
      }
      inputs_.values[i] = kept;
    }
    return {};
  }

  bool Bends() {
    const IoBits first = Value(program_.inputs[vertex_]), second = Value(program_.inputs[vertex_]);
    IoBits middle = first;
    for (int i = 0; i < 4; ++i) {
      middle[i] = BitsOf((FloatOf(first[i]) + FloatOf(second[i])) / 2);
    }
    std::array<Position, 3> positions;
    const IoBits* const vertices[] = {&first, &second, &middle};
    for (int i = 0; i < 3; ++i) {
      inputs_.values[vertex_] = *vertices[i];
      const std::optional<Position> position = PositionNow();
      if (!position) return false;
      positions[i] = *position;
    }
    Position straight;
    for (int i = 0; i < 4; ++i) straight[i] = (positions[0][i] + positions[1][i]) / 2;
    return Differ(straight, positions[2]);
  }

  const Program& program_;
  std::size_t vertex_ = 0, position_ = 0;
  EvalInputs inputs_;
  std::uint64_t state_ = 1;
};

}  // namespace

std::string WhyNotTimesMatrices(const Program& program, VarId input) {
  return Trial(program, input).Run();
}

}  // namespace clipc::signature
