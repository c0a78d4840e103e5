// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "ir/shared_memory.h"

#include <algorithm>

#include "ir/access.h"

namespace clipc::ir {
namespace {

std::uint64_t BytesOf(const TypeTable& types, TypeId id) {
  const Type& type = types[id];
  if (type.kind == TypeKind::kArray) return type.count * BytesOf(types, type.element);
  if (type.kind != TypeKind::kStruct)
    return std::uint64_t{type.Components()} * ByteSize(type.scalar);
  std::uint64_t bytes = 0;
  for (const Field& field : types.StructOf(id).fields) bytes += BytesOf(types, field.type);
  return bytes;
}

}  // namespace

std::uint64_t SharedBytes(const Program& program) {
  std::uint64_t bytes = 0;
  for (const VarId global : program.globals) {
    const Var& var = program.vars[global];
    if (var.storage == Storage::kShared) bytes += BytesOf(program.types, var.type);
  }
  return bytes;
}

std::set<VarId> ExchangedFloats(const Program& program) {
  std::set<VarId> shared;
  const auto changes_float = [&](const IntrinsicCall& call) {
    return CategoryOf(call.op) == IntrinsicCategory::kAtomic &&
           IsFloat(TypeOf(program, program.expr_lists[call.arguments][0]).scalar);
  };
  if (!MayHaveExpr<IntrinsicCall>(program, changes_float)) return shared;
  ForEachLiveExpr(program, [&](ExprId expr) {
    const auto* call = As<IntrinsicCall>(program, expr);
    if (call && changes_float(*call))
      shared.insert(RootOf(program, program.expr_lists[call->arguments][0]));
  });
  return shared;
}

}  // namespace clipc::ir
