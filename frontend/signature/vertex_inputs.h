// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "frontend/signature/distances.h"
#include "frontend/signature/interface_vars.h"
#include "frontend/signature/names.h"
#include "frontend/signature/semantic_check.h"
#include "ir/builder.h"

namespace clipc::signature {

// The inputs of a stage that reads them at each vertex of a primitive.
class VertexInputs {
 public:
  // Keeps the references.
  VertexInputs(Program& program, Builder& builder, SemanticCheck& semantics, InterfaceVars& vars)
      : program_(program), builder_(builder), semantics_(semantics), vars_(vars) {}

  // The next leaves are those of this vertex, an element of a parameter. Each vertex has the same
  // ones in the same order, and those of vertex 0 make the inputs.
  void Start(std::uint32_t vertex);
  // The input's value at the vertex, in the leaf's own type; none after an error.
  ExprId Read(const Carrier& leaf);
  // The next leaves are those of another function, whose inputs of the same semantic are the same.
  void NextFunction() { shares_ = true; }
  // Makes the inputs of the distances, whose places follow when all are known.
  void Finish();

 private:
  // What a leaf reads. `distances` are those of vertex 0, whose places are not known yet.
  struct Input {
    VarId var;  // none: distances, or an error was reported
    std::vector<ExprId> distances;
    SemanticName semantic = {};
    TypeId type = {};
  };
  // A component of distances at a vertex after the first.
  struct Later {
    ExprId value, first;
    std::uint32_t vertex = 0;
  };

  Input Add(const Carrier& leaf);
  Input Make(const Carrier& leaf);
  std::vector<ExprId> Placeholders(const Carrier& leaf);
  ExprId ReadDistances(const Input& input, const Carrier& leaf);
  void Place(Builtin builtin, Distances& pieces, bool has_gaps);
  ExprId AtVertex(VarId input, std::uint32_t vertex);

  Program& program_;
  Builder& builder_;
  SemanticCheck& semantics_;
  InterfaceVars& vars_;
  std::vector<Input> inputs_;         // by leaf of vertex 0
  std::size_t first_ = 0, next_ = 0;  // of the parameter; of the next leaf
  std::uint32_t vertex_ = 0;
  bool shares_ = false;
  Distances clip_, cull_;
  std::vector<Later> later_;
};

}  // namespace clipc::signature
