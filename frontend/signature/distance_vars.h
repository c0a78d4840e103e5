// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "frontend/signature/distances.h"
#include "frontend/signature/interface_vars.h"
#include "frontend/signature/names.h"
#include "frontend/signature/semantic_check.h"
#include "ir/builder.h"

namespace clipc::signature {

// The clip and cull distances that a shader reads and writes by hand.
class DistanceVars {
 public:
  // Keeps the references.
  DistanceVars(Program& program, Builder& builder, SemanticCheck& semantics, InterfaceVars& vars)
      : program_(program), builder_(builder), semantics_(semantics), vars_(vars) {}

  // The value of an input, in the leaf's own type; none after an error. A pixel shader's distances
  // lie in the array as the vertex shader packs them, so the places of these components follow in
  // FinishReads, when all pieces are known.
  ExprId Read(const Carrier& leaf, Builtin builtin);
  void FinishReads();

  // Notes a piece that is written. `value` makes an expression of the leaf's value at each call.
  void Add(const Carrier& leaf, Builtin builtin, auto&& value) {
    if (!IsDistance(leaf)) return;
    const Type type = program_.types[leaf.type];
    std::vector<ExprId> values;
    for (std::uint32_t i = 0; i < type.Components(); ++i) {
      ExprId component = value();
      if (type.kind != TypeKind::kScalar)
        component = builder_.Swizzled(component, {static_cast<int>(i)});
      values.push_back(builder_.ConvertTo(Scalar::kFloat, component));
    }
    auto& pieces = builtin == Builtin::kClipDistance ? clip_ : cull_;
    pieces.Add(leaf.cursor.semantic.index, std::move(values), leaf.span);
  }
  // Writes the pieces, and forgets them. Distances in a gap are 0, which clips nothing.
  void Write(std::vector<StmtId>& body);
  // What the leaf of an OutputPatch has at control point `point`, in the leaf's own type; none
  // where no distances of its semantic were written.
  ExprId ReadPoint(const Carrier& leaf, std::uint32_t point);

 private:
  void ReadKind(Builtin builtin, Distances& pieces, bool has_gaps);
  void WriteKind(Builtin builtin, Distances& pieces, bool has_gaps, std::vector<StmtId>& body);
  // Reports and returns false unless the leaf can be distances.
  bool IsDistance(const Carrier& leaf);

  Program& program_;
  Builder& builder_;
  SemanticCheck& semantics_;
  InterfaceVars& vars_;
  Distances clip_, cull_, clip_reads_, cull_reads_;
};

}  // namespace clipc::signature
