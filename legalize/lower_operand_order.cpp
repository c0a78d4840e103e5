// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstddef>
#include <ranges>
#include <string>
#include <vector>

#include "base/kept_blocks.h"
#include "ir/call_order.h"
#include "ir/walk.h"
#include "legalize/legalize.h"
#include "legalize/outer_writes.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// Whether the expression writes something that is not its own: a variable, an object, or what a
// function reaches.
bool MayWrite(const Program& program, const Expr& expr, OuterWrites& outer_writes) {
  const auto writes_argument = [&](FunctionId function) {
    return std::ranges::any_of(program.functions[function].parameters, [&](VarId parameter) {
      return program.vars[parameter].storage != Storage::kIn;
    });
  };
  return clipc::Visit(Overloaded{
                          [](const Assign&) { return true; },
                          [](const Unary& node) { return ChangesOperand(node.op); },
                          [&](const Call& node) {
                            return writes_argument(node.function) ||
                                   outer_writes.Of(node.function).writes();
                          },
                          [](const IntrinsicCall& node) { return WritesArguments(node.op); },
                          [](const ObjectCall& node) { return WritesObject(node.op); },
                          [](const auto&) { return false; },
                      },
                      expr.node);
}

// Whether the expression is a variable or a part of one without an index.
bool IsPlainPath(const Program& program, ExprId path) {
  while (path && !As<VarRef>(program, path))
    path = As<Index>(program, path) ? ExprId{} : WholeOf(program, path);
  return static_cast<bool>(path);
}

// Whether an expression that may write is not that of a statement, nor what a statement assigns to
// a variable, which it does last. Such a one may be an operand. Expressions that were replaced are
// asked too, since that is faster than a walk.
bool MayHaveWritingOperand(const Program& program, OuterWrites& outer_writes) {
  std::vector<bool> is_statement(program.exprs.size());
  const auto nothing = [](const auto&) {};
  const auto on_expr = [&](ExprId expr) {
    is_statement[expr.index] = true;
    const auto* assign = As<Assign>(program, expr);
    if (assign && !assign->op && assign->value && IsPlainPath(program, assign->target))
      is_statement[assign->value.index] = true;
  };
  program.stmts.ForEach(
      [&](StmtId, const Stmt& stmt) { ForEachPartSlot(stmt, on_expr, nothing, nothing, nothing); });
  bool may_write = false;
  program.exprs.ForEach([&](ExprId id, const Expr& expr) {
    const auto& node = expr.node;
    const bool is_of_kind =
        std::holds_alternative<Assign>(node) || std::holds_alternative<Unary>(node) ||
        std::holds_alternative<Call>(node) || std::holds_alternative<IntrinsicCall>(node) ||
        std::holds_alternative<ObjectCall>(node);
    may_write = may_write ||
                (is_of_kind && !is_statement[id.index] && MayWrite(program, expr, outer_writes));
  });
  return may_write;
}

// Whether an operand may write what another one reads. In most programs each write is a statement
// by itself, and there is nothing to lower.
bool HasWritingOperand(const Program& program, OuterWrites& outer_writes) {
  if (!MayHaveWritingOperand(program, outer_writes)) return false;
  bool found = false;
  const auto visit = [&](ExprId operand) {
    found = found || (operand && MayWrite(program, program.exprs[operand], outer_writes));
  };
  for (const ExprId expr : program.exprs.ids()) {
    // The nodes do not change, so they need not be copied as ForEachOperand does.
    Visit(
        [&](const auto& node) {
          ForEachSlot(node, visit, [&](List<ExprId> list) {
            for (const ExprId operand : program.expr_lists[list]) visit(operand);
          });
        },
        program.exprs[expr].node);
    if (found) return true;
  }
  return false;
}

// Walks each expression in the order of evaluation with a stack of its reads that a driver may
// still put off. A write of what such a read reads marks it; the marked ones are read into
// variables. The walk is linear: a read is marked, or leaves the stack, once.
class OperandOrder {
 public:
  OperandOrder(Program& program, OuterWrites& outer_writes)
      : program_(program), outer_writes_(outer_writes), last_(program.vars.size(), kNone) {}

  void Lower(FunctionId function) { LowerBlock(program_.functions[function].body); }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  struct Read {
    ExprId expr;
    VarId var;
    std::size_t before = kNone;  // the read of the same variable below this one
    bool is_marked = false;
    bool may_precede = false;  // nothing is written between the start of the statement and it
    bool is_target = false;    // of the compound assignment `expr`, which reads it last
  };

  // ---- statements

  void LowerBlock(StmtId block) {
    const List<StmtId> list = As<Block>(program_, block)->body;
    std::vector<StmtId> all;
    bool is_changed = false;
    for (std::uint32_t i = 0; i < list.size; ++i) {
      const StmtId stmt = program_.stmt_lists[list][i];
      std::vector<StmtId> declared;
      LowerStmt(stmt, declared, !IsLoop(stmt));
      is_changed |= !declared.empty();
      all.insert(all.end(), declared.begin(), declared.end());
      all.push_back(stmt);
    }
    if (is_changed)
      program_.stmts[block].node = Block{program_.stmt_lists.Add(std::span<const StmtId>(all))};
  }

  bool IsLoop(StmtId stmt) const {
    return As<For>(program_, stmt) || As<While>(program_, stmt) || As<DoWhile>(program_, stmt);
  }

  // Appends the variables that the statement needs to `declared`. `is_first`: its expression is
  // evaluated once, right after them.
  void LowerStmt(StmtId stmt, std::vector<StmtId>& declared, bool is_first) {
    if (As<Block>(program_, stmt)) return LowerBlock(stmt);
    KeptVector<ExprId> exprs;
    KeptVector<StmtId> parts;
    ForEachPart(
        program_, stmt, [&](ExprId expr) { exprs.push_back(expr); },
        [&](StmtId part) { parts.push_back(part); });
    for (const ExprId expr : exprs) {
      writes_ = is_first ? 0 : 1;
      marked_.clear(), reversed_.clear();
      Visit(expr);
      Pop(0);
      for (const Read& read : marked_) {
        if (read.is_target) SaveValue(read.expr, declared);
      }
      for (const Read& read : std::views::reverse(marked_)) {
        if (!read.is_target) Save(read, declared);
      }
      for (const ExprId reversed : reversed_) SaveAllButLast(reversed, declared);
    }
    for (const StmtId part : parts) LowerStmt(part, declared, false);
  }

  // n  =>  old_n, with `T old_n = n;` before the statement, or (old_n = n)
  void Save(const Read& read, std::vector<StmtId>& declared) {
    Builder b(program_, program_.exprs[read.expr].span);
    const TypeId type = program_.exprs[read.expr].type;
    const VarId old = b.Local("old_" + NameOf(read.expr), type);
    const ExprId value = b.Add(type, program_.exprs[read.expr].node);
    declared.push_back(b.Stmt(Declare{old, read.may_precede ? value : ExprId{}}));
    if (read.may_precede) {
      program_.exprs[read.expr].node = VarRef{old};
    } else {
      program_.exprs[read.expr].node = Assign{std::nullopt, b.Ref(old), value};
    }
  }

  // a[i] += (a[0] = 2)  =>  (index = i, value = a[0] = 2, a[index] += value)
  void SaveValue(ExprId expr, std::vector<StmtId>& declared) {
    Builder b(program_, program_.exprs[expr].span);
    Assign assign = *As<Assign>(program_, expr);
    std::vector<ExprId> saved;
    const auto save = [&](const char* name, ExprId from) {
      const VarId to = b.Local(name, TypeIdOf(program_, from));
      declared.push_back(b.Stmt(Declare{to, {}}));
      saved.push_back(b.AssignTo(b.Ref(to), from));
      return b.Ref(to);
    };
    assign.value = save("value", assign.value);
    for (ExprId part = assign.target; part; part = WholeOf(program_, part)) {
      const auto* node = As<Index>(program_, part);
      if (!node || As<Literal>(program_, node->index)) continue;
      const ExprId base = node->base, index = save("index", node->index);
      program_.exprs[part].node = Index{base, index};
    }
    ExprId first = saved.back();
    for (std::size_t i = saved.size() - 1; i-- > 0;) first = b.CommaOf(first, saved[i]);
    program_.exprs[expr].node = Comma{first, b.Add(program_.exprs[expr].type, assign)};
  }

  // mul(f(), b)  =>  (value = f(), mul(value, b))
  void SaveAllButLast(ExprId expr, std::vector<StmtId>& declared) {
    Builder b(program_, program_.exprs[expr].span);
    const ExprId last = OperandsOf(program_, expr).back();
    std::vector<ExprId> saved;
    MapOperands(program_, expr, [&](ExprId operand) {
      if (operand == last) return operand;
      const VarId value = b.Local("value", TypeIdOf(program_, operand));
      declared.push_back(b.Stmt(Declare{value, {}}));
      saved.push_back(b.AssignTo(b.Ref(value), operand));
      return b.Ref(value);
    });
    const TypeId type = program_.exprs[expr].type;
    ExprId rest = b.Add(type, program_.exprs[expr].node);
    for (std::size_t i = saved.size(); i-- > 1;) rest = b.CommaOf(saved[i], rest);
    program_.exprs[expr].node = Comma{saved[0], rest};
  }

  std::string NameOf(ExprId expr) const {
    if (const auto* assign = As<Assign>(program_, expr)) expr = assign->target;
    if (const auto* unary = As<Unary>(program_, expr)) expr = unary->operand;
    for (; expr; expr = WholeOf(program_, expr)) {
      if (const auto* field = As<FieldRef>(program_, expr))
        return program_.types.StructOf(TypeIdOf(program_, field->base)).fields[field->field].name;
      if (const auto* ref = As<VarRef>(program_, expr)) return program_.vars[ref->var].name;
    }
    return "value";
  }

  // ---- reads

  void Push(ExprId expr, VarId var, bool may_precede, bool is_target = false) {
    reads_.push_back({expr, var, last_[var.index], false, may_precede, is_target});
    last_[var.index] = reads_.size() - 1;
  }
  void Pop(std::size_t size) {
    while (reads_.size() > size) {
      const Read& read = reads_.back();
      last_[read.var.index] = read.before;
      if (read.is_marked) marked_.push_back(read);
      reads_.pop_back();
    }
    marked_below_ = std::min(marked_below_, size);
  }
  // Takes the reads from `first` on off the stack; Put puts them on it again.
  std::vector<Read> Take(std::size_t first) {
    const auto begin = reads_.begin() + static_cast<std::ptrdiff_t>(std::min(first, reads_.size()));
    std::vector<Read> taken;
    for (auto read = begin; read != reads_.end(); ++read) {
      if (!read->is_marked) taken.push_back(*read);
    }
    Pop(first);
    return taken;
  }
  void Put(const std::vector<Read>& taken) {
    for (const Read& read : taken) Push(read.expr, read.var, read.may_precede, read.is_target);
  }

  void Write(VarId var) {
    ++writes_;
    if (!var || var.index >= last_.size()) return;
    for (std::size_t i = last_[var.index]; i != kNone && !reads_[i].is_marked; i = reads_[i].before)
      reads_[i].is_marked = true;
  }
  void WriteAll() {
    ++writes_;
    for (std::size_t i = marked_below_; i < reads_.size(); ++i) reads_[i].is_marked = true;
    marked_below_ = reads_.size();
  }
  void WriteOuter(FunctionId function) {
    const OuterWrites::Set& set = outer_writes_.Of(function);
    if (set.is_all) return WriteAll();
    for (const VarId var : set.vars) Write(var);
  }

  // ---- expressions

  void Visit(ExprId expr) {
    const std::size_t size = reads_.size();
    clipc::Visit(Overloaded{
                     [&](const OneOf<VarRef, FieldRef, Index, Swizzle, MatrixSwizzle> auto&) {
                       VisitPath(expr);
                       PushPath(expr);
                     },
                     [&](const Unary& node) {
                       if (!ChangesOperand(node.op)) return Visit(node.operand);
                       VisitPath(node.operand);
                       Pop(size);
                       Write(RootOf(program_, node.operand));
                       if (node.op == UnaryOp::kPreIncrement || node.op == UnaryOp::kPreDecrement)
                         PushTarget(expr, node.operand);
                     },
                     [&](const Assign& node) {
                       VisitPath(node.target);
                       const VarId root = RootOf(program_, node.target);
                       if (node.op && root) Push(expr, root, false, true);
                       Visit(node.value);
                       Pop(size);
                       Write(RootOf(program_, node.target));
                       PushTarget(expr, node.target);
                     },
                     [&](const Comma& node) {
                       Visit(node.first);
                       Pop(size);
                       Visit(node.second);
                     },
                     [&](const Binary& node) { VisitBinary(node); },
                     [&](const Conditional& node) { VisitConditional(node); },
                     [&](const Call& node) { VisitCall(expr, node.function); },
                     [&](const IntrinsicCall& node) {
                       if (WritesArguments(node.op)) return VisitCall(expr, {});
                       if (node.op == CommonIntrinsic::kMul) return VisitReversed(expr);
                       ForEachOperand(program_, expr, [&](ExprId operand) { Visit(operand); });
                     },
                     [&](const Select&) { VisitReversed(expr); },
                     [&](const ObjectCall& node) { VisitObjectCall(expr, node); },
                     [&](const auto&) {
                       ForEachOperand(program_, expr, [&](ExprId operand) { Visit(operand); });
                     },
                 },
                 program_.exprs[expr].node);
  }

  // Visits what a path evaluates to find its place: the value that it is a part of, and indices.
  void VisitPath(ExprId path) {
    const ExprId whole = WholeOf(program_, path);
    if (whole) {
      VisitPath(whole);
    } else if (!As<VarRef>(program_, path)) {
      Visit(path);
    }
    if (const auto* index = As<Index>(program_, path)) Visit(index->index);
  }

  void PushPath(ExprId path) {
    const VarId root = RootOf(program_, path);
    if (root && IsVariable(root))
      Push(path, root, writes_ == 0 && HasLiteralIndices(program_, path));
  }
  // The value of an assignment is its target, which a driver may read later.
  void PushTarget(ExprId expr, ExprId target) {
    if (const VarId root = RootOf(program_, target)) Push(expr, root, false);
  }
  bool IsVariable(VarId var) const {
    switch (program_.vars[var].storage) {
      case Storage::kLocal:
      case Storage::kIn:
      case Storage::kOut:
      case Storage::kInOut:
      case Storage::kStatic:
      case Storage::kShared:
      case Storage::kOutput: return true;
      default: return false;
    }
  }

  void VisitBinary(const Binary& node) {
    const std::size_t size = reads_.size();
    Visit(node.left);
    if (!IsShortCircuit(node.op)) return Visit(node.right);
    // The left side decides first whether the right one is evaluated at all.
    const std::vector<Read> left = Take(size);
    Visit(node.right);
    Put(left);
  }

  void VisitConditional(const Conditional& node) {
    const std::size_t size = reads_.size();
    Visit(node.condition);
    const std::vector<Read> condition = Take(size);
    Visit(node.when_true);
    const std::vector<Read> when_true = Take(size);
    Visit(node.when_false);
    Put(condition), Put(when_true);
  }

  // A call has its arguments before the function runs, and its value is nobody else's.
  void VisitCall(ExprId expr, FunctionId function) {
    const std::size_t size = reads_.size();
    const std::vector<ExprId> arguments = OperandsOf(program_, expr);
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      if (WritesOperand(program_, expr, i)) {
        VisitPath(arguments[i]);
      } else {
        Visit(arguments[i]);
      }
    }
    Pop(size);
    if (function) WriteOuter(function);
    ForEachWrite(program_, expr, [&](ExprId target) { Write(RootOf(program_, target)); });
  }

  // mul() and select(), which the writer gives their operands in the opposite order: matrices are
  // transposed, and mix() has what it takes for false first.
  void VisitReversed(ExprId expr) {
    const std::size_t size = reads_.size(), writes = writes_;
    const std::vector<ExprId> operands = OperandsOf(program_, expr);
    std::vector<Read> all, last;
    for (const ExprId operand : operands) {
      Visit(operand);
      last = Take(size);
      all.insert(all.end(), last.begin(), last.end());
    }
    if (writes_ == writes) return Put(all);
    reversed_.push_back(expr);
    Put(last);  // the operand that stays where it is
  }

  void VisitObjectCall(ExprId expr, const ObjectCall& node) {
    const std::size_t size = reads_.size();
    for (const ExprId operand : OperandsOf(program_, expr)) Visit(operand);
    const VarId object = RootOf(program_, OperandOf(program_, node, OperandKind::kObject));
    if (WritesObject(node.op)) {
      Pop(size);
      Write(object);
    } else if (object) {
      Push(expr, object, false);
    }
  }

  Program& program_;
  OuterWrites& outer_writes_;
  std::vector<std::size_t> last_;  // the topmost read of each variable, by VarId
  std::vector<Read> reads_;        // of the expression that is walked, in the order of evaluation
  std::size_t marked_below_ = 0;   // all reads below this one are marked
  std::vector<Read> marked_;       // those that left the stack
  std::vector<ExprId> reversed_;   // nodes that are written in the opposite order
  std::size_t writes_ = 0;         // by now in the statement; not 0 where a loop may have written
};

}  // namespace

void LowerOperandOrder(Legalizer& legalizer) {
  Program& program = legalizer.program;
  OuterWrites outer_writes(program);
  if (!HasWritingOperand(program, outer_writes)) return;
  OperandOrder order(program, outer_writes);
  for (const FunctionId id : CalleesFirst(program)) order.Lower(id);
}

}  // namespace clipc::legalize
