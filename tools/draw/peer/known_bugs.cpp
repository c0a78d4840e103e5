// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/peer/known_bugs.h"

#include <array>
#include <cstdlib>
#include <cstring>
#include <regex>
#include <variant>

#include "ir/scalar.h"

namespace clipc::draw::peer {
namespace {

using ir::BinaryOp;
using ir::ExprId;
using ir::Intrinsic;

// An expression that stands in two places is evaluated twice: the result is for the evaluator only.
class Rewriter {
 public:
  explicit Rewriter(ir::Program& program) : program_(program) {}

  std::set<std::string> Run() {
    std::vector<ExprId> all;
    for (const ExprId id : program_.exprs.ids()) all.push_back(id);
    for (const ExprId id : all) Rewrite(id);
    return names_;
  }

 private:
  void Rewrite(ExprId id) {
    const ir::Expr expr = program_.exprs[id];
    if (const auto* binary = std::get_if<ir::Binary>(&expr.node)) {
      const ir::Type& type = program_.types[expr.type];
      const bool is_float = ir::BaseOf(type.scalar) == ir::Scalar::kFloat;
      if (binary->op == BinaryOp::kMod && is_float)
        Replace(id, "float-remainder", Remainder(expr, binary->left, binary->right));
      if (binary->op == BinaryOp::kMul && type.kind == ir::TypeKind::kMatrix) {
        // The peer's matrices are the transposed ones.
        Replace(id, "matrix-product",
                ir::IntrinsicCall{Intrinsic::kMul,
                                  program_.expr_lists.Add({binary->right, binary->left})});
      }
    } else if (const auto* call = std::get_if<ir::IntrinsicCall>(&expr.node)) {
      const auto argument = [&](std::size_t i) { return program_.expr_lists[call->arguments][i]; };
      if (call->op == Intrinsic::kFmod)
        Replace(id, "float-remainder", Remainder(expr, argument(0), argument(1)));
      if (call->op == Intrinsic::kLit)
        Replace(id, "lit", Lit(expr, {argument(0), argument(1), argument(2)}));
    }
  }

  using Node = decltype(ir::Expr::node);

  void Replace(ExprId id, const char* name, Node node) {
    program_.exprs[id].node = std::move(node);
    names_.insert(name);
  }

  ExprId Add(const ir::Expr& like, Node node) {
    return program_.exprs.Add({like.type, like.span, std::move(node)});
  }
  ExprId Call(const ir::Expr& like, Intrinsic op, std::initializer_list<ExprId> arguments) {
    return Add(like, ir::IntrinsicCall{op, program_.expr_lists.Add(arguments)});
  }

  // Rounds the quotient down and not towards zero.
  Node Remainder(const ir::Expr& expr, ExprId left, ExprId right) {
    const ExprId quotient =
        Call(expr, Intrinsic::kFloor, {Add(expr, ir::Binary{BinaryOp::kDiv, left, right})});
    return ir::Binary{BinaryOp::kSub, left, Add(expr, ir::Binary{BinaryOp::kMul, right, quotient})};
  }

  // Multiplies by the exponent.
  Node Lit(const ir::Expr& expr, const std::array<ExprId, 3>& arguments) {
    const ir::Expr scalar{program_.types.Make(ir::Scalar::kFloat), expr.span, {}};
    const ExprId zero = Add(scalar, ir::Literal{ir::BitsOf(0.0f)}),
                 one = Add(scalar, ir::Literal{ir::BitsOf(1.0f)});
    const auto product = [&](ExprId left, ExprId right) {
      return Add(scalar, ir::Binary{BinaryOp::kMul, left, right});
    };
    const ExprId is_lit = product(Call(scalar, Intrinsic::kStep, {zero, arguments[0]}),
                                  Call(scalar, Intrinsic::kStep, {zero, arguments[1]}));
    const ExprId specular = product(is_lit, product(arguments[1], arguments[2]));
    return ir::Construct{program_.expr_lists.Add(
        {one, Call(scalar, Intrinsic::kMax, {arguments[0], zero}), specular, one})};
  }

  ir::Program& program_;
  std::set<std::string> names_;
};

}  // namespace

bool GiveInitialValues(const ir::Program& program, const std::vector<PeerBlock>& blocks,
                       const std::string& hlsl, RandomInputs& random) {
  bool any = false;
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    const PeerBlock* block = Find(blocks, cbuffer);
    for (const Member& member : MembersOf(program, cbuffer)) {
      if (cbuffer.kind != ir::CbufferKind::kGlobals ||
          (block && block->members.contains(member.name)))
        continue;
      std::smatch found;
      if (!std::regex_search(
              hlsl, found,
              std::regex("\\bconst\\s+\\w+\\s+" + member.name + "\\s*=\\s*([-+.\\w]+)\\s*;")))
        continue;
      const double number = std::strtod(found[1].str().c_str(), nullptr);
      const ir::Scalar kind = program.types[member.type].scalar;
      const auto word = static_cast<std::uint32_t>(
          ir::ConvertBits(ir::BitsOf(number), ir::Scalar::kDouble, ir::BaseOf(kind)));
      std::memcpy(&random.cbuffers[id.index].at(member.offset + 3) - 3, &word, 4);
      any = true;
    }
  }
  return any;
}

std::set<std::string> ApplyValueBugs(ir::Program& program) { return Rewriter(program).Run(); }

}  // namespace clipc::draw::peer
