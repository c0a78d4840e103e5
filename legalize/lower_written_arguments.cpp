// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <vector>

#include "ir/intrinsic_list.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

bool GivesValue(const Legalizer& legalizer, ExprId expr) { return legalizer.IsNumeric(expr); }

// Makes `expr` a call of a helper that calls the function for each row, or each component, of its
// arguments.
void BecomeParts(Legalizer& legalizer, ExprId expr, const IntrinsicCall& call,
                 std::span<const ExprId> arguments) {
  static constexpr std::string_view kNames[] = {"a", "b", "c"};
  const Type type = legalizer.TypeOf(arguments[0]);
  const Shape shape = ShapeOf(type, legalizer.needs);
  const TypeId result = legalizer.program.exprs[expr].type;
  std::vector<Parameter> parameters;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    parameters.push_back({kNames[i], legalizer.program.exprs[arguments[i]].type,
                          i == 0 ? Storage::kIn : Storage::kOut});
  }
  legalizer.BecomeCall(expr, NameOf(call.op), parameters, arguments, [&](HelperBody& body) {
    std::vector<ExprId> values;
    for (std::uint32_t part = 0; part < (shape.HasRows() ? shape.rows : shape.size); ++part) {
      std::vector<ExprId> parts;
      for (std::size_t i = 0; i < arguments.size(); ++i) {
        const ExprId whole =
            type.kind == TypeKind::kMatrix && type.rows == 1 ? body.b.At(body[i], 0u) : body[i];
        ExprId element = body.b.At(whole, part);
        if (type.kind == TypeKind::kMatrix && type.columns == 1) element = body.b.At(element, 0u);
        parts.push_back(element);
      }
      const bool has_value = GivesValue(legalizer, expr);
      const TypeId part_type = has_value ? body.b.TypeOf(parts[0]) : legalizer.program.types.Void();
      const ExprId each = body.b.Add(
          part_type,
          IntrinsicCall{call.op, legalizer.program.expr_lists.Add(std::span<const ExprId>(parts))});
      if (has_value) {
        values.push_back(each);
      } else {
        body.Do(each);
      }
    }
    if (!values.empty()) body.Return(body.b.ConstructOf(result, values));
  });
}

// void sincos(x, out s, out c) { s = sin(x); c = cos(x); }
void BecomeSincos(Legalizer& legalizer, ExprId expr, std::span<const ExprId> arguments) {
  const TypeId type = legalizer.program.exprs[arguments[0]].type;
  const Parameter parameters[] = {
      {"x", type}, {"s", type, Storage::kOut}, {"c", type, Storage::kOut}};
  legalizer.BecomeCall(expr, "sincos", parameters, arguments, [&](HelperBody& body) {
    body.Do(body.b.AssignTo(body[1], body.b.IntrinsicOf(Intrinsic::kSin, type, {body[0]})));
    body.Do(body.b.AssignTo(body[2], body.b.IntrinsicOf(Intrinsic::kCos, type, {body[0]})));
  });
}

// modf(x, out whole) { whole = trunc(x); return x - whole; }
void BecomeModf(Legalizer& legalizer, ExprId expr, std::span<const ExprId> arguments) {
  const TypeId type = legalizer.program.exprs[arguments[0]].type;
  const bool is_floating = legalizer.ShapeAt(arguments[0]).IsFloating();
  const Parameter parameters[] = {{"x", type}, {"whole", type, Storage::kOut}};
  legalizer.BecomeCall(expr, "modf", parameters, arguments, [&](HelperBody& body) {
    Builder b = body.b;
    const ExprId x = body[0];
    const ExprId whole = is_floating ? b.IntrinsicOf(Intrinsic::kTrunc, type, {x}) : x;
    body.Do(b.AssignTo(body[1], whole));
    body.Return(b.BinaryOf(BinaryOp::kSub, body[0], is_floating ? body[1] : body[0]));
  });
}

}  // namespace

void LowerWrittenArguments(Legalizer& legalizer) {
  legalizer.ForEach([&](ExprId expr) {
    const auto* found = As<IntrinsicCall>(legalizer.program, expr);
    if (!found || found->arguments.size < 2 || !WritesArgument(found->op, 1)) return;
    const IntrinsicCall call = *found;
    const auto listed = std::as_const(legalizer.program).expr_lists[call.arguments];
    const std::vector<ExprId> arguments(listed.begin(), listed.end());
    const Shape shape = legalizer.ShapeAt(arguments[0]);
    const bool has_modf = shape.IsFloating() && !legalizer.needs.rounding;
    if (shape.HasRows()) return BecomeParts(legalizer, expr, call, arguments);
    if (call.op == Intrinsic::kSincos) return BecomeSincos(legalizer, expr, arguments);
    if (call.op == Intrinsic::kModf) {
      if (!has_modf) BecomeModf(legalizer, expr, arguments);
    } else if (shape.IsVector()) {
      BecomeParts(legalizer, expr, call, arguments);
    }
  });
}

}  // namespace clipc::legalize
