// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/spread_precise.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ir/access.h"
#include "ir/builder.h"
#include "ir/value_graph.h"

namespace clipc::passes {

using namespace ir;

namespace {

// The set of the types that have a precise field in them.
class PreciseTypes {
 public:
  explicit PreciseTypes(const TypeTable& types) : types_(types) {
    for (const StructId id : types.structs().ids())
      is_any_ |= std::ranges::any_of(types.structs()[id].fields, &Field::precise);
    if (is_any_) answers_.resize(types.size());
  }

  bool IsAny() const { return is_any_; }

  bool Has(TypeId id) {
    if (!is_any_) return false;
    std::optional<bool>& answer = answers_[id.index];
    if (!answer) answer = LookInto(id);
    return *answer;
  }

 private:
  bool LookInto(TypeId id) {
    const Type& type = types_[id];
    if (type.kind == TypeKind::kArray) return Has(type.element);
    return type.kind == TypeKind::kStruct &&
           std::ranges::any_of(types_.StructOf(id).fields, [&](const Field& field) {
             return field.precise || Has(field.type);
           });
  }

  const TypeTable& types_;
  bool is_any_ = false;
  std::vector<std::optional<bool>> answers_;  // by TypeId
};

bool IsOfFunctions(Storage storage) {
  return storage == Storage::kLocal || storage == Storage::kOut || storage == Storage::kInOut ||
         storage == Storage::kStatic;
}

// The change that makes the results of a function precise, and what `main` writes to a control
// point's precise outputs that GLSL has built in. GLSL as Mesa reads it takes no `precise` at a
// result, and has none at a member of gl_out, so each becomes a precise variable first.
class PreciseResults {
 public:
  PreciseResults(Program& program, FunctionId function)
      : program_(program), builder_(program, program.functions[function].span) {
    std::vector<StmtId> all;
    ForEachStmt(program, program.functions[function].body, [&](StmtId id) { all.push_back(id); });
    for (const StmtId id : all) {
      if (As<Block>(program, id)) InList(id);
    }
    for (const StmtId id : all) {
      if (StmtId declaration = DeclarationFor(id)) {
        const StmtId rest = program.stmts.Add(program.stmts[id]);
        program.stmts[id].node = Block{program.stmt_lists.Add({declaration, rest})};
      }
    }
  }

 private:
  void InList(StmtId id) {
    std::vector<StmtId> stmts;
    const List<StmtId> old = As<Block>(program_, id)->body;
    for (std::uint32_t i = 0; i < old.size; ++i) {
      const StmtId stmt = program_.stmt_lists[old][i];
      if (const StmtId declaration = DeclarationFor(stmt)) stmts.push_back(declaration);
      stmts.push_back(stmt);
    }
    if (stmts.size() > old.size)
      program_.stmts[id].node = Block{program_.stmt_lists.Add(std::span<const StmtId>(stmts))};
  }

  // Makes the variable that the statement returns precise. If the statement returns another
  // expression, makes it return a new precise variable, and returns the declaration of that
  // variable; otherwise returns none.
  StmtId DeclarationFor(StmtId stmt) {
    ExprId* const slot = ValueOf(stmt);
    if (!slot || !*slot) return {};
    const ExprId value = *slot;
    const auto* ref = As<VarRef>(program_, value);
    if (ref && program_.vars[ref->var].storage == Storage::kLocal) {
      program_.vars[ref->var].precise = true;
      return {};
    }
    const VarId local = builder_.Local("result", TypeIdOf(program_, value));
    program_.vars[local].precise = true;
    const ExprId read = builder_.Ref(local);
    *ValueOf(stmt) = read;
    return builder_.Stmt(Declare{local, value});
  }

  // The value that the statement returns or writes; null for every other statement.
  ExprId* ValueOf(StmtId stmt) {
    if (auto* result = std::get_if<Return>(&program_.stmts[stmt].node)) return &result->value;
    const Assign* assign = AsAssignment(program_, stmt);
    const auto* target = assign ? As<VarRef>(program_, assign->target) : nullptr;
    const bool is_precise =
        target && std::ranges::any_of(program_.outputs, [&](const IoVar& output) {
          return output.var == target->var && output.builtin != Builtin::kNone &&
                 program_.vars[output.var].precise;
        });
    return is_precise ? &const_cast<Assign*>(assign)->value : nullptr;
  }

  Program& program_;
  Builder builder_;
};

}  // namespace

void SpreadPrecise(Program& program, bool of_all_outputs) {
  for (const IoVar& output : program.outputs) program.vars[output.var].precise |= of_all_outputs;
  PreciseTypes types(program.types);
  if (!types.IsAny() && !program.vars.AnyOf([](const Var& var) { return var.precise; }) &&
      !program.functions.AnyOf([](const Function& function) { return function.precise; }))
    return;
  bool is_any = false;
  for (const VarId id : program.vars.ids()) {
    Var& var = program.vars[id];
    var.precise |= IsOfFunctions(var.storage) && types.Has(var.type);
    is_any |= var.precise;
  }
  for (const FunctionId id : program.functions.ids()) {
    Function& function = program.functions[id];
    function.precise |= types.Has(function.return_type);
    is_any |= function.precise;
  }
  if (!is_any) return;

  const ValueGraph graph(program);
  std::vector<bool> precise(program.vars.size() + program.functions.size());
  for (const VarId id : program.vars.ids()) precise[graph.NodeOf(id)] = program.vars[id].precise;
  for (const FunctionId id : program.functions.ids())
    precise[graph.NodeOf(id)] = program.functions[id].precise;
  graph.SpreadToSources(precise);
  for (const FunctionId id : program.functions.ids()) {
    for (const VarId parameter : program.functions[id].parameters) {
      Var& var = program.vars[parameter];
      var.precise = precise[graph.NodeOf(parameter)] && var.storage != Storage::kIn;
    }
    if (precise[graph.NodeOf(id)]) PreciseResults(program, id);
  }
  if (InfoOf(program.stage).makes_patches) PreciseResults(program, program.main);
}

}  // namespace clipc::passes
