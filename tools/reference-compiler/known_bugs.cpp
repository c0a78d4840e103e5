// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/reference-compiler/known_bugs.h"

#include <cstdlib>
#include <cstring>
#include <regex>
#include <variant>

#include "ir/builder.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::draw::reference_compiler {
namespace {

using namespace ir;

// A rewriter of expressions to those that the reference compiler makes of them. An expression that
// is used in two places is evaluated twice: the result is for the evaluator only.
class Rewriter {
 public:
  explicit Rewriter(Program& program) : program_(program) {}

  std::set<std::string> Run() {
    std::vector<ExprId> all;
    for (const ExprId id : program_.exprs.ids()) all.push_back(id);
    for (const ExprId id : all) Rewrite(id);
    return names_;
  }

 private:
  void Rewrite(ExprId id) {
    const Expr expr = program_.exprs[id];
    Builder make(program_, expr.span);
    if (const auto* binary = std::get_if<Binary>(&expr.node)) {
      const Type& type = program_.types[expr.type];
      if (binary->op == BinaryOp::kMod && BaseOf(type.scalar) == Scalar::kFloat)
        Replace(id, "float-remainder", Remainder(make, expr.type, binary->left, binary->right));
      if (binary->op == BinaryOp::kMul && type.kind == TypeKind::kMatrix) {
        // The reference compiler's matrices are transposed.
        Replace(id, "matrix-product",
                make.IntrinsicOf(Intrinsic::kMul, expr.type, {binary->right, binary->left}));
      }
    } else if (const auto* call = std::get_if<IntrinsicCall>(&expr.node)) {
      const auto argument = [&](std::size_t i) { return program_.expr_lists[call->arguments][i]; };
      if (call->op == Intrinsic::kFmod)
        Replace(id, "float-remainder", Remainder(make, expr.type, argument(0), argument(1)));
      if (call->op == Intrinsic::kLit)
        Replace(id, "lit", Lit(make, expr.type, argument(0), argument(1), argument(2)));
    }
  }

  void Replace(ExprId id, const char* name, ExprId by) {
    program_.exprs[id].node = program_.exprs[by].node;
    names_.insert(name);
  }

  // The remainder as the reference compiler has it, with the quotient rounded down and not towards
  // zero.
  static ExprId Remainder(Builder& make, TypeId type, ExprId left, ExprId right) {
    const ExprId quotient =
        make.IntrinsicOf(Intrinsic::kFloor, type, {make.BinaryOf(BinaryOp::kDiv, left, right)});
    return make.BinaryOf(BinaryOp::kSub, left, make.BinaryOf(BinaryOp::kMul, right, quotient));
  }

  // lit() as the reference compiler has it, with the shine multiplied by the exponent and not
  // raised to it.
  static ExprId Lit(Builder& make, TypeId type, ExprId diffuse, ExprId shine, ExprId exponent) {
    const TypeId scalar = make.TypeOf(diffuse);
    const ExprId zero = make.Float(0), one = make.Float(1);
    const auto step = [&](ExprId x) {
      return make.IntrinsicOf(Intrinsic::kStep, scalar, {zero, x});
    };
    const ExprId is_lit = make.BinaryOf(BinaryOp::kMul, step(diffuse), step(shine)),
                 specular = make.BinaryOf(BinaryOp::kMul, shine, exponent);
    return make.ConstructOf(type, {one, make.IntrinsicOf(Intrinsic::kMax, scalar, {diffuse, zero}),
                                   make.BinaryOf(BinaryOp::kMul, is_lit, specular), one});
  }

  Program& program_;
  std::set<std::string> names_;
};

}  // namespace

bool GiveInitialValues(const Program& program, const std::vector<ReferenceBlock>& blocks,
                       const std::string& hlsl, RandomInputs& random) {
  bool any = false;
  for (const CbufferId id : program.cbuffers.ids()) {
    const Cbuffer& cbuffer = program.cbuffers[id];
    const ReferenceBlock* block = Find(blocks, cbuffer);
    for (const PlacedMember& member : MembersOf(program, cbuffer)) {
      if (cbuffer.kind != CbufferKind::kGlobals || (block && block->members.contains(member.name)))
        continue;
      std::smatch found;
      if (!std::regex_search(
              hlsl, found,
              std::regex("\\bconst\\s+\\w+\\s+" + member.name + "\\s*=\\s*([-+.\\w]+)\\s*;")))
        continue;
      const double number = std::strtod(found[1].str().c_str(), nullptr);
      const Scalar kind = program.types[member.type].scalar;
      const auto word =
          static_cast<std::uint32_t>(ConvertBits(BitsOf(number), Scalar::kDouble, BaseOf(kind)));
      std::memcpy(&random.cbuffers[id.index].at(member.offset + 3) - 3, &word, 4);
      any = true;
    }
  }
  return any;
}

std::set<std::string> ApplyValueBugs(Program& program) { return Rewriter(program).Run(); }

}  // namespace clipc::draw::reference_compiler
