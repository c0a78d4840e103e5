// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/typing/reread.h"

#include "ir/access.h"

namespace clipc::typing {
namespace {

bool IsSimple(const Program& program, ExprId expr) {
  return As<VarRef>(program, expr) || As<Literal>(program, expr);
}

bool IsPlainPath(const Program& program, ExprId expr, int depth) {
  constexpr int kMaxDepth = 8;
  if (depth > kMaxDepth) return false;
  if (IsSimple(program, expr)) return true;
  if (As<MatrixSwizzle>(program, expr)) return false;
  const auto* index = As<Index>(program, expr);
  const ExprId whole = WholeOf(program, expr);
  return whole && (!index || IsSimple(program, index->index)) &&
         IsPlainPath(program, whole, depth + 1);
}

}  // namespace

bool IsPlainPath(const Program& program, ExprId expr) { return IsPlainPath(program, expr, 0); }

Reread::Reread(Program& program, ExprId value, TemporaryMaker* temporaries)
    : program_(program), builder_(program, program.exprs[value].span), value_(value) {
  if (typing::IsPlainPath(program, value)) return;
  if (temporaries == nullptr) {
    usable_ = false;
    return;
  }
  const auto temporary = temporaries->Make(value);
  temporary_ = temporary.var;
  prologue_ = temporary.prologue;
}

ExprId Reread::Read() { return temporary_ ? builder_.Ref(temporary_) : Clone(program_, value_); }

ExprId Reread::Finish(ExprId result) {
  return prologue_ ? builder_.CommaOf(prologue_, result) : result;
}

}  // namespace clipc::typing
