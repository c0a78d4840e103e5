// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/reread.h"

#include <variant>

namespace clipc {
namespace {

bool IsPlainPath(const ir::Program& program, ir::ExprId expr, int depth) {
  constexpr int kMaxDepth = 8;
  if (depth > kMaxDepth) return false;
  const auto& node = program.exprs[expr].node;
  if (std::holds_alternative<ir::VarRef>(node) || std::holds_alternative<ir::Literal>(node))
    return true;
  if (const auto* field = std::get_if<ir::FieldRef>(&node))
    return IsPlainPath(program, field->base, depth + 1);
  if (const auto* swizzle = std::get_if<ir::Swizzle>(&node))
    return IsPlainPath(program, swizzle->base, depth + 1);
  if (const auto* index = std::get_if<ir::Index>(&node)) {
    const auto& inner = program.exprs[index->index].node;
    const bool is_simple =
        std::holds_alternative<ir::VarRef>(inner) || std::holds_alternative<ir::Literal>(inner);
    return is_simple && IsPlainPath(program, index->base, depth + 1);
  }
  return false;
}

}  // namespace

bool IsPlainPath(const ir::Program& program, ir::ExprId expr) {
  return IsPlainPath(program, expr, 0);
}

Reread::Reread(ir::Program& program, ir::ExprId value, TemporaryMaker* temporaries)
    : program_(program), builder_(program, program.exprs[value].span), value_(value) {
  if (clipc::IsPlainPath(program, value)) return;
  if (temporaries == nullptr) {
    usable_ = false;
    return;
  }
  const auto temporary = temporaries->Make(value);
  temporary_ = temporary.var;
  prologue_ = temporary.prologue;
}

ir::ExprId Reread::Read() {
  return temporary_ ? builder_.Ref(temporary_) : Clone(program_, value_);
}

ir::ExprId Reread::Finish(ir::ExprId result) {
  return prologue_ ? builder_.CommaOf(prologue_, result) : result;
}

}  // namespace clipc
