// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "base/invariant.h"
#include "ir/scalar.h"
#include "legalize/constant.h"
#include "legalize/functions.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

class FunctionLowering {
 public:
  explicit FunctionLowering(Legalizer& legalizer)
      : legalizer_(legalizer), program_(legalizer.program) {}

  void Run() {
    legalizer_.ForEach([&](ExprId expr) {
      const auto* call = As<IntrinsicCall>(program_, expr);
      if (call && call->arguments.size > 0 && !kept_.contains(expr)) Lower(expr, *call);
    });
  }

 private:
  void Lower(ExprId expr, const IntrinsicCall call) {
    const auto listed = std::as_const(program_).expr_lists[call.arguments];
    if (call.op == CommonIntrinsic::kWholePower) return BecomePower(expr, listed[0], listed[1]);
    const Type& first = legalizer_.TypeOf(listed[0]);
    const Function* function = FindFunction(call.op, first, legalizer_.needs);
    if (!function) return;
    // Languages like GLSL leave smoothstep undefined if the edges are not in order; else it is
    // theirs.
    if (call.op == CommonIntrinsic::kSmoothstep &&
        AreInOrder(ConstantOf(program_, listed[0]), ConstantOf(program_, listed[1])))
      return;
    const bool is_wrapped = function->of_scalars && first.kind != TypeKind::kScalar;
    if (is_wrapped)
      BecomeWrapped(expr, *function, call);
    else
      BecomeCall(expr, *function, call.arguments);
  }

  // A float1 is a scalar.
  void BecomeWrapped(ExprId expr, const Function& function, const IntrinsicCall& call) {
    Builder b = legalizer_.At(expr);
    for (std::uint32_t i = 0; i < call.arguments.size; ++i) {
      const ExprId component = legalizer_.Component(b, program_.expr_lists[call.arguments][i], 0);
      program_.expr_lists[call.arguments][i] = component;
    }
    const TypeId type = program_.exprs[expr].type;
    const ExprId value = b.Add(program_.types.Make(program_.types[type].scalar), call);
    BecomeCall(value, function, call.arguments);
    legalizer_.Become(expr, b.ConstructOf(type, {value}));
  }

  void BecomeCall(ExprId expr, const Function& function, List<ExprId> arguments) {
    std::array<Parameter, IntrinsicSignature::kMaxArguments> parameters;
    std::string_view names = function.parameters;
    for (std::uint32_t i = 0; i < arguments.size; ++i) {
      const std::string_view name = names.substr(0, names.find(' '));
      names.remove_prefix(std::min(name.size() + 1, names.size()));
      const ExprId argument = std::as_const(program_).expr_lists[arguments][i];
      parameters[i] = {name, program_.exprs[argument].type,
                       WritesArgument(function.op, i) ? Storage::kOut : Storage::kIn};
    }
    const std::string_view name = function.name.empty() ? NameOf(function.op) : function.name;
    const FunctionId helper = legalizer_.Helper(name, std::span(parameters).first(arguments.size),
                                                program_.exprs[expr].type,
                                                [&](HelperBody& body) { Define(body, function); });
    program_.exprs[expr].node = Call{helper, arguments};
  }

  // pow5(x) { float x2 = x * x; return x * (x2 * x2); }
  void BecomePower(ExprId expr, ExprId x, ExprId exponent) {
    const auto constant = ConstantOf(program_, exponent);
    CLIPC_CHECK(constant);
    const auto power = static_cast<std::uint32_t>(
        constant->kind == Scalar::kDouble ? DoubleOf(constant->bits) : FloatOf(constant->bits));
    const TypeId type = program_.exprs[expr].type;
    const Parameter parameter{"x", type, Storage::kIn};
    legalizer_.BecomeCall(expr, fmt::format("pow{}", power), {&parameter, 1}, {&x, 1},
                          [&](HelperBody& body) { DefinePower(body, power); });
  }

  static void DefinePower(HelperBody& body, std::uint32_t power) {
    Formula f(body);
    Local square = f[0];
    std::optional<Local> product;
    for (std::uint32_t factor = 1;; factor *= 2) {
      if (power & factor) product = product ? f.Let("product", *product * square) : square;
      const Term next = square * square;
      if (factor * 4 > power) return f.Return(product ? *product * next : next);
      square = f.Let(fmt::format("x{}", 2 * factor), next);
    }
  }

  void Define(HelperBody& body, const Function& function) {
    const std::uint32_t begin = program_.exprs.size();
    Formula formula(body);
    function.define(formula);
    // A helper function may call the function that it stands for.
    for (std::uint32_t i = begin; i < program_.exprs.size(); ++i) {
      const auto* call = As<IntrinsicCall>(program_, ExprId{i});
      if (call && call->op == function.op) kept_.insert(ExprId{i});
    }
  }

  Legalizer& legalizer_;
  Program& program_;
  std::set<ExprId> kept_;
};

}  // namespace

void LowerFunctions(Legalizer& legalizer) {
  FunctionLowering(legalizer).Run();
  legalizer.program.form = Form::kLegalized;
}

}  // namespace clipc::legalize
