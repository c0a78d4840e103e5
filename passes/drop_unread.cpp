// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/drop_unread.h"

#include <cstdint>
#include <span>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"

namespace clipc::passes {

using namespace ir;

namespace {

// The search for unread variables, which looks at the statements directly in a block, its lines:
// that of `main`, or the one in it that writes the constants of a patch.
class Dropper {
 public:
  Dropper(Program& program, StmtId block)
      : program_(program),
        block_(block),
        reads_(program.vars.size()),
        lines_of_(program.vars.size()) {}

  void Run() {
    const auto body = program_.stmt_lists[As<Block>(program_, block_)->body];
    lines_.reserve(body.size());
    for (const StmtId id : body) AddLine(id);
    FindUnread();
    if (unread_.empty()) return;
    DropLines();
    std::vector<StmtId> left;
    left.reserve(lines_.size());
    for (const Line& line : lines_) {
      if (line.stmt) left.push_back(line.stmt);
    }
    program_.stmts[block_].node = Block{program_.stmt_lists.Add(std::span<const StmtId>(left))};
  }

 private:
  // A statement that declares a local variable, or gives it or a part of it a value.
  struct Definition {
    VarId var;
    ExprId value;  // none: a declaration without a value
  };
  struct Line {
    StmtId stmt;             // none: dropped
    ExprId value;            // the value that a definition gives; otherwise none
    std::uint32_t previous;  // the line before that defines the same variable, from 1; 0: none
  };

  void FindUnread() {
    for (std::uint32_t var = 0; var < reads_.size(); ++var) {
      if (reads_[var] == 0 && lines_of_[var] != 0) unread_.push_back(var);
    }
  }

  // Dropping the lines of a variable may leave others unread.
  void DropLines() {
    while (!unread_.empty()) {
      const std::uint32_t var = unread_.back();
      unread_.pop_back();
      if (!HasPureLines(var)) continue;
      for (std::uint32_t line = lines_of_[var]; line != 0; line = lines_[line - 1].previous) {
        lines_[line - 1].stmt = {};
        Count(lines_[line - 1].value, VarId{var}, -1);
      }
    }
  }

  // Whether the lines of a variable do nothing but give it a value.
  bool HasPureLines(std::uint32_t var) const {
    for (std::uint32_t line = lines_of_[var]; line != 0; line = lines_[line - 1].previous) {
      const ExprId value = lines_[line - 1].value;
      if (value && !IsPure(program_, value)) return false;
    }
    return true;
  }

  void AddLine(StmtId id) {
    const Definition definition = DefinitionAt(id);
    if (!definition.var) {
      lines_.push_back({id, {}, 0});
      return CountAll(id);
    }
    std::uint32_t& last = lines_of_[definition.var.index];
    lines_.push_back({id, definition.value, last});
    last = static_cast<std::uint32_t>(lines_.size());
    Count(definition.value, definition.var, 1);
  }

  Definition DefinitionAt(StmtId id) const {
    Definition definition;
    if (const auto* declare = As<Declare>(program_, id)) {
      definition = {declare->var, declare->init};
    } else if (const Assign* assign = AsAssignment(program_, id);
               assign && HasLiteralIndices(program_, assign->target)) {
      definition = {RootOf(program_, assign->target), assign->value};
    }
    const bool is_local =
        definition.var && program_.vars[definition.var].storage == Storage::kLocal;
    return is_local ? definition : Definition{};
  }

  // Adds `by` to the reads of each variable in `root`, an expression or a statement, except `own`:
  // a read in the variable's own value does not count.
  template <typename Root>
  void Count(Root root, VarId own, std::int32_t by) {
    if (!root) return;
    ForEachExpr(program_, root, [&](ExprId id) {
      const auto* ref = As<VarRef>(program_, id);
      if (!ref || ref->var == own) return;
      const std::uint32_t var = ref->var.index;
      reads_[var] += by;
      if (by < 0 && reads_[var] == 0 && lines_of_[var] != 0) unread_.push_back(var);
    });
  }
  void CountAll(StmtId id) {
    ForEachStmt(program_, id, [&](StmtId part) {
      if (const auto* declare = As<Declare>(program_, part)) ++reads_[declare->var.index];
    });
    Count(id, {}, 1);
  }

  Program& program_;
  StmtId block_;
  std::vector<std::int32_t> reads_;      // by VarId; a change that must be kept counts as a read
  std::vector<Line> lines_;              // the statements of the block
  std::vector<std::uint32_t> lines_of_;  // by VarId: its last line, from 1; 0: none
  std::vector<std::uint32_t> unread_;
};

}  // namespace

void DropUnread(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  // What the block declares is read in it alone.
  if (const StmtId patch = PatchBlock(program)) Dropper(program, patch).Run();
  Dropper(program, program.functions[program.main].body).Run();
}

}  // namespace clipc::passes
