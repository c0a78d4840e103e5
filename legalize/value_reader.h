// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "legalize/helper_body.h"
#include "legalize/needs.h"

namespace clipc::legalize {

inline constexpr std::uint32_t kWordBytes = 4, kRowBytes = 16;

// Memory that a shader sees as an array of uint, or of rows of four uint or float.
struct WordMemory {
  bool is_rows = false;
  bool is_float = false;  // the rows are of floats
  std::string name = {};  // at the end of names of functions that read it
  // The parameters that each function that reads it has first, and the word or row of that number.
  std::vector<Parameter> parameters = {};
  std::function<ir::ExprId(HelperBody& body, ir::ExprId number)> at = {};
};

// The place of a value in such memory: `offset` bytes behind the sum of each index times its stride
// in words or rows. The indices are int variables of the function.
struct WordPlace {
  struct Step {
    std::uint32_t stride = 1;
    ir::VarId index;
  };
  std::vector<Step> steps;
  std::uint32_t offset = 0;

  WordPlace Plus(std::uint64_t bytes) const {
    WordPlace place = *this;
    place.offset += static_cast<std::uint32_t>(bytes);
    return place;
  }
};

// The number of the word or row that lies `constant` of them behind the place's steps.
ir::ExprId NumberAt(HelperBody& body, const WordPlace& place, std::uint32_t constant);

// Ends the function with the array of element(index) for each index: in a loop, or where arrays
// have fields, in a constructor.
void ReturnArray(HelperBody& body, ir::TypeId array, const Needs& needs,
                 const std::function<ir::ExprId(ir::ExprId index)>& element);

// A reader of values: it puts a value of any type together from the words or rows that it lies in.
// Rows are laid out as cbuffers are (ir/packing.h), words as structured buffers (ir/std_layout.h).
// Functions fill long arrays.
class ValueReader {
 public:
  ValueReader(ir::Program& program, const Needs& needs, WordMemory memory)
      : program_(program), needs_(needs), memory_(std::move(memory)) {}

  // Returns the value in the function `body`; `row_major` says how matrices lie.
  ir::ExprId Read(HelperBody& body, ir::TypeId type, bool row_major, const WordPlace& place);

 private:
  ir::ExprId Words(HelperBody& body, const WordPlace& place, std::uint32_t count);
  ir::ExprId FromWords(HelperBody& body, ir::Scalar kind, ir::ExprId words);
  ir::ExprId Wide(HelperBody& body, ir::Scalar kind, const WordPlace& place);
  ir::ExprId Vector(HelperBody& body, ir::Scalar kind, std::uint32_t count, const WordPlace& place);
  ir::ExprId Matrix(HelperBody& body, ir::TypeId type, bool row_major, const WordPlace& place);
  ir::ExprId Array(HelperBody& body, ir::TypeId type, bool row_major, const WordPlace& place);
  ir::ExprId LongArray(HelperBody& body, ir::TypeId type, bool row_major, const WordPlace& place);
  ir::ExprId Structure(HelperBody& body, ir::TypeId type, const WordPlace& place);
  std::uint32_t StrideOf(ir::TypeId array, bool row_major) const;  // bytes

  ir::Program& program_;
  const Needs& needs_;
  WordMemory memory_;
  // The functions that fill long arrays, by type, order of matrices, and bytes from a word or row.
  std::map<std::tuple<ir::TypeId, bool, std::uint32_t>, ir::FunctionId> fillers_;
};

}  // namespace clipc::legalize
