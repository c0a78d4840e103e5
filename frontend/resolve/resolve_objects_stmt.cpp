// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/resolve/object_resolver.h"
#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::resolve {

// Rewrites a statement. The result includes the statements that have to run before it; it is none
// if nothing is left.
StmtId ObjectResolver::RewriteOne(StmtId id) {
  std::vector<StmtId> outer = std::exchange(frame_->before, {});
  const StmtId result = Rewrite(id);
  std::vector<StmtId> stmts = std::exchange(frame_->before, std::move(outer));
  if (stmts.empty()) return result;
  if (result) stmts.push_back(result);
  return Builder(program_, program_.stmts[id].span).BlockOf(stmts);
}

List<StmtId> ObjectResolver::RewriteList(List<StmtId> list) {
  std::vector<StmtId> stmts;
  for (std::uint32_t i = 0; i < list.size; ++i) {
    std::vector<StmtId> outer = std::exchange(frame_->before, {});
    const StmtId stmt = Rewrite(program_.stmt_lists[list][i]);
    stmts.insert(stmts.end(), frame_->before.begin(), frame_->before.end());
    frame_->before = std::move(outer);
    if (stmt) stmts.push_back(stmt);
  }
  return program_.stmt_lists.Add(stmts);
}

StmtId ObjectResolver::Inner(StmtId id) {
  ++frame_->depth;
  const StmtId result = RewriteOne(id);
  --frame_->depth;
  return result ? result : Builder(program_, program_.stmts[id].span).BlockOf({});
}

// Rewrites an expression that may run more than once, or not at all: nothing can be put before it.
ExprId ObjectResolver::Repeated(ExprId id) {
  const bool outer = std::exchange(frame_->may_emit, false);
  ++frame_->depth;
  const ExprId result = Visit(id).expr;
  --frame_->depth;
  frame_->may_emit = outer;
  return result;
}

StmtId ObjectResolver::Rewrite(StmtId id) {
  Stmt stmt = program_.stmts[id];
  bool is_left = true;
  if (auto* declare = std::get_if<Declare>(&stmt.node)) {
    is_left = RewriteDeclare(*declare);
  } else if (auto* result = std::get_if<Return>(&stmt.node)) {
    RewriteReturn(*result, stmt.span);
  } else if (const auto part = ChosenPart(stmt)) {
    return *part ? RewriteOne(*part) : StmtId{};
  } else {
    RewriteParts(stmt);
    const auto* evaluate = std::get_if<Evaluate>(&stmt.node);
    is_left = !evaluate || evaluate->expr;
  }
  program_.stmts[id] = std::move(stmt);
  return is_left ? id : StmtId{};
}

// The part of an `if` with a constant condition that runs, which may be none. What the other part
// does with objects has no meaning.
std::optional<StmtId> ObjectResolver::ChosenPart(const Stmt& stmt) const {
  const auto* choice = std::get_if<If>(&stmt.node);
  const auto* condition = choice ? As<Literal>(program_, choice->condition) : nullptr;
  if (!condition) return std::nullopt;
  return condition->bits != 0 ? choice->then : choice->otherwise;
}

void ObjectResolver::RewriteParts(Stmt& stmt) {
  const bool is_loop = std::holds_alternative<For>(stmt.node) ||
                       std::holds_alternative<While>(stmt.node) ||
                       std::holds_alternative<DoWhile>(stmt.node);
  ForEachPartSlot(
      stmt, [&](ExprId& expr) { expr = is_loop ? Repeated(expr) : Visit(expr).expr; },
      [&](StmtId& part) { part = Inner(part); },
      [&](List<StmtId>& list) {
        const bool outer = std::exchange(frame_->may_emit, frame_->may_emit && !is_loop);
        list = RewriteList(list);
        frame_->may_emit = outer;
      },
      [&](List<SwitchCase> cases) {
        ++frame_->depth;
        for (std::uint32_t i = 0; i < cases.size; ++i) {
          const List<StmtId> body = RewriteList(program_.switch_cases[cases][i].body);
          program_.switch_cases[cases][i].body = body;
        }
        --frame_->depth;
      });
}

bool ObjectResolver::RewriteDeclare(Declare& node) {
  Value value;
  if (node.init) value = Visit(node.init);
  node.init = value.expr;
  const TypeId type = program_.vars[node.var].type;
  if (!Holds(type)) return true;
  frame_->depths[node.var] = frame_->depth;
  frame_->slots[node.var].clear();
  Bind(node.var, {}, std::move(value.slots), program_.vars[node.var].span);
  return !IsRemoved(type);
}

void ObjectResolver::RewriteReturn(Return& node, Span span) {
  if (!node.value) return;
  const TypeId type = program_.exprs[node.value].type;
  Value value = Visit(node.value);
  node.value = value.expr;
  if (!Holds(type)) return;
  for (auto& [path, object] : value.slots) ReturnIndices(path, object, span);
  if (frame_->result && *frame_->result != value.slots) {
    return ReportChoice(frame_->function->name + "()", type, span);
  }
  frame_->result = std::move(value.slots);
}

// Gives the caller the indices that are known only at run time.
void ObjectResolver::ReturnIndices(const SlotPath& path, ObjectPath& object, Span span) {
  for (std::size_t i = 0; i < object.indices.size(); ++i) {
    ObjectIndex& index = object.indices[i];
    if (index.IsLiteral()) continue;
    VarId& returned = frame_->returned_of[{path, i}];
    if (!returned) {
      returned = program_.vars.Add({.name = program_.vars[object.resource].name + "_index",
                                    .type = program_.types.Make(TypeOf(index)),
                                    .storage = Storage::kOut,
                                    .span = span});
      frame_->returned.push_back(returned);
    }
    Store(returned, index, span);
  }
}

}  // namespace clipc::resolve
