// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/loop_once.h"

#include <algorithm>
#include <map>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/walk.h"

namespace clipc::ir {
namespace {

Span SpanOf(const Program& program, std::span<const StmtId> body) {
  return body.empty() ? Span{} : program.stmts[body.front()].span;
}

}  // namespace

StmtId LoopOnce(Program& program, std::span<const StmtId> body) {
  Builder b(program, SpanOf(program, body));
  const TypeId integer = program.types.Make(Scalar::kInt);
  const VarId once = b.Local("once", integer);
  const StmtId head[] = {b.Stmt(Declare{once, b.Int(0)})};
  const bool is_block = body.size() == 1 && As<Block>(program, body.front());
  return b.Stmt(For{program.stmt_lists.Add(std::span<const StmtId>(head)),
                    b.BinaryOf(BinaryOp::kLess, b.Ref(once), b.Int(1)),
                    b.Add(integer, Unary{UnaryOp::kPostIncrement, b.Ref(once)}),
                    is_block ? body.front() : b.BlockOf(body)});
}

std::vector<StmtId> IterationOnce(Program& program, std::span<const StmtId> iteration,
                                  std::span<StmtId> breaks) {
  if (breaks.empty()) return {LoopOnce(program, iteration)};
  Builder b(program, SpanOf(program, iteration));
  const VarId left = b.Local("left", program.types.Make(Scalar::kBool));
  const auto leave = [&] { return b.Eval(b.AssignTo(b.Ref(left), b.Bool(true))); };
  const std::vector<StmtId> whole = {b.BlockOf(iteration)};
  std::map<StmtId, StmtId> blocks;  // by the `break` in each
  ForEachStmt(program, whole.front(), [&](StmtId id) {
    const auto* block = As<Block>(program, id);
    if (!block) return;
    for (const StmtId part : program.stmt_lists[block->body]) blocks[part] = id;
  });
  for (StmtId& each : breaks) {
    std::vector<StmtId> parts = {each};
    StmtId block = each;
    if (const auto found = blocks.find(each); found != blocks.end()) {
      block = found->second;
      const auto old = program.stmt_lists[As<Block>(program, block)->body];
      parts.assign(old.begin(), old.end());
    } else {
      each = parts.front() = b.Stmt(Break{});
    }
    parts.insert(std::ranges::find(parts, each), leave());
    program.stmts[block].node = Block{program.stmt_lists.Add(std::span<const StmtId>(parts))};
  }
  const StmtId stop[] = {b.Stmt(Break{})};
  return {b.Stmt(Declare{left, b.Bool(false)}), LoopOnce(program, whole),
          b.Stmt(If{b.Ref(left), b.BlockOf(stop), {}})};
}

}  // namespace clipc::ir
