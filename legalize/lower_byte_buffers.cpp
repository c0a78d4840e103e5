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
};

}  // namespace

void LowerByteBuffers(Legalizer& legalizer) {
  ByteBufferLowering lowering(legalizer);
  const TypeTable& types = legalizer.program.types;
  MakeWordBuffers(
      legalizer,
      [&](const Var& buffer) { return IsByteAddress(types[types.Innermost(buffer.type)].object); },
      [&](ExprId expr, const ObjectCall& call, VarId buffer) {
        lowering.Lower(expr, call, buffer);
      });
  legalizer.program.form = Form::kAddressed;
}

}  // namespace clipc::legalize
