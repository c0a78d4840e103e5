// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/signature/interface_vars.h"
#include "frontend/signature/names.h"
#include "frontend/signature/semantic_check.h"
#include "ir/builder.h"

namespace clipc::signature {

// Whether the input is what the tessellator gives a domain shader.
bool IsOfTessellator(Builtin builtin);

// The inputs that the tessellator gives a domain shader: where its point is in the domain, and the
// factors of the patch, an array whose size the domain says.
class PatchInputs {
 public:
  // Keeps the references.
  PatchInputs(Program& program, Builder& builder, SemanticCheck& semantics, InterfaceVars& vars)
      : program_(program), builder_(builder), semantics_(semantics), vars_(vars) {}

  // The input's value in the leaf's own type; none after an error.
  ExprId Read(const Carrier& leaf, Builtin builtin, Diagnostics& diagnostics);

 private:
  VarId Input(const Carrier& leaf, Builtin builtin, TypeId type);

  Program& program_;
  Builder& builder_;
  SemanticCheck& semantics_;
  InterfaceVars& vars_;
};

}  // namespace clipc::signature
