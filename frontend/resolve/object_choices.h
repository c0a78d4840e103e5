// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <vector>

#include "frontend/resolve/names.h"

// What chooses among the objects that variables hold and functions return. An object is known where
// that is.
namespace clipc::resolve {

// Whether the expression is an object in an array that is not a resource itself, or in an element
// of such an array, at an index that is not written as a number.
bool ChoosesElement(const Program& program, ExprId expr);

// The indices of a path that are not written as numbers, the outermost first.
std::vector<ExprId> OpenIndices(const Program& program, ExprId path);

// Whether an `if` may decide which object a variable holds or a function returns.
bool BranchesChoose(const Program& program);

// The conditions that do: of each `if` of the function in which an object is assigned, or returned.
std::vector<ExprId> ChoosingConditions(const Program& program, const Function& function);

// The parts of expressions that choose objects.
class ObjectChoices {
 public:
  explicit ObjectChoices(const Program& program) : program_(program) {}

  // Whether a variable holds objects that is not a resource itself.
  bool HasVariables();
  // The parts of this expression that are not written as numbers: the indices in the path of an
  // object, or of an argument that has objects in it, and what `?:` asks for one of two objects.
  std::vector<ExprId> In(ExprId expr);

 private:
  // Whether a struct, or an array of them, has objects in it.
  bool HoldsObjects(TypeId type);

  const Program& program_;
  std::map<TypeId, bool> holds_;  // of structs
};

}  // namespace clipc::resolve
