// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// What `precise` reaches inside of a function: the variables whose values a precise one is computed
// from are precise too, as in GLSL (section 4.14 of the OpenGL Shading Language 4.60). The program
// says it of the variables of other functions.
#include "backend-spirv/writer.h"

namespace clipc::spirv {

using namespace ir;

void Writer::FindPrecise() {
  bool has_precise = false;
  for (const VarId id : program_.vars.ids()) {
    is_precise_var_[id.index] = (*this)[id].precise;
    has_precise = has_precise || (*this)[id].precise;
  }
  if (!has_precise) return;

  // By VarId: the variables that its values are read from.
  std::vector<std::vector<VarId>> sources(program_.vars.size());
  const auto add = [&](VarId target, ExprId value) {
    if (!target || !value) return;
    ForEachExpr(program_, value, [&](ExprId part) {
      if (const auto* ref = As<VarRef>(part)) sources[target.index].push_back(ref->var);
    });
  };
  for (const FunctionId id : functions_) {
    const StmtId body = program_.functions[id].body;
    ForEachExpr(program_, body, [&](ExprId expr) {
      if (const auto* assign = As<Assign>(expr))
        add(RootOf(program_, assign->target), assign->value);
    });
    ForEachStmt(program_, body, [&](StmtId stmt) {
      if (const auto* declare = As<Declare>(stmt)) add(declare->var, declare->init);
    });
  }
  std::vector<VarId> open;
  for (const VarId id : program_.vars.ids()) {
    if (is_precise_var_[id.index]) open.push_back(id);
  }
  while (!open.empty()) {
    const VarId target = open.back();
    open.pop_back();
    for (const VarId source : sources[target.index]) {
      if (is_precise_var_[source.index]) continue;
      is_precise_var_[source.index] = true;
      open.push_back(source);
    }
  }
}

}  // namespace clipc::spirv
