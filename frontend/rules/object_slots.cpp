// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/object_slots.h"

#include <algorithm>

#include "ir/builder.h"
#include "ir/walk.h"

namespace clipc::rules {

Slots Inside(const Slots& slots, std::uint32_t part) {
  Slots inner;
  for (const auto& [path, object] : slots) {
    if (path.empty()) {
      ObjectPath element = object;
      element.indices.push_back({part, {}, {}});
      inner[{}] = std::move(element);
    } else if (path.front() == part) {
      inner[SlotPath(path.begin() + 1, path.end())] = object;
    }
  }
  return inner;
}

void AddUnder(Slots& slots, std::uint32_t part, const Slots& inner) {
  for (const auto& [path, object] : inner) {
    SlotPath whole{part};
    whole.insert(whole.end(), path.begin(), path.end());
    slots[whole] = object;
  }
}

Slots InsideAny(const Slots& slots, std::uint32_t count) {
  Slots shared = Inside(slots, 0);
  for (std::uint32_t i = 1; i < count && !shared.empty(); ++i) {
    const Slots other = Inside(slots, i);
    std::erase_if(shared, [&](const auto& slot) {
      const auto found = other.find(slot.first);
      return found == other.end() || found->second != slot.second;
    });
  }
  return shared;
}

bool StartsWith(const SlotPath& path, const SlotPath& prefix) {
  return path.size() >= prefix.size() && std::equal(prefix.begin(), prefix.end(), path.begin());
}

bool IsObjectType(const TypeTable& types, TypeId type) {
  return types[types.Innermost(type)].kind == TypeKind::kObject;
}

VarId BodyCloner::CloneVar(VarId var) {
  const VarId copy = program_.vars.Add(Var(program_.vars[var]));
  if (program_.vars[copy].init) program_.vars[copy].init = Clone(program_.vars[copy].init);
  vars_[var] = copy;
  return copy;
}

ExprId BodyCloner::Clone(ExprId expr) {
  const ExprId copy = ir::Clone(program_, expr);
  Rename(copy);
  return copy;
}

void BodyCloner::Rename(ExprId expr) {
  if (auto* ref = std::get_if<VarRef>(&program_.exprs[expr].node)) {
    if (const auto found = vars_.find(ref->var); found != vars_.end()) ref->var = found->second;
  }
  ForEachOperand(program_, expr, [&](ExprId operand) { Rename(operand); });
}

List<StmtId> BodyCloner::Clone(List<StmtId> list) {
  std::vector<StmtId> copies;
  for (std::uint32_t i = 0; i < list.size; ++i)
    copies.push_back(Clone(program_.stmt_lists[list][i]));
  return program_.stmt_lists.Add(copies);
}

StmtId BodyCloner::Clone(StmtId stmt) {
  Stmt copy = program_.stmts[stmt];
  const auto replace = [&](auto& part) { part = Clone(part); };
  ForEachPartSlot(copy, replace, replace, replace, [&](List<SwitchCase>& list) {
    std::vector<SwitchCase> cases;
    for (std::uint32_t i = 0; i < list.size; ++i) {
      SwitchCase arm = program_.switch_cases[list][i];
      std::vector<ExprId> labels;
      for (std::uint32_t l = 0; l < arm.labels.size; ++l)
        labels.push_back(Clone(program_.expr_lists[arm.labels][l]));
      arm.labels = program_.expr_lists.Add(labels);
      arm.body = Clone(arm.body);
      cases.push_back(arm);
    }
    list = program_.switch_cases.Add(cases);
  });
  if (auto* declare = std::get_if<Declare>(&copy.node)) declare->var = CloneVar(declare->var);
  return program_.stmts.Add(std::move(copy));
}

}  // namespace clipc::rules
