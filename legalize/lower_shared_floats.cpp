// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <set>
#include <utility>
#include <vector>

#include "ir/shared_memory.h"
#include "legalize/legalize.h"
#include "legalize/word_buffers.h"

namespace clipc::legalize {

using namespace ir;

namespace {

class SharedFloatLowering {
 public:
  SharedFloatLowering(Legalizer& legalizer, const std::set<VarId>& shared)
      : legalizer_(legalizer),
        program_(legalizer.program),
        shared_(shared),
        word_(program_.types.Make(Scalar::kUint)),
        alone_(ExpressionsAlone(program_)) {}

  void Lower() {
    std::vector<ExprId> paths, writes;
    std::set<ExprId> places;
    ForEachLiveExpr(program_, [&](ExprId expr) {
      if (IsShared(expr)) paths.push_back(expr);
      const ExprId place = PlaceWritten(expr);
      if (!place || !IsShared(place)) return;
      writes.push_back(expr);
      places.insert(place);
    });
    for (const VarId var : shared_) program_.vars[var].type = OfWords(program_.vars[var].type);
    for (const ExprId path : paths) Retype(program_, path);
    for (const ExprId path : paths) {
      if (legalizer_.TypeOf(path).kind == TypeKind::kScalar && !places.contains(path))
        GiveFloat(path);
    }
    for (const ExprId write : writes) WriteWords(write);
  }

 private:
  bool IsShared(ExprId expr) const {
    const VarId root = RootOf(program_, expr);
    return root && shared_.contains(root);
  }

  // What an assignment or an atomic operation changes; none for another expression.
  ExprId PlaceWritten(ExprId expr) const {
    if (const auto* assign = As<Assign>(program_, expr)) return assign->target;
    const auto* call = As<IntrinsicCall>(program_, expr);
    const bool is_atomic = call && CategoryOf(call->op) == IntrinsicCategory::kAtomic;
    return is_atomic ? std::as_const(program_).expr_lists[call->arguments][0] : ExprId{};
  }

  TypeId OfWords(TypeId type) {
    TypeTable& types = program_.types;
    if (types[type].kind != TypeKind::kArray) return word_;
    const std::uint32_t count = types[type].count;
    return types.Array(OfWords(types[type].element), count);
  }

  ExprId WordOf(ExprId value) {
    return legalizer_.At(value).IntrinsicOf(CommonIntrinsic::kAsUint, word_, {value});
  }

  // Makes the expression, whose node gives a word, the float of that word.
  void GiveFloat(ExprId expr) {
    Builder b = legalizer_.At(expr);
    const TypeId type = program_.types.Make(Scalar::kFloat);
    const ExprId word = b.Add(word_, program_.exprs[expr].node);
    program_.exprs[expr].type = type;
    legalizer_.Become(expr, b.IntrinsicOf(CommonIntrinsic::kAsFloat, type, {word}));
  }

  void WriteWords(ExprId expr) {
    if (const auto* assign = As<Assign>(program_, expr)) {
      const ExprId value = WordOf(assign->value);
      std::get<Assign>(program_.exprs[expr].node).value = value;
    } else {
      const List<ExprId> arguments = As<IntrinsicCall>(program_, expr)->arguments;
      for (std::uint32_t i = 1; i < arguments.size; ++i) {
        const ExprId value = WordOf(std::as_const(program_).expr_lists[arguments][i]);
        program_.expr_lists[arguments][i] = value;
      }
    }
    program_.exprs[expr].type = word_;
    if (!alone_.contains(expr)) GiveFloat(expr);
  }

  Legalizer& legalizer_;
  Program& program_;
  const std::set<VarId>& shared_;
  const TypeId word_;
  const std::set<ExprId> alone_;
};

}  // namespace

void LowerSharedFloats(Legalizer& legalizer) {
  const std::set<VarId> shared = ExchangedFloats(legalizer.program);
  if (!shared.empty()) SharedFloatLowering(legalizer, shared).Lower();
}

}  // namespace clipc::legalize
