// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

// How a pass chooses its shaders from arrays: VertexShader = (VS[VI[i]]); PixelShader = (PS[i]);
namespace clipc {

// The values that choose the program of a pass.
struct EffectChoice {
  struct Value {
    std::string text;       // as the effect has it, without blanks: `i`
    std::size_t count = 0;  // it is less than that
  };
  std::vector<Value> values;
  // The program of each combination of values, of which the last varies first. None: it has none.
  std::vector<std::optional<std::size_t>> programs;
};

// Where a pass takes the shader of one stage from.
struct StageIndex {
  std::string text;  // of the value that chooses; empty: the first element is taken
  std::vector<const std::vector<std::int64_t>*> tables;  // the value is looked up in the last first
  std::vector<bool> elements;                            // whether each is a shader, not NULL
};

struct ChosenPrograms {
  EffectChoice choice;  // empty where no value chooses
  // Of each program, the element of each stage.
  std::vector<std::vector<std::size_t>> programs;
  // The first value for which a stage is outside of its arrays.
  struct Outside {
    std::size_t stage = 0;
    std::string text;
    std::size_t value = 0;
  };
  std::optional<Outside> outside;
};

// Finds the programs that some combination of values gives, in the order of the combinations. None
// where there are more than `most` combinations.
std::optional<ChosenPrograms> ChoosePrograms(std::span<const StageIndex> stages, std::size_t most);

// The element that a value gives; none: it is outside of the arrays.
std::optional<std::size_t> ElementOf(const StageIndex& stage, std::size_t value);

}  // namespace clipc
