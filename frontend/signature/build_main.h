// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontend/signature/names.h"
#include "frontend/signature/semantics.h"

// The function `main`, which connects the shader's inputs and outputs with the user's entry
// function.
namespace clipc::signature {

// The semantic, modifiers and attributes that are written at a parameter or at the result beside
// its type. Struct fields carry their own (ir::Field).
struct EntryParameter {
  std::string semantic;  // as written; empty if there is none
  Span semantic_span;
  Interpolation interpolation = Interpolation::kDefault;
  bool centroid = false;
  bool sample = false;
  bool row_major = false;  // whether the matrices in it are row_major
  bool precise = false;
  std::optional<std::uint32_t> location;     // [[vk::location(..)]]
  std::optional<std::uint32_t> blend_index;  // [[vk::index(..)]]
  bool is_uniform = false;
  VarId uniform_var;       // the member of $Params that a `uniform` parameter became; a stream
  ExprId object;           // the object that a technique gives to it instead; none: it gives none
  bool is_stream = false;  // of vertices that the shader emits; is_uniform then
  bool is_of_vertices = false;  // an array of the vertices or control points that the stage reads
  bool is_of_points = false;    // of the control points that the stage writes
  VarId
      objects;  // the variable that has the textures and samplers of the struct; none: it has none
};
// What is written at a function of the shader, the entry or that of a patch's constants.
struct EntrySignature {
  std::vector<EntryParameter> parameters;  // one per parameter of program.entry
  EntryParameter result;
  // Whether matrices between two stages are taken apart by row, as DXC and glslang do.
  bool stages_match_by_row = false;
  // Of program.tessellation.patch_function; none: there is no such function.
  std::shared_ptr<const EntrySignature> patch = {};
  // Whether the file has a hull or geometry shader too, which may write the position.
  bool has_later_stage = false;
};

// Makes program.main, program.inputs and program.outputs for program.entry, and reports the errors
// of the signature: a parameter or field without a semantic, one semantic twice, a system value
// that the stage cannot take or write, or one of a wrong type. A semantic on a parameter
// overrides those inside its struct; its index counts on through the fields.
//
// Inputs and outputs are taken apart: structs by field, arrays by element, matrices by column (by
// row where they are `row_major`), each piece the next index. Under vs_1_1..vs_3_0 the output
// POSITION is the position (and PSIZE the point size, FOG, COLOR plain outputs). SV_ClipDistance
// and SV_CullDistance in any shape become one float array each, packed by register as fxc does. An
// SV_Position input is a plain input.
void BuildMain(Program& program, const EntrySignature& signature, PositionName position,
               Diagnostics& diagnostics);

}  // namespace clipc::signature
