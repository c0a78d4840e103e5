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
  // The next leaves are those of another function, whose inputs of the same semantic are the same,
  // if they have numbers of one kind.
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

  // A read of an input at a vertex.
  struct VertexRead {
    VarId var;
    ExprId value;
  };

  Input Add(const Carrier& leaf);
  // Whether a leaf of another type may read the input, which is made as wide as the leaf then. fxc
  // has one signature for both functions of a hull shader, so that both read one input.
  bool Fits(const Input& known, const Carrier& leaf);
  void Widen(VarId input, TypeId type);
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
  std::vector<VertexRead> reads_;
};

}  // namespace clipc::signature
