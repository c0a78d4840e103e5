// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "legalize/word_buffers.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <span>
#include <utility>

#include "ir/access.h"
#include "ir/walk.h"

namespace clipc::legalize {

using namespace ir;

namespace {

ObjectKind KindOfWords(ObjectKind kind) {
  switch (kind) {
    case ObjectKind::kByteAddressBuffer: return ObjectKind::kStructuredBuffer;
    case ObjectKind::kRWByteAddressBuffer: return ObjectKind::kRWStructuredBuffer;
    case ObjectKind::kOrderedByteAddressBuffer: return ObjectKind::kOrderedStructuredBuffer;
    default: return kind;
  }
}

void BecomeWords(Program& program, Resource& resource) {
  TypeTable& types = program.types;
  const TypeId declared = program.vars[resource.var].type;
  std::vector<std::uint32_t> counts;
  for (TypeId type = declared; types[type].kind == TypeKind::kArray; type = types[type].element)
    counts.push_back(types[type].count);
  const ObjectKind kind = KindOfWords(types[types.Innermost(declared)].object);
  TypeId words = types.Object(kind, types.Make(Scalar::kUint));
  for (auto count = counts.rbegin(); count != counts.rend(); ++count)
    words = types.Array(words, *count);
  resource.declared_type = declared;
  program.vars[resource.var].type = words;
}

}  // namespace

void Retype(Program& program, ExprId path) {
  if (const auto* index = As<Index>(program, path)) {
    Retype(program, index->base);
    program.exprs[path].type = program.types[program.exprs[index->base].type].element;
  } else if (const auto* ref = As<VarRef>(program, path)) {
    program.exprs[path].type = program.vars[ref->var].type;
  }
}

std::set<VarId> BuffersOfExchangedFloats(const Program& program) {
  std::set<VarId> buffers;
  const auto changes_float = [&](const ObjectCall& call) {
    if (!IsAtomic(call.op)) return false;
    const ExprId value = OperandOf(program, call, OperandKind::kValue);
    return value && BaseOf(TypeOf(program, value).scalar) == Scalar::kFloat &&
           IsStructured(TypeOf(program, OperandOf(program, call, OperandKind::kObject)).object);
  };
  if (!MayHaveExpr<ObjectCall>(program, changes_float)) return buffers;
  ForEachLiveExpr(program, [&](ExprId expr) {
    const auto* call = As<ObjectCall>(program, expr);
    if (call && changes_float(*call))
      buffers.insert(RootOf(program, OperandOf(program, *call, OperandKind::kObject)));
  });
  return buffers;
}

std::set<ExprId> ExpressionsAlone(const Program& program) {
  std::set<ExprId> alone;
  for (const StmtId stmt : program.stmts.ids()) {
    if (const auto* statement = As<Evaluate>(program, stmt)) alone.insert(statement->expr);
  }
  return alone;
}

void MakeWordBuffers(
    Legalizer& legalizer, const std::function<bool(const Resource& resource)>& chosen,
    const std::function<void(ExprId expr, const ObjectCall& call, VarId buffer)>& lower) {
  Program& program = legalizer.program;
  std::set<VarId> buffers;
  for (Resource& resource : program.resources) {
    if (!chosen(resource)) continue;
    BecomeWords(program, resource);
    buffers.insert(resource.var);
  }
  if (buffers.empty()) return;
  std::vector<ExprId> paths, calls;
  ForEachLiveExpr(program, [&](ExprId expr) {
    const VarId root = RootOf(program, expr);
    if (root && buffers.contains(root)) paths.push_back(expr);
    if (As<ObjectCall>(program, expr)) calls.push_back(expr);
  });
  for (const ExprId path : paths) Retype(program, path);
  for (const ExprId expr : calls) {
    const ObjectCall call = *As<ObjectCall>(program, expr);
    const VarId buffer = RootOf(program, OperandOf(program, call, OperandKind::kObject));
    if (buffer && buffers.contains(buffer)) lower(expr, call, buffer);
  }
}

AccessorCall::AccessorCall(Legalizer& legalizer, ExprId expr, const ObjectCall& call)
    : legalizer_(legalizer), expr_(expr) {
  Program& program = legalizer.program;
  const ExprId object = OperandOf(program, call, OperandKind::kObject);
  buffer_ = RootOf(program, object);
  const auto* element = As<Index>(program, object);
  if (!element) return;
  is_element_ = true;
  const auto* mark = As<IntrinsicCall>(program, element->index);
  is_marked_ = mark && mark->op == CommonIntrinsic::kNonUniform;
  if (is_marked_)  // a uint
    Pass("which", std::as_const(program).expr_lists[mark->arguments][0]);
  else
    PassInt("which", element->index);
}

void AccessorCall::Pass(std::string_view name, ExprId argument) {
  arguments_.push_back(argument);
  parameters_.push_back({name, legalizer_.program.exprs[argument].type});
}

void AccessorCall::PassInt(std::string_view name, ExprId argument) {
  const auto* number = As<Literal>(legalizer_.program, argument);
  Builder b = legalizer_.At(expr_);
  Pass(name, number ? b.Int(static_cast<std::int32_t>(number->bits))
                    : b.ConvertTo(Scalar::kInt, argument));
}

std::string AccessorCall::Name() const {
  return legalizer_.program.vars[buffer_].name + (is_marked_ ? "_any" : "");
}

ExprId AccessorCall::Object(HelperBody& body) const {
  const ExprId whole = body.b.Ref(buffer_);
  if (!is_element_) return whole;
  ExprId which = body[0];
  if (is_marked_)
    which = body.b.IntrinsicOf(CommonIntrinsic::kNonUniform, body.b.TypeOf(which), {which});
  return body.b.At(whole, which);
}

ExprId AccessorCall::Load(HelperBody& body, ExprId number) const {
  return body.b.ObjectCallOf(ObjectOp::kStructuredLoad, body.program.types.Make(Scalar::kUint),
                             {{OperandKind::kObject, Object(body)}, {OperandKind::kPlace, number}});
}

void AccessorCall::Store(HelperBody& body, ExprId number, ExprId word) const {
  body.Do(body.b.ObjectCallOf(ObjectOp::kStore, body.program.types.Void(),
                              {{OperandKind::kObject, Object(body)},
                               {OperandKind::kPlace, number},
                               {OperandKind::kValue, word}}));
}

ExprId AccessorCall::CompareExchange(HelperBody& body, ExprId number, ExprId comparand,
                                     ExprId word) const {
  return body.b.ObjectCallOf(ObjectOp::kAtomicCompareExchange,
                             body.program.types.Make(Scalar::kUint),
                             {{OperandKind::kObject, Object(body)},
                              {OperandKind::kPlace, number},
                              {OperandKind::kComparand, comparand},
                              {OperandKind::kValue, word}});
}

void AccessorCall::Become(FunctionId& function, std::string_view name, TypeId result,
                          const Define& define) {
  Program& program = legalizer_.program;
  if (!function) {
    function = AddHelper(program, name, parameters_, result, define);
    program.functions[function].is_accessor = true;
  }
  program.exprs[expr_].node =
      Call{function, program.expr_lists.Add(std::span<const ExprId>(arguments_))};
}

}  // namespace clipc::legalize
