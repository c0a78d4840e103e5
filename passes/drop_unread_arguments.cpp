// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/drop_unread_arguments.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::passes {

using namespace ir;

namespace {

// The reads of one parameter in the entry function: all of them, and those of one field each.
struct Reads {
  std::uint32_t all = 0, of_fields = 0;
  std::set<std::uint32_t> fields;

  bool HasWhole() const { return all != of_fields; }
};

std::vector<Reads> ReadsOfParameters(const Program& program) {
  const Function& entry = program.functions[program.entry];
  std::vector<Reads> reads(entry.parameters.size());
  const auto reads_of = [&](ExprId id) {
    const auto* ref = As<VarRef>(program, id);
    const auto found = ref ? std::ranges::find(entry.parameters, ref->var) : entry.parameters.end();
    return found == entry.parameters.end() ? nullptr : &reads[found - entry.parameters.begin()];
  };
  ForEachExpr(program, entry.body, [&](ExprId id) {
    if (Reads* parameter = reads_of(id)) ++parameter->all;
    const auto* field = As<FieldRef>(program, id);
    Reads* base = field ? reads_of(field->base) : nullptr;
    if (!base) return;
    ++base->of_fields;
    base->fields.insert(field->field);
  });
  return reads;
}

void MakeZero(Program& program, List<ExprId> list, std::uint32_t i) {
  const ExprId value = program.expr_lists[list][i];
  if (!IsPure(program, value)) return;
  const ExprId zero = Builder(program, program.exprs[value].span).ZeroOf(program.exprs[value].type);
  program.expr_lists[list][i] = zero;
}

// Makes zero the inputs for fields that the function does not read, if the argument is a variable
// that is made of the inputs for this call alone: `Vertex v = Vertex(in_POSITION0, in_NORMAL0);`.
void MakeFieldsZero(Program& program, ExprId argument, const std::set<std::uint32_t>& read) {
  const auto* ref = As<VarRef>(program, argument);
  if (!ref) return;
  for (const StmtId id : MainBody(program)) {
    const auto* declare = As<Declare>(program, id);
    if (!declare || declare->var != ref->var) continue;
    const auto* construct = As<Construct>(program, declare->init);
    for (std::uint32_t i = 0; construct && i < construct->arguments.size; ++i) {
      if (!read.contains(i)) MakeZero(program, construct->arguments, i);
    }
  }
}

// The fields of a struct that functions read, also in others that get it as an argument.
class FieldsRead {
 public:
  explicit FieldsRead(const Program& program) : program_(program) {}

  // The fields of `var` that the statement and the functions that it calls read, also of copies;
  // null: all.
  const std::set<std::uint32_t>* Of(StmtId body, VarId var, int depth = 0) {
    const auto [known, is_new] = known_.try_emplace(var.index);
    if (!is_new) return known->second ? &*known->second : nullptr;
    if (depth > kMaxDepth) return nullptr;
    std::set<std::uint32_t> fields;
    std::uint32_t all = 0, of_parts = 0;
    const auto is_var = [&](ExprId id) {
      const auto* ref = As<VarRef>(program_, id);
      return ref && ref->var == var;
    };
    // Counts a read of all as one of the fields that are read of the variable that it is given to.
    const auto pass_on = [&](StmtId to_body, VarId to) {
      const auto* inner = Of(to_body, to, depth + 1);
      if (!inner) return;
      ++of_parts;
      fields.insert(inner->begin(), inner->end());
    };
    ForEachStmt(program_, body, [&](StmtId id) {
      const auto* declare = As<Declare>(program_, id);
      if (declare && declare->init && is_var(declare->init)) pass_on(body, declare->var);
    });
    ForEachExpr(program_, body, [&](ExprId id) {
      if (is_var(id)) ++all;
      if (const auto* field = As<FieldRef>(program_, id); field && is_var(field->base)) {
        ++of_parts;
        fields.insert(field->field);
      }
      const auto* call = As<Call>(program_, id);
      for (std::uint32_t i = 0; call && i < call->arguments.size; ++i) {
        if (!is_var(program_.expr_lists[call->arguments][i])) continue;
        const Function& callee = program_.functions[call->function];
        const VarId parameter = callee.parameters[i];
        if (program_.vars[parameter].storage != Storage::kOut) pass_on(callee.body, parameter);
      }
    });
    auto& result = known_[var.index];
    if (all == of_parts) result = std::move(fields);
    return result ? &*result : nullptr;
  }

 private:
  static constexpr int kMaxDepth = 32;

  const Program& program_;
  std::map<std::uint32_t, std::optional<std::set<std::uint32_t>>> known_;  // by VarId
};

// Makes zero the inputs that no target has, `POSITION` of a pixel shader of Direct3D 9, where a
// struct carries them to functions and copies that do not read them. fxc, which inlines functions,
// takes such a shader.
void DropUntranslated(Program& program) {
  const auto is_untranslated = [&](ExprId id) {
    const auto* ref = As<VarRef>(program, id);
    return ref && std::ranges::any_of(program.inputs, [&](const IoVar& input) {
             return input.builtin == Builtin::kUntranslated && input.var == ref->var;
           });
  };
  FieldsRead read(program);
  for (const StmtId id : MainBody(program)) {
    const auto* declare = As<Declare>(program, id);
    const auto* construct = declare ? As<Construct>(program, declare->init) : nullptr;
    for (std::uint32_t i = 0; construct && i < construct->arguments.size; ++i) {
      if (!is_untranslated(program.expr_lists[construct->arguments][i])) continue;
      const auto* fields = read.Of(program.functions[program.main].body, declare->var);
      if (fields && !fields->contains(i)) MakeZero(program, construct->arguments, i);
    }
  }
}

}  // namespace

void DropUnreadArguments(Program& program) {
  CLIPC_CHECK(program.form == Form::kInlined);
  const auto is_untranslated = [](const IoVar& input) {
    return input.builtin == Builtin::kUntranslated;
  };
  if (std::ranges::any_of(program.inputs, is_untranslated)) DropUntranslated(program);
  ExprId call;
  for (const StmtId id : MainBody(program)) {
    if (!call) call = EntryCall(program, id);
  }
  if (!call) return;
  const List<ExprId> arguments = As<Call>(program, call)->arguments;
  const std::vector<VarId>& parameters = program.functions[program.entry].parameters;
  const std::vector<Reads> reads = ReadsOfParameters(program);
  for (std::uint32_t i = 0; i < arguments.size; ++i) {
    if (program.vars[parameters[i]].storage != Storage::kIn || reads[i].HasWhole()) continue;
    if (reads[i].fields.empty())
      MakeZero(program, arguments, i);
    else
      MakeFieldsZero(program, program.expr_lists[arguments][i], reads[i].fields);
  }
}

}  // namespace clipc::passes
