// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <string>
#include <vector>

#include "tools/random/program.h"
#include "tools/random/statement.h"

// The declarations of a generated shader beside its functions.
namespace clipc::random {

// A struct, which variables may have as their type from then on.
std::string MakeStruct(Context& context);

// Constant buffers and the variables of $Globals, which go to `buffers` too.
std::string MakeConstants(Context& context, bool row_major, std::vector<ConstantBuffer>& buffers);

// An attribute of at most `most` planes, "[clipplanes(a, b.c[1])]\n", or nothing. If `composes`,
// operands may be made of several constants.
std::string MakePlanes(Context& context, const std::vector<ConstantBuffer>& buffers, bool composes,
                       int most);

// The textures and samplers that MakeNeighbourStatements reads.
inline constexpr char kNeighbourObjects[] = "Texture2D map0, map1;\nSamplerState linearly;\n";
// At most `most` statements of a pixel shader's entry that all pixels of a quad run: derivatives
// and samples, whose values are variables from then on, and discards between them.
std::string MakeNeighbourStatements(Context& context, int most);

// The parameters of the entry function, the structs that they need, and the statements that its
// body begins with. The variables are added to the context. If `keeps`, the position is not
// written.
struct EntryInputs {
  std::string structs, parameters, statements;
};
EntryInputs MakeInputs(Context& context, bool keeps);

// A struct for what another stage gives: a position, which has the semantic that a rasteriser
// reads, if `has_position`, and up to four values of any kind. Returns its number, and adds its
// declaration to `text`.
int MakeGivenStruct(Context& context, std::string& text, bool has_position);
// Statements that copy up to three elements of the array `from`, whose type is the struct, to
// variables. An index is a text of OneOf(indices).
std::string MakeCopies(Context& context, int structure, const std::string& from,
                       const std::vector<std::string>& indices);

// Outputs for the values of the visible variables, as statements that write them and as fields, of
// which there is at least one.
struct EntryOutputs {
  std::string fields, statements;
  std::vector<Field> made = {};  // beside the lines of `fields`
};
EntryOutputs MakeOutputs(Context& context, bool soft);

}  // namespace clipc::random
