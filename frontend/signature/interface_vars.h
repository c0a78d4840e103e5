// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "frontend/signature/distances.h"
#include "frontend/signature/locations.h"
#include "frontend/signature/names.h"
#include "frontend/signature/signature_leaves.h"
#include "ir/builder.h"

namespace clipc::signature {

// The variables of the shader's inputs and outputs.
class InterfaceVars {
 public:
  // Keeps references to the program and the diagnostics.
  InterfaceVars(Program& program, Diagnostics& diagnostics);

  VarId AddInput(const Carrier& leaf, TypeId type, Builtin builtin) {
    return Add(program_.inputs, leaf, type, builtin);
  }
  VarId AddOutput(const Carrier& leaf, TypeId type, Builtin builtin) {
    return Add(program_.outputs, leaf, type, builtin);
  }
  // Sets whether what is added from here on is of the whole patch.
  void SetOfPatch(bool is_of_patch) { is_of_patch_ = is_of_patch; }
  // Adds the array of clip or cull distances. Its elements are `packed`, what Packed made of the
  // pieces, of which there is one.
  VarId AddDistances(Builtin builtin, const Distances& pieces, std::span<const ExprId> packed);
  // Reports inputs, and outputs, with more distances than GLSL's arrays have.
  void CheckDistances();
  // Moves the locations of what is of the whole patch after those of the control points, in both
  // stages alike, whatever the order of the parameters is.
  void PlaceConstants();

 private:
  VarId Add(IoVars& list, const Carrier& leaf, TypeId type, Builtin builtin);
  std::uint32_t TargetNumber(const Carrier& leaf);

  // The distances of the inputs, or of the outputs.
  struct DistanceCount {
    std::uint32_t count = 0;
    Span span;  // of the first
  };

  Program& program_;
  const StageInfo& stage_;
  Diagnostics& diagnostics_;
  bool is_of_patch_ = false;
  Locations locations_[2];      // of outputs and of inputs
  Locations of_patch_[2];       // the same, of the whole patch
  DistanceCount distances_[2];  // of outputs and of inputs
};

// The type of the variable of a built-in input or output, which is not an array.
TypeId TypeOf(TypeTable& types, Builtin builtin);
// The type in which an input or output is stored: uint for bool, the base kind for half and for
// minimum-precision kinds.
TypeId StoredType(TypeTable& types, TypeId id);
// Converts `value` to `type`, which differs from its own type in the component kind or in being a
// vector of one.
ExprId Fit(Program& program, Builder& builder, ExprId value, TypeId type);

}  // namespace clipc::signature
