// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/drop_unread.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::passes {

using namespace ir;

namespace {

// Gives zeros to an entry function that is still called for the inputs that it does not read.
class ArgumentZeroer {
 public:
  explicit ArgumentZeroer(Program& program) : program_(program) {}

  void Run() {
    const Function& entry = program_.functions[program_.entry];
    const Call* call = entry.parameters.empty() ? nullptr : FindCall();
    if (!call) return;
    const List<ExprId> arguments = call->arguments;
    uses_.resize(arguments.size);
    CollectUses(entry.body);
    for (std::uint32_t i = 0; i < arguments.size; ++i) {
      if (program_.vars[entry.parameters[i]].storage != Storage::kIn || uses_[i].as_whole) continue;
      const ExprId argument = std::as_const(program_).expr_lists[arguments][i];
      if (!uses_[i].fields.empty()) {
        MakeFieldsZero(argument, uses_[i].fields);
        continue;
      }
      ExprId value = argument;
      MakeZero(value);
      program_.expr_lists[arguments][i] = value;
    }
  }

 private:
  struct Uses {
    bool as_whole = false;
    std::set<std::uint32_t> fields;
  };

  List<StmtId> Body() const {
    return std::get<Block>(program_.stmts[program_.functions[program_.main].body].node).body;
  }

  // `T result = entry(...);`, `output = entry(...);` or `entry(...);`
  const Call* FindCall() const {
    for (const StmtId id : std::as_const(program_).stmt_lists[Body()]) {
      ExprId value;
      if (const auto* declare = std::get_if<Declare>(&program_.stmts[id].node))
        value = declare->init;
      if (const auto* evaluate = std::get_if<Evaluate>(&program_.stmts[id].node)) {
        const auto* assign = std::get_if<Assign>(&program_.exprs[evaluate->expr].node);
        value = assign ? assign->value : evaluate->expr;
      }
      const auto* call = value ? std::get_if<Call>(&program_.exprs[value].node) : nullptr;
      if (call && call->function == program_.entry) return call;
    }
    return nullptr;
  }

  void CollectUses(StmtId id) {
    ForEachPart(
        program_, id, [&](ExprId expr) { CollectUses(expr); },
        [&](StmtId part) { CollectUses(part); });
  }
  void CollectUses(ExprId id) {
    const auto& node = program_.exprs[id].node;
    const auto* field = std::get_if<FieldRef>(&node);
    const auto* ref = std::get_if<VarRef>(field ? &program_.exprs[field->base].node : &node);
    const std::vector<VarId>& parameters = program_.functions[program_.entry].parameters;
    const auto found = ref ? std::ranges::find(parameters, ref->var) : parameters.end();
    if (found != parameters.end()) {
      Uses& uses = uses_[static_cast<std::size_t>(found - parameters.begin())];
      if (field)
        uses.fields.insert(field->field);
      else
        uses.as_whole = true;
      return;
    }
    ForEachOperand(program_, id, [&](ExprId operand) { CollectUses(operand); });
  }

  void MakeZero(ExprId& value) {
    if (IsPure(program_, value))
      value = Builder(program_, program_.exprs[value].span).ZeroOf(program_.exprs[value].type);
  }

  // Of the variable that is made of the inputs for this call alone: `Vertex v =
  // Vertex(in_POSITION0, in_NORMAL0);`
  void MakeFieldsZero(ExprId argument, const std::set<std::uint32_t>& read) {
    const auto* ref = std::get_if<VarRef>(&program_.exprs[argument].node);
    if (!ref) return;
    for (const StmtId id : std::as_const(program_).stmt_lists[Body()]) {
      const auto* declare = std::get_if<Declare>(&program_.stmts[id].node);
      if (!declare || declare->var != ref->var || !declare->init) continue;
      const auto* construct = std::get_if<Construct>(&program_.exprs[declare->init].node);
      if (!construct) return;
      const List<ExprId> values = construct->arguments;
      for (std::uint32_t i = 0; i < values.size; ++i) {
        if (read.contains(i)) continue;
        ExprId value = std::as_const(program_).expr_lists[values][i];
        MakeZero(value);
        program_.expr_lists[values][i] = value;
      }
    }
  }

  Program& program_;
  std::vector<Uses> uses_;  // by parameter of the entry function
};

class Dropper {
 public:
  explicit Dropper(Program& program)
      : program_(program), reads_(program.vars.size()), lines_of_(program.vars.size()) {}

  void Run() {
    Block& body = std::get<Block>(program_.stmts[program_.functions[program_.main].body].node);
    for (const StmtId id : std::as_const(program_).stmt_lists[body.body]) {
      const Definition definition = DefinitionAt(id);
      lines_.push_back(
          {id, definition.value, definition.var ? lines_of_[definition.var.index] : 0});
      if (definition.var)
        lines_of_[definition.var.index] = static_cast<std::uint32_t>(lines_.size());
      if (definition.var)
        Count(definition.value, definition.var, 1);
      else
        CountAll(id);
    }
    for (std::uint32_t var = 0; var < reads_.size(); ++var) {
      if (reads_[var] == 0 && lines_of_[var] != 0) unread_.push_back(var);
    }
    if (unread_.empty()) return;
    while (!unread_.empty()) {
      const std::uint32_t var = unread_.back();
      unread_.pop_back();
      for (std::uint32_t line = lines_of_[var]; line != 0; line = lines_[line - 1].previous) {
        lines_[line - 1].stmt = {};
        Count(lines_[line - 1].value, VarId{var}, -1);
      }
    }
    std::vector<StmtId> left;
    for (const Line& line : lines_) {
      if (line.stmt) left.push_back(line.stmt);
    }
    body.body = program_.stmt_lists.Add(std::span<const StmtId>(left));
  }

 private:
  // A statement that gives a local variable, or a part of it, a value and does nothing else.
  struct Definition {
    VarId var;
    ExprId value;  // none: a declaration without
  };
  struct Line {
    StmtId stmt;             // none: dropped
    ExprId value;            // of a definition
    std::uint32_t previous;  // line that defines the same variable, from 1; 0: none
  };

  Definition DefinitionAt(StmtId id) const {
    Definition definition;
    const auto& node = program_.stmts[id].node;
    if (const auto* declare = std::get_if<Declare>(&node)) {
      definition = {declare->var, declare->init};
    } else if (const auto* evaluate = std::get_if<Evaluate>(&node)) {
      const auto* assign = std::get_if<Assign>(&program_.exprs[evaluate->expr].node);
      if (assign && !assign->op) definition = {RootOf(assign->target), assign->value};
    }
    const bool is_local =
        definition.var && program_.vars[definition.var].storage == Storage::kLocal;
    return is_local && (!definition.value || IsPure(program_, definition.value)) ? definition
                                                                                 : Definition{};
  }

  // Of a path that needs no other variable; none: of another one.
  VarId RootOf(ExprId id) const {
    const auto& node = program_.exprs[id].node;
    if (const auto* ref = std::get_if<VarRef>(&node)) return ref->var;
    if (const auto* field = std::get_if<FieldRef>(&node)) return RootOf(field->base);
    if (const auto* swizzle = std::get_if<Swizzle>(&node)) return RootOf(swizzle->base);
    const auto* index = std::get_if<Index>(&node);
    return index && std::holds_alternative<Literal>(program_.exprs[index->index].node)
               ? RootOf(index->base)
               : VarId{};
  }

  // What a variable's own value reads of it does not count.
  void Count(ExprId id, VarId own, std::int32_t by) {
    if (!id) return;
    if (const auto* ref = std::get_if<VarRef>(&program_.exprs[id].node); ref && ref->var != own) {
      const std::int32_t reads = reads_[ref->var.index] += by;
      if (by < 0 && reads == 0 && lines_of_[ref->var.index] != 0) unread_.push_back(ref->var.index);
    }
    ForEachOperand(program_, id, [&](ExprId operand) { Count(operand, own, by); });
  }
  void CountAll(StmtId id) {
    if (const auto* declare = std::get_if<Declare>(&program_.stmts[id].node))
      ++reads_[declare->var.index];
    ForEachPart(
        program_, id, [&](ExprId expr) { Count(expr, {}, 1); },
        [&](StmtId part) { CountAll(part); });
  }

  Program& program_;
  std::vector<std::int32_t> reads_;  // by VarId; being changed counts where the change must stay
  std::vector<Line> lines_;          // the statements of main
  std::vector<std::uint32_t> lines_of_;  // by VarId: the last line that defines it, from 1
  std::vector<std::uint32_t> unread_;
};

}  // namespace

void DropUnread(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  ArgumentZeroer(program).Run();
  Dropper(program).Run();
}

}  // namespace clipc::passes
