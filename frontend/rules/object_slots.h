// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "ir/program.h"

// What ResolveObjects knows of a value that holds objects.
namespace clipc {

// An index into an array of objects: a literal, a variable, or (until it is bound) an expression.
struct ObjectIndex {
  std::uint32_t literal = 0;
  ir::VarId var;
  ir::ExprId expr;
  bool IsLiteral() const { return !var && !expr; }
  friend bool operator==(const ObjectIndex&, const ObjectIndex&) = default;
};

// resource[i][j]
struct ObjectPath {
  ir::VarId resource;
  std::vector<ObjectIndex> indices;
  bool IsKnown() const {
    for (const ObjectIndex& index : indices) {
      if (!index.IsLiteral()) return false;
    }
    return true;
  }
  friend bool operator==(const ObjectPath&, const ObjectPath&) = default;
};

// Fields and elements, from the outside in.
using SlotPath = std::vector<std::uint32_t>;
// The objects in a value, by where they are in it; an array of objects may stand as a whole.
using Slots = std::map<SlotPath, ObjectPath>;

Slots Inside(const Slots& slots, std::uint32_t part);
void AddUnder(Slots& slots, std::uint32_t part, const Slots& inner);
// An element chosen at run time has the objects that all elements share.
Slots InsideAny(const Slots& slots, std::uint32_t count);
bool StartsWith(const SlotPath& path, const SlotPath& prefix);

// Objects, and arrays of them.
bool IsObjectType(const ir::TypeTable& types, ir::TypeId type);

// A copy of a statement and of all that is in it, its variables included.
class BodyCloner {
 public:
  explicit BodyCloner(ir::Program& program) : program_(program) {}
  ir::VarId CloneVar(ir::VarId var);
  ir::StmtId Clone(ir::StmtId stmt);

 private:
  ir::ExprId Clone(ir::ExprId expr);
  List<ir::StmtId> Clone(List<ir::StmtId> list);
  void Rename(ir::ExprId expr);

  ir::Program& program_;
  std::map<ir::VarId, ir::VarId> vars_;
};

}  // namespace clipc
