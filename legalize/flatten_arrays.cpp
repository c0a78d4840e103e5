// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "ir/access.h"
#include "ir/walk.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

class Flattener {
 public:
  explicit Flattener(Program& program) : program_(program) {}

  void Run() {
    for (const Resource& resource : program_.resources) {
      const TypeId type = program_.vars[resource.var].type;
      const Type& array = program_.types[type];
      if (array.kind == TypeKind::kArray && program_.types[array.element].kind == TypeKind::kArray)
        flat_.emplace(resource.var, type);
    }
    if (flat_.empty()) return;
    std::vector<ExprId> elements, arrays;
    ForEachLiveExpr(program_, [&](ExprId expr) {
      const VarId root = RootOf(program_, expr);
      if (!root || !flat_.contains(root)) return;
      if (As<VarRef>(program_, expr)) arrays.push_back(expr);
      if (TypeOf(program_, expr).kind == TypeKind::kObject) elements.push_back(expr);
    });
    for (const ExprId element : elements) Number(element);
    for (auto& [var, type] : flat_) {
      std::uint32_t count = 1;
      TypeId element = type;
      for (; program_.types[element].kind == TypeKind::kArray;
           element = program_.types[element].element)
        count *= program_.types[element].count;
      type = program_.types.Array(element, count);
      program_.vars[var].type = type;
    }
    for (const ExprId array : arrays)
      program_.exprs[array].type = program_.vars[As<VarRef>(program_, array)->var].type;
  }

 private:
  // Replaces the indices of an element by its number.
  void Number(ExprId element) {
    Builder at(program_, program_.exprs[element].span);
    ExprId number, path = element;
    std::uint32_t stride = 1;
    bool may_differ = false;
    while (const auto* step = As<Index>(program_, path)) {
      const auto [base, index] = *step;
      ExprId part = index;
      const auto* mark = As<IntrinsicCall>(program_, index);
      if (mark && mark->op == CommonIntrinsic::kNonUniform) {
        may_differ = true;
        part = program_.expr_lists[mark->arguments][0];
      }
      const auto* literal = As<Literal>(program_, part);
      const auto* known = As<Literal>(program_, number);
      const auto count = static_cast<std::uint32_t>(literal ? literal->bits : 0) * stride;
      if (literal && known) {
        number = at.Uint(static_cast<std::uint32_t>(known->bits) + count);
      } else {
        part = literal       ? at.Uint(count)
               : stride == 1 ? at.ConvertTo(Scalar::kUint, part)
                             : at.BinaryOf(BinaryOp::kMul, at.ConvertTo(Scalar::kUint, part),
                                           at.Uint(stride));
        number = !number || (known && known->bits == 0) ? part
                 : literal && count == 0                ? number
                                                        : at.BinaryOf(BinaryOp::kAdd, part, number);
      }
      stride *= TypeOf(program_, base).count;
      path = base;
    }
    if (may_differ)
      number = at.IntrinsicOf(CommonIntrinsic::kNonUniform, program_.types.Make(Scalar::kUint),
                              {number});
    program_.exprs[element].node = Index{path, number};
  }

  Program& program_;
  std::map<VarId, TypeId> flat_;  // by variable: its type
};

}  // namespace

void FlattenArrays(Legalizer& legalizer) {
  if (legalizer.needs.flat_arrays) Flattener(legalizer.program).Run();
}

}  // namespace clipc::legalize
