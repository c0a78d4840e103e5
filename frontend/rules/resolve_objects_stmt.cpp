// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "base/overloaded.h"
#include "frontend/rules/object_resolver.h"

namespace clipc {

// The statement after those that have to run before it; none when nothing is left of it.
ir::StmtId ObjectResolver::RewriteOne(ir::StmtId id) {
  std::vector<ir::StmtId> outer = std::exchange(frame_->before, {});
  const ir::StmtId result = Rewrite(id);
  std::vector<ir::StmtId> stmts = std::exchange(frame_->before, std::move(outer));
  if (stmts.empty()) return result;
  if (result) stmts.push_back(result);
  return ir::Builder(program_, program_.stmts[id].span).BlockOf(stmts);
}

List<ir::StmtId> ObjectResolver::RewriteList(List<ir::StmtId> list) {
  std::vector<ir::StmtId> stmts;
  for (std::uint32_t i = 0; i < list.size; ++i) {
    std::vector<ir::StmtId> outer = std::exchange(frame_->before, {});
    const ir::StmtId stmt = Rewrite(program_.stmt_lists[list][i]);
    stmts.insert(stmts.end(), frame_->before.begin(), frame_->before.end());
    frame_->before = std::move(outer);
    if (stmt) stmts.push_back(stmt);
  }
  return program_.stmt_lists.Add(stmts);
}

ir::StmtId ObjectResolver::Inner(ir::StmtId id) {
  if (!id) return id;
  ++frame_->depth;
  const ir::StmtId result = RewriteOne(id);
  --frame_->depth;
  return result ? result : EmptyBlock(program_.stmts[id].span);
}

// An expression that may run more than once, or not at all: nothing can be put before it.
ir::ExprId ObjectResolver::Repeated(ir::ExprId id) {
  if (!id) return id;
  const bool outer = std::exchange(frame_->may_emit, false);
  ++frame_->depth;
  const ir::ExprId result = Visit(id).expr;
  --frame_->depth;
  frame_->may_emit = outer;
  return result;
}

ir::StmtId ObjectResolver::Rewrite(ir::StmtId id) {
  ir::Stmt stmt = program_.stmts[id];
  bool is_left = true;
  std::visit(Overloaded{
                 [&](ir::Block& node) { node.body = RewriteList(node.body); },
                 [&](ir::Declare& node) { is_left = RewriteDeclare(node); },
                 [&](ir::Evaluate& node) {
                   node.expr = Visit(node.expr).expr;
                   is_left = static_cast<bool>(node.expr);
                 },
                 [&](ir::If& node) {
                   node.condition = Visit(node.condition).expr;
                   node.then = Inner(node.then);
                   node.otherwise = Inner(node.otherwise);
                 },
                 [&](ir::For& node) {
                   const bool outer = std::exchange(frame_->may_emit, false);
                   node.init = RewriteList(node.init);
                   frame_->may_emit = outer;
                   node.condition = Repeated(node.condition);
                   node.step = Repeated(node.step);
                   node.body = Inner(node.body);
                 },
                 [&](ir::While& node) {
                   node.condition = Repeated(node.condition);
                   node.body = Inner(node.body);
                 },
                 [&](ir::DoWhile& node) {
                   node.body = Inner(node.body);
                   node.condition = Repeated(node.condition);
                 },
                 [&](ir::Switch& node) { RewriteSwitch(node); },
                 [&](ir::Return& node) { RewriteReturn(node, stmt.span); },
                 [](ir::Break&) {},
                 [](ir::Continue&) {},
             },
             stmt.node);
  program_.stmts[id] = std::move(stmt);
  return is_left ? id : ir::StmtId{};
}

bool ObjectResolver::RewriteDeclare(ir::Declare& node) {
  Value value;
  if (node.init) value = Visit(node.init);
  node.init = value.expr;
  const ir::TypeId type = program_.vars[node.var].type;
  if (!Holds(type)) return true;
  frame_->depths[node.var] = frame_->depth;
  frame_->slots[node.var].clear();
  Bind(node.var, {}, std::move(value.slots), program_.vars[node.var].span);
  return !IsObject(type);
}

void ObjectResolver::RewriteSwitch(ir::Switch& node) {
  node.value = Visit(node.value).expr;
  ++frame_->depth;
  for (std::uint32_t i = 0; i < node.cases.size; ++i) {
    const List<ir::StmtId> body = RewriteList(program_.switch_cases[node.cases][i].body);
    program_.switch_cases[node.cases][i].body = body;
  }
  --frame_->depth;
}

void ObjectResolver::RewriteReturn(ir::Return& node, Span span) {
  if (!node.value) return;
  const ir::TypeId type = program_.exprs[node.value].type;
  Value value = Visit(node.value);
  node.value = value.expr;
  if (!Holds(type)) return;
  for (const auto& [path, object] : value.slots) {
    if (!object.IsKnown()) return ReportChoice(program_.vars[object.resource].name, type, span);
  }
  if (frame_->result && *frame_->result != value.slots) {
    return ReportChoice(frame_->function->name + "()", type, span);
  }
  frame_->result = std::move(value.slots);
}

}  // namespace clipc
