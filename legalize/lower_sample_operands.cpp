// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdint>
#include <vector>

#include "base/operators.h"
#include "ir/access.h"
#include "ir/evaluate.h"
#include "ir/walk.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

// Whether the expression has a choice in it, of which one side alone is evaluated.
bool HasChoice(const Program& program, ExprId expr) {
  return AnyExpr(program, expr, [&](ExprId part) {
    const auto* binary = As<Binary>(program, part);
    return As<Conditional>(program, part) || (binary && IsLogical(binary->op));
  });
}

// Puts the operands of the call of a texture and sampler, from the first one to the last one with a
// choice, into variables. Appends their declarations.
void LowerCall(Legalizer& legalizer, ExprId expr, std::vector<StmtId>& declares) {
  Program& program = legalizer.program;
  const ObjectCall call = *As<ObjectCall>(program, expr);
  const List<ExprId> operands = call.arguments;
  const std::uint32_t first = OperandsOf(call, OperandKind::kCoordinate).begin - operands.begin;
  std::uint32_t end = 0;
  for (std::uint32_t i = first; i < operands.size; ++i) {
    if (HasChoice(program, program.expr_lists[operands][i])) end = i + 1;
  }
  if (end == 0) return;
  Builder b = legalizer.At(expr);
  const TypeId type = program.exprs[expr].type;
  const ExprId rest = b.Add(type, call);
  ExprId whole = rest;
  for (std::uint32_t i = end; i-- > first;) {
    const ExprId value = program.expr_lists[operands][i];
    if (const auto bits = ConstantBits(program, value)) {  // an offset must stay constant
      if (HasChoice(program, value))
        legalizer.Become(value, b.ValueOf(program.exprs[value].type, *bits));
      continue;
    }
    const VarId held = b.Local("operand", program.exprs[value].type);
    declares.push_back(b.Stmt(Declare{held, {}}));
    program.expr_lists[operands][i] = b.Ref(held);
    whole = b.CommaOf(b.AssignTo(b.Ref(held), value), whole);
  }
  if (whole != rest) legalizer.Become(expr, whole);
}

}  // namespace

void LowerSampleOperands(Legalizer& legalizer) {
  Program& program = legalizer.program;
  if (!legalizer.needs.simple_operands || !program.calls_objects) return;
  for (const FunctionId id : program.functions.ids()) {
    std::vector<ExprId> calls;
    ForEachExpr(program, program.functions[id].body, [&](ExprId expr) {
      const auto* call = As<ObjectCall>(program, expr);
      if (call && Takes(call->op, OperandKind::kSampler)) calls.push_back(expr);
    });
    std::vector<StmtId> body;
    for (const ExprId call : calls) LowerCall(legalizer, call, body);
    if (body.empty()) continue;
    const auto rest = BodyOf(program, id);
    body.insert(body.end(), rest.begin(), rest.end());
    program.functions[id].body = Builder(program).BlockOf(body);
  }
}

}  // namespace clipc::legalize
