// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <vector>

#include "frontend/signature/distance_vars.h"
#include "frontend/signature/interface_vars.h"
#include "frontend/signature/names.h"
#include "frontend/signature/semantic_check.h"
#include "ir/builder.h"

namespace clipc::signature {

// What the function of a patch's constants reads of the control points that are written, and the
// factors by which the tessellator cuts the patch.
class PatchOutputs {
 public:
  // Keeps the references.
  PatchOutputs(Program& program, Builder& builder, SemanticCheck& semantics, InterfaceVars& vars,
               Diagnostics& diagnostics)
      : program_(program),
        builder_(builder),
        semantics_(semantics),
        vars_(vars),
        diagnostics_(diagnostics) {}

  // The output of control point `point` that the leaf of an OutputPatch has, in the leaf's own
  // type; none after an error. `distances` are those that the control points write.
  ExprId ReadPoint(const Carrier& leaf, std::uint32_t point, DistanceVars& distances);
  // What a function of the control points gives that writes nothing: up to 5.1 fxc passes each
  // control point of its patch on (vkd3d's tessellation.shader_test). `patch` is the parameter, an
  // array; nothing where it has too few elements. The statement that declares the value is added
  // to `body`.
  std::vector<Carrier> PassOn(const Carrier& patch, SignatureLeaves& leaves,
                              std::vector<StmtId>& body);
  // Notes the value of a factor, Builtin::kTessFactor or kInsideFactor.
  void AddFactor(const Carrier& leaf, Builtin builtin, ExprId value);
  // Returns the statements that write the factors, none above Tessellation::max_factor: the most
  // that the shader returns ("maxtessfactor" of Microsoft's HLSL reference). Reports those
  // that the domain lacks and those that it has no use for. `function` is where the function of the
  // constants is written.
  std::vector<StmtId> WriteFactors(Span function);

 private:
  struct Factor {
    std::uint32_t index = 0;
    ExprId value;
    Span span;
  };

  void WriteKind(Builtin builtin, std::uint32_t count, Span function, std::vector<StmtId>& stmts);

  Program& program_;
  Builder& builder_;
  SemanticCheck& semantics_;
  InterfaceVars& vars_;
  Diagnostics& diagnostics_;
  std::vector<Factor> outer_, inside_;
  bool is_refused_ = false;  // an error about one of them was reported
};

}  // namespace clipc::signature
