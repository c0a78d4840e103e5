// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/es100/elements.h"

#include <vector>

#include "ir/counted_loop.h"
#include "ir/walk.h"
#include "legalize/es100/lower_to_es100.h"

namespace clipc::legalize {

using namespace ir;

namespace {

bool IsOfObjects(const Program& program, ExprId expr) {
  const TypeId innermost = program.types.Innermost(program.exprs[expr].type);
  return program.types[innermost].kind == TypeKind::kObject;
}

// a[i]  =>  element(a, i)
void LowerRead(Legalizer& legalizer, const Elements& elements, ExprId expr) {
  Program& program = legalizer.program;
  const std::uint32_t count = elements.CountOf(expr);
  if (count == 0 || IsOfObjects(program, expr)) return;
  const Index node = *As<Index>(program, expr);
  const Parameter parameters[] = {{"a", program.exprs[node.base].type},
                                  {"i", program.exprs[node.index].type}};
  const ExprId arguments[] = {node.base, node.index};
  legalizer.BecomeCall(expr, "element", parameters, arguments, [&](HelperBody& body) {
    for (std::uint32_t k = 0; k < count; ++k) {
      const StmtId found = body.b.Stmt(Return{body.b.At(body[0], k)});
      body.Add(k + 1 < count ? body.b.Stmt(If{IsElement(program, body, 1, k), found, {}}) : found);
    }
  });
}

}  // namespace

Elements::Elements(const Legalizer& legalizer) : legalizer_(legalizer) {
  const Program& program = legalizer.program;
  for (const FunctionId id : program.functions.ids()) {
    ForEachStmt(program, program.functions[id].body, [&](StmtId stmt) {
      if (const auto* loop = As<For>(program, stmt))
        loop_indices_.insert(PartsOf(program, *loop).counter);
    });
  }
}

std::uint32_t Elements::CountOf(ExprId expr) const {
  const auto* index = As<Index>(legalizer_.program, expr);
  if (!index || As<Literal>(legalizer_.program, index->index)) return 0;
  const Type& type = TypeOf(legalizer_.program, index->base);
  const auto* ref = As<VarRef>(legalizer_.program, index->base);
  const bool is_constant = IsOfLoops(index->index);
  switch (type.kind) {
    case TypeKind::kArray:
      return ref && legalizer_.program.vars[ref->var].storage == Storage::kUniform ? 0 : type.count;
    case TypeKind::kVector: return type.columns > 1 && !is_constant ? type.columns : 0;
    case TypeKind::kMatrix: {
      const bool has_fields = ShapeOf(type, legalizer_.needs).kind == Shape::kRows;
      return type.rows > 1 && (has_fields || !is_constant) ? type.rows : 0;
    }
    default: return 0;
  }
}

// Whether the index is a constant-index-expression: one of constants and the indices of loops.
bool Elements::IsOfLoops(ExprId expr) const {
  if (As<Literal>(legalizer_.program, expr)) return true;
  if (const auto* ref = As<VarRef>(legalizer_.program, expr))
    return loop_indices_.contains(ref->var);
  if (const auto* convert = As<Convert>(legalizer_.program, expr))
    return IsInteger(TypeOf(legalizer_.program, convert->operand).scalar) &&
           IsOfLoops(convert->operand);
  const auto* sum = As<Binary>(legalizer_.program, expr);
  return sum && (sum->op == BinaryOp::kAdd || sum->op == BinaryOp::kSub) && IsOfLoops(sum->left) &&
         IsOfLoops(sum->right);
}

ExprId IsElement(const Program& program, HelperBody& body, std::size_t i, std::uint32_t k) {
  const TypeId type = program.vars[body.parameters[i]].type;
  const ExprId number = body.b.LiteralOf(program.types[type].scalar, k);
  return body.b.BinaryOf(BinaryOp::kEqual, body[i], number);
}

void LowerElements(Legalizer& legalizer) {
  if (!legalizer.needs.constant_indices) return;
  Program& program = legalizer.program;
  const Elements elements(legalizer);
  LowerElementCalls(legalizer, elements);
  std::vector<ExprId> all;
  ForEachLiveExpr(program, [&](ExprId expr) { all.push_back(expr); });
  // A helper function may itself write an element.
  for (std::size_t done = 0, function = program.functions.size(); done < all.size();) {
    // Writes are lowered first: a target is not a value.
    for (std::size_t i = done; i < all.size(); ++i) LowerElementWrite(legalizer, elements, all[i]);
    for (; done < all.size(); ++done) LowerRead(legalizer, elements, all[done]);
    for (; function < program.functions.size(); ++function) {
      const FunctionId id{static_cast<std::uint32_t>(function)};
      ForEachExpr(program, program.functions[id].body, [&](ExprId expr) { all.push_back(expr); });
    }
  }
}

}  // namespace clipc::legalize
