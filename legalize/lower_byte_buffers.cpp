// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/intrinsic_list.h"
#include "legalize/formula.h"
#include "legalize/legalize.h"
#include "legalize/word_buffers.h"

namespace clipc::legalize {

using namespace ir;

namespace {

constexpr std::uint32_t kWord = 4;  // bytes

class ByteBufferLowering {
 public:
  explicit ByteBufferLowering(Legalizer& legalizer)
      : legalizer_(legalizer), program_(legalizer.program) {}

  void Lower(ExprId expr, const ObjectCall& call, VarId buffer) {
    Builder b = legalizer_.At(expr);
    if (call.op == ObjectOp::kByteLoad || call.op == ObjectOp::kStore)
      return BecomeAccess(expr, call, buffer);
    if (call.op == ObjectOp::kBufferSize) {
      const ExprId words = b.Add(program_.exprs[expr].type, call);
      const ExprId bytes = b.LiteralOf(legalizer_.TypeOf(expr).scalar, kWord);
      return legalizer_.Become(expr, b.BinaryOf(BinaryOp::kMul, words, bytes));
    }
    const bool compares_sizes = call.op == ObjectOp::kAtomicMin || call.op == ObjectOp::kAtomicMax;
    if (compares_sizes && legalizer_.needs.signed_words &&
        legalizer_.TypeOf(expr).scalar == Scalar::kInt)
      return BecomeChange(expr, call, buffer);
    // An atomic operation has the address of a word.
    const std::uint32_t place = OperandsOf(call, OperandKind::kPlace).begin;
    const List<ExprId> list{place, 1};
    const ExprId address = std::as_const(program_).expr_lists[list][0];
    program_.expr_lists[list][0] = b.BinaryOf(BinaryOp::kDiv, address, b.Uint(kWord));
  }

 private:
  // Makes the load or the store a call of a function of the buffer.
  void BecomeAccess(ExprId expr, const ObjectCall& call, VarId buffer) {
    CLIPC_CHECK(!call.has_texel);
    const bool is_load = call.op == ObjectOp::kByteLoad;
    const ExprId value = is_load ? expr : OperandOf(program_, call, OperandKind::kValue);
    const TypeId type = program_.exprs[value].type;
    AccessorCall access(legalizer_, expr, call);
    access.Pass("address", OperandOf(program_, call, OperandKind::kPlace));
    if (!is_load) access.Pass("value", value);
    const std::string count = std::to_string(program_.types[type].Components());
    const std::string name =
        access.Name() + (is_load ? "_load" : "_store") + (count == "1" ? "" : count);
    access.Become(functions_[{buffer, type, is_load, access.is_marked()}], name,
                  is_load ? type : program_.types.Void(), [&](HelperBody& body) {
                    is_load ? Load(body, access, type) : Store(body, access, program_.types[type]);
                  });
  }

  // Makes the operation of an int a call of a function of the buffer, whose words are uints.
  void BecomeChange(ExprId expr, const ObjectCall& call, VarId buffer) {
    const bool is_least = call.op == ObjectOp::kAtomicMin;
    AccessorCall access(legalizer_, expr, call);
    access.Pass("address", OperandOf(program_, call, OperandKind::kPlace));
    access.Pass("value", OperandOf(program_, call, OperandKind::kValue));
    access.Become(changes_[{buffer, is_least, access.is_marked()}],
                  access.Name() + (is_least ? "_min" : "_max"), program_.types.Make(Scalar::kInt),
                  [&](HelperBody& body) { Change(body, access, is_least); });
  }

  // Puts in the value until no other invocation has changed the word since it was read.
  static void Change(HelperBody& body, const AccessorCall& access, bool is_least) {
    Formula f(body);
    Builder& b = body.b;
    const std::size_t last = access.parameters().size() - 1;
    const Local i = f.Let("i", f[last - 1] / kWord), value = f[last];
    const Local word = f.Let("word", Term(&body, access.Load(body, Term(i).expr)));
    const Local expected{&body, b.Local("expected", b.TypeOf(Term(word).expr))};
    body.Add(b.Stmt(Declare{expected.var, {}}));
    const Term old{&body, b.ConvertTo(Scalar::kInt, Term(expected).expr)};
    const Term changed = f.Call(is_least ? Intrinsic::kMin : Intrinsic::kMax, {old, value});
    const ExprId exchanged = access.CompareExchange(body, Term(i).expr, Term(expected).expr,
                                                    b.ConvertTo(Scalar::kUint, changed.expr));
    const StmtId steps[] = {b.Eval(b.AssignTo(Term(expected).expr, Term(word).expr)),
                            b.Eval(b.AssignTo(Term(word).expr, exchanged))};
    body.Add(b.Stmt(DoWhile{b.BlockOf(steps), (word != expected).expr}));
    body.Return(b.ConvertTo(Scalar::kInt, Term(word).expr));
  }

  static void Load(HelperBody& body, const AccessorCall& access, TypeId type) {
    Formula f(body);
    const Local i = f.Let("i", f[access.parameters().size() - 1] / kWord);
    std::vector<ExprId> words;
    for (std::uint32_t k = 0; k < body.program.types[type].Components(); ++k)
      words.push_back(access.Load(body, (k == 0 ? Term(i) : i + k).expr));
    body.Return(words.size() == 1 ? words[0] : body.b.ConstructOf(type, words));
  }

  static void Store(HelperBody& body, const AccessorCall& access, const Type& type) {
    Formula f(body);
    const std::size_t last = access.parameters().size() - 1;
    const Local address = f[last - 1], value = f[last];
    const std::uint32_t count = type.Components();
    for (std::uint32_t k = 0; k < count; ++k) {
      const Term first = address / kWord;
      const Term word = count == 1 ? Term(value) : value[std::string_view("xyzw").substr(k, 1)];
      access.Store(body, (k == 0 ? first : first + k).expr, word.expr);
    }
  }

  Legalizer& legalizer_;
  Program& program_;
  // By buffer, type of the value, whether it is loaded, and whether the index is marked.
  std::map<std::tuple<VarId, TypeId, bool, bool>, FunctionId> functions_;
  // By buffer, whether the least value stays, and whether the index is marked.
  std::map<std::tuple<VarId, bool, bool>, FunctionId> changes_;
};

}  // namespace

void LowerByteBuffers(Legalizer& legalizer) {
  ByteBufferLowering lowering(legalizer);
  const TypeTable& types = legalizer.program.types;
  MakeWordBuffers(
      legalizer,
      [&](const Resource& resource) {
        const TypeId type = legalizer.program.vars[resource.var].type;
        return IsByteAddress(types[types.Innermost(type)].object);
      },
      [&](ExprId expr, const ObjectCall& call, VarId buffer) {
        lowering.Lower(expr, call, buffer);
      });
  legalizer.program.form = Form::kAddressed;
}

}  // namespace clipc::legalize
