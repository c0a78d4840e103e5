// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "frontend/signature/names.h"
#include "frontend/signature/semantics.h"
#include "ir/builder.h"

namespace clipc::signature {

// The inputs of Direct3D 9, whose vertex declaration and whose linkage of stages have one register
// for each semantic: inputs of one semantic read the first components of one input.
class AttributeReads {
 public:
  // Keeps references to the program and the builder.
  AttributeReads(Program& program, Builder& builder) : program_(program), builder_(builder) {}

  // The input of the program that has the semantic; none if there is none yet.
  VarId InputOf(const SemanticName& semantic) const;
  // The first `count` components of the input, which gets as many if it has fewer.
  ExprId Read(VarId input, std::uint32_t count);
  // Makes what Read gave fit the inputs, of which no more is read.
  void Finish();

 private:
  Program& program_;
  Builder& builder_;
  std::vector<ExprId> reads_;
};

// Whether the output is a colour or the fog of vs_1_1 or vs_2_x, whose registers hold 0..1: "Output
// Registers" and "Input Color Register" of the Direct3D 9 reference, not of vs_3_0.
bool IsClampedOutput(const Program& program, std::string_view semantic, const Type& type);

}  // namespace clipc::signature
