// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/object_slots.h"

#include <algorithm>

#include "base/overloaded.h"
#include "ir/builder.h"
#include "ir/walk.h"

namespace clipc {

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

bool IsObjectType(const ir::TypeTable& types, ir::TypeId type) {
  return types[types.Innermost(type)].kind == ir::TypeKind::kObject;
}

ir::VarId BodyCloner::CloneVar(ir::VarId var) {
  const ir::VarId copy = program_.vars.Add(ir::Var(program_.vars[var]));
  if (program_.vars[copy].init) program_.vars[copy].init = Clone(program_.vars[copy].init);
  vars_[var] = copy;
  return copy;
}

ir::ExprId BodyCloner::Clone(ir::ExprId expr) {
  if (!expr) return expr;
  const ir::ExprId copy = ir::Clone(program_, expr);
  Rename(copy);
  return copy;
}

void BodyCloner::Rename(ir::ExprId expr) {
  if (auto* ref = std::get_if<ir::VarRef>(&program_.exprs[expr].node)) {
    if (const auto found = vars_.find(ref->var); found != vars_.end()) ref->var = found->second;
  }
  ir::ForEachOperand(program_, expr, [&](ir::ExprId operand) { Rename(operand); });
}

List<ir::StmtId> BodyCloner::Clone(List<ir::StmtId> list) {
  std::vector<ir::StmtId> copies;
  for (std::uint32_t i = 0; i < list.size; ++i)
    copies.push_back(Clone(program_.stmt_lists[list][i]));
  return program_.stmt_lists.Add(copies);
}

ir::StmtId BodyCloner::Clone(ir::StmtId stmt) {
  if (!stmt) return stmt;
  ir::Stmt copy = program_.stmts[stmt];
  std::visit(Overloaded{
                 [&](ir::Block& node) { node.body = Clone(node.body); },
                 [&](ir::Declare& node) {
                   node.init = Clone(node.init);
                   node.var = CloneVar(node.var);
                 },
                 [&](ir::Evaluate& node) { node.expr = Clone(node.expr); },
                 [&](ir::If& node) {
                   node.condition = Clone(node.condition);
                   node.then = Clone(node.then);
                   node.otherwise = Clone(node.otherwise);
                 },
                 [&](ir::For& node) {
                   node.init = Clone(node.init);
                   node.condition = Clone(node.condition);
                   node.step = Clone(node.step);
                   node.body = Clone(node.body);
                 },
                 [&](ir::While& node) {
                   node.condition = Clone(node.condition);
                   node.body = Clone(node.body);
                 },
                 [&](ir::DoWhile& node) {
                   node.body = Clone(node.body);
                   node.condition = Clone(node.condition);
                 },
                 [&](ir::Switch& node) {
                   node.value = Clone(node.value);
                   std::vector<ir::SwitchCase> cases;
                   for (std::uint32_t i = 0; i < node.cases.size; ++i) {
                     ir::SwitchCase arm = program_.switch_cases[node.cases][i];
                     std::vector<ir::ExprId> labels;
                     for (std::uint32_t l = 0; l < arm.labels.size; ++l) {
                       labels.push_back(Clone(program_.expr_lists[arm.labels][l]));
                     }
                     arm.labels = program_.expr_lists.Add(labels);
                     arm.body = Clone(arm.body);
                     cases.push_back(arm);
                   }
                   node.cases = program_.switch_cases.Add(cases);
                 },
                 [&](ir::Return& node) { node.value = Clone(node.value); },
                 [](ir::Break&) {},
                 [](ir::Continue&) {},
             },
             copy.node);
  return program_.stmts.Add(std::move(copy));
}

}  // namespace clipc
