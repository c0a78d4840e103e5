// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/object_choices.h"

#include <algorithm>

#include "frontend/resolve/object_slots.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::resolve {
namespace {

bool IsOfObject(const Program& program, ExprId expr) {
  return IsObjectType(program.types, program.exprs[expr].type);
}

class BranchReader {
 public:
  BranchReader(const Program& program, const Function& function)
      : program_(program), returns_object_(IsObjectType(program.types, function.return_type)) {}

  // Returns whether the statement assigns or returns an object.
  bool Read(StmtId stmt) {
    bool chooses = returns_object_ && As<Return>(program_, stmt);
    const auto is_choice = [&](ExprId expr) {
      return As<Assign>(program_, expr) && IsOfObject(program_, expr);
    };
    ForEachPart(
        program_, stmt, [&](ExprId root) { chooses |= AnyExpr(program_, root, is_choice); },
        [&](StmtId part) { chooses |= Read(part); });
    const auto* branch = As<If>(program_, stmt);
    if (branch && chooses) conditions.push_back(branch->condition);
    return chooses;
  }

  std::vector<ExprId> conditions;

 private:
  const Program& program_;
  const bool returns_object_;
};

}  // namespace

bool ChoosesElement(const Program& program, ExprId expr) {
  if (!As<Index>(program, expr) && !As<FieldRef>(program, expr)) return false;
  if (!IsOfObject(program, expr) || OpenIndices(program, expr).empty()) return false;
  const VarId root = RootOf(program, expr);
  return root && program.vars[root].storage != Storage::kResource;
}

std::vector<ExprId> OpenIndices(const Program& program, ExprId path) {
  std::vector<ExprId> indices;
  for (ExprId part = path; part; part = WholeOf(program, part)) {
    const auto* index = As<Index>(program, part);
    if (index && !As<Literal>(program, index->index)) indices.push_back(index->index);
  }
  return indices;
}

bool BranchesChoose(const Program& program) {
  if (!MayHaveStmt<If>(program)) return false;
  return program.functions.AnyOf([&](const Function& function) {
    return IsObjectType(program.types, function.return_type);
  }) || MayHaveExpr<Assign>(program, [&](const Assign& assign) {
           return IsOfObject(program, assign.target);
         });
}

std::vector<ExprId> ChoosingConditions(const Program& program, const Function& function) {
  BranchReader reader(program, function);
  reader.Read(function.body);
  return std::move(reader.conditions);
}

bool ObjectChoices::HasVariables() {
  return program_.vars.AnyOf([&](const Var& var) {
    return var.storage != Storage::kResource &&
           (IsObjectType(program_.types, var.type) || HoldsObjects(var.type));
  });
}

std::vector<ExprId> ObjectChoices::In(ExprId expr) {
  if (ChoosesElement(program_, expr)) return OpenIndices(program_, expr);
  const auto* choice = As<Conditional>(program_, expr);
  if (choice && IsOfObject(program_, expr)) return {choice->condition};
  std::vector<ExprId> choices;
  if (const auto* call = As<Call>(program_, expr)) {
    for (const ExprId argument : program_.expr_lists[call->arguments]) {
      if (!RootOf(program_, argument) || !HoldsObjects(program_.exprs[argument].type)) continue;
      const std::vector<ExprId> indices = OpenIndices(program_, argument);
      choices.insert(choices.end(), indices.begin(), indices.end());
    }
  }
  return choices;
}

bool ObjectChoices::HoldsObjects(TypeId type) {
  type = program_.types.Innermost(type);
  if (program_.types[type].kind != TypeKind::kStruct) return false;
  const auto [known, is_new] = holds_.try_emplace(type, false);
  if (!is_new) return known->second;
  return holds_[type] =
             std::ranges::any_of(program_.types.StructOf(type).fields, [&](const Field& field) {
               return IsObjectType(program_.types, field.type) || HoldsObjects(field.type);
             });
}

}  // namespace clipc::resolve
