// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "frontend/resolve/names.h"

// The objects that a value holds, as ResolveObjects follows them.
namespace clipc::resolve {

// An index into an array of objects: a literal, a variable, or (until it is bound) an expression.
struct ObjectIndex {
  std::uint32_t literal = 0;
  VarId var;
  ExprId expr;
  bool IsLiteral() const { return !var && !expr; }
  friend bool operator==(const ObjectIndex&, const ObjectIndex&) = default;
};

// The object that resource[i][j] names.
struct ObjectPath {
  VarId resource;
  std::vector<ObjectIndex> indices;
  bool IsKnown() const {
    for (const ObjectIndex& index : indices) {
      if (!index.IsLiteral()) return false;
    }
    return true;
  }
  friend bool operator==(const ObjectPath&, const ObjectPath&) = default;
};

// The numbers of the fields and elements that lead to a part of a value, the outermost first.
using SlotPath = std::vector<std::uint32_t>;
// The objects in a value by their places in it. An array of objects may be one entry.
using Slots = std::map<SlotPath, ObjectPath>;

// The objects of the field or element number `part`.
Slots Inside(const Slots& slots, std::uint32_t part);
// Adds the objects of the field or element number `part`.
void AddUnder(Slots& slots, std::uint32_t part, const Slots& inner);
// The objects that all `count` elements share, which are the objects of an element chosen at run
// time.
Slots InsideAny(const Slots& slots, std::uint32_t count);
bool StartsWith(const SlotPath& path, const SlotPath& prefix);

// Whether the type is an object or an array of objects.
bool IsObjectType(const TypeTable& types, TypeId type);

}  // namespace clipc::resolve
