// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "ir/evaluate.h"
#include "ir/scalar.h"
#include "ir/walk.h"
#include "legalize/float_range.h"
#include "legalize/index_uses.h"
#include "legalize/legalize.h"

namespace clipc::legalize {

using namespace ir;

namespace {

constexpr double kTwoTo31 = 0x1p31;
constexpr double kTwoTo32 = 0x1p32;

// Whether conversions to integers saturate. Those of Direct3D 10 and 11 do, and make 0 of NaN
// ("Direct3D 11.3 Functional Specification", ftoi and ftou); DXIL's fptosi and fptoui are as
// undefined as GLSL's conversions, and before 4.0 an int is a float without a fraction.
bool Saturates(const Profile& profile) {
  return profile.IsAtLeast(4, 0) && !profile.IsAtLeast(6, 0) && profile.level9 == Level9::kNone;
}

class ConversionLowering {
 public:
  explicit ConversionLowering(Legalizer& legalizer)
      : legalizer_(legalizer), program_(legalizer.program), ranges_(legalizer.program) {
    for (const VarId var : program_.vars.ids()) NoteConstant(program_.vars[var]);
  }

  void Run() {
    legalizer_.ForEach([&](ExprId expr) {
      if (!IsDone(expr) && IsToInteger(expr) && MayNotFit(expr)) Lower(expr);
    });
  }

 private:
  // Replaces, in the value of a constant, conversions that may not fit by their results: GLSL
  // allows no calls of functions there.
  void NoteConstant(const Var& var) {
    if (var.storage != Storage::kConstant || !var.init) return;
    std::vector<ExprId> misfits;
    ForEachExpr(program_, var.init, [&](ExprId part) {
      SetDone(part);
      if (IsToInteger(part) && MayNotFit(part)) misfits.push_back(part);
    });
    for (const ExprId part : misfits) {
      const auto bits = ConstantBits(program_, part);
      if (bits)
        legalizer_.Become(part, legalizer_.At(part).ValueOf(TypeIdOf(program_, part), *bits));
    }
  }

  bool IsToInteger(ExprId expr) const {
    const auto* convert = As<Convert>(program_, expr);
    const Scalar to = convert ? BaseOf(legalizer_.TypeOf(expr).scalar) : Scalar::kFloat;
    return (to == Scalar::kInt || to == Scalar::kUint) &&
           IsFloat(legalizer_.TypeOf(convert->operand).scalar);
  }

  // Whether the operand has a component that is not known to fit into the integer.
  bool MayNotFit(ExprId expr) {
    const std::optional<FloatRange> range = ranges_.Of(As<Convert>(program_, expr)->operand);
    return !range || range->may_be_nan || !Fits(*range, expr);
  }

  // Whether the operand is at least 0 and fits, or is NaN.
  bool FitsOrIsNan(ExprId expr) {
    const std::optional<FloatRange> range = ranges_.Of(As<Convert>(program_, expr)->operand);
    return range && range->low >= 0 && Fits(*range, expr);
  }

  bool Fits(const FloatRange& range, ExprId expr) const {
    const bool is_int = BaseOf(legalizer_.TypeOf(expr).scalar) == Scalar::kInt;
    return is_int ? range.low >= -kTwoTo31 && range.high < kTwoTo31
                  : range.low >= 0 && range.high < kTwoTo32;
  }

  bool IsDone(ExprId expr) const { return expr.index < done_.size() && done_[expr.index]; }
  void SetDone(ExprId expr) {
    if (done_.size() <= expr.index) done_.resize(program_.exprs.size());
    done_[expr.index] = true;
  }

  void Lower(ExprId expr) {
    ExprId operand = As<Convert>(program_, expr)->operand;
    const Scalar to = BaseOf(legalizer_.TypeOf(expr).scalar);
    const bool is_int = to == Scalar::kInt;
    // An index that does not fit into an int is out of every array. A uint index from below 0 is
    // element 0.
    if (!uses_) uses_.emplace(program_);
    const bool is_index = uses_->IsIndex(expr);
    if (is_index && is_int) return;
    if (is_index || FitsOrIsNan(expr)) {
      program_.exprs[expr].node = Convert{AtLeastZero(legalizer_.At(expr), operand)};
      return SetDone(expr);
    }
    if (TakeApart(expr, to, operand)) return;
    const char* name = is_int ? "to_int" : "to_uint";
    if (!legalizer_.ShapeAt(expr).IsScalar())
      return legalizer_.ByComponents(expr, name, Convert{operand});
    const TypeId type = program_.exprs[expr].type;
    const Parameter parameters[] = {{"x", program_.exprs[operand].type}};
    legalizer_.BecomeCall(expr, name, parameters, {&operand, 1}, [&](HelperBody& body) {
      body.Return(is_int ? Int(body, type) : Uint(body, type));
    });
  }

  // Splits a conversion of min16int or half, which are an int and a float, or of int1, which has a
  // scalar in it, so that one helper function serves all of them. The conversion in the middle is
  // lowered in its turn. Returns false if `expr` is still the conversion, of `operand`, that is to
  // be lowered.
  bool TakeApart(ExprId expr, Scalar to, ExprId& operand) {
    Builder b = legalizer_.At(expr);
    const TypeId type = program_.exprs[expr].type;
    const Scalar kind = program_.types[type].scalar;
    const Scalar from = legalizer_.TypeOf(operand).scalar;
    const bool is_single =
        legalizer_.ShapeAt(expr).IsScalar() && program_.types[type].kind != TypeKind::kScalar;
    ExprId inner = b.ConvertTo(BaseOf(from), operand);
    if (!is_single && kind == to) {
      // The conversion itself is still to be lowered.
      program_.exprs[expr].node = Convert{operand = inner};
      return false;
    }
    if (is_single) inner = legalizer_.Component(b, inner, 0);
    inner = b.ConvertTo(kind, b.ConvertTo(to, inner));
    legalizer_.Become(expr, is_single ? b.ConstructOf(type, {inner}) : inner);
    return true;
  }

  // Returns max(0, x), which is 0 for NaN: GLSL's max(a, b) is a unless a < b.
  ExprId AtLeastZero(Builder b, ExprId x) {
    const TypeId type = b.TypeOf(x);
    const ExprId zero = b.SplatTo(type, b.LiteralOf(program_.types[type].scalar, 0));
    return b.IntrinsicOf(CommonIntrinsic::kMax, type, {zero, x});
  }

  // Returns x >= 2^32 ? 2^32 - 1 : uint(max(0, x)).
  ExprId Uint(HelperBody& body, TypeId type) {
    const ExprId whole = Converted(body, type, AtLeastZero(body.b, body[0]));
    const bool has_uint = !legalizer_.needs.signed_integers;
    if (!has_uint) return whole;
    const ExprId is_great = Compare(body, BinaryOp::kGreaterEqual, kTwoTo32);
    return body.b.Add(type, Conditional{is_great, Number(body, type, kTwoTo32 - 1), whole});
  }

  // Returns x < 2^31 ? int(max(-2^31, x)) : x > 0 ? 2^31 - 1 : 0, the last for NaN.
  ExprId Int(HelperBody& body, TypeId type) {
    Builder& b = body.b;
    const ExprId is_below = Compare(body, BinaryOp::kLess, kTwoTo31);
    const ExprId least =
        b.IntrinsicOf(CommonIntrinsic::kMax, program_.vars[body.parameters[0]].type,
                      {Limit(body, -kTwoTo31), body[0]});
    const ExprId whole = Converted(body, type, least);
    const ExprId rest = b.Add(type, Conditional{Compare(body, BinaryOp::kGreater, 0),
                                                Number(body, type, kTwoTo31 - 1), b.ZeroOf(type)});
    return b.Add(type, Conditional{is_below, whole, rest});
  }

  ExprId Converted(HelperBody& body, TypeId type, ExprId value) {
    const ExprId convert = body.b.Add(type, Convert{value});
    SetDone(convert);
    return convert;
  }
  ExprId Number(HelperBody& body, TypeId type, double value) {
    return body.b.LiteralOf(program_.types[type].scalar, value);
  }
  ExprId Limit(HelperBody& body, double value) {
    return Number(body, program_.vars[body.parameters[0]].type, value);
  }
  ExprId Compare(HelperBody& body, BinaryOp op, double limit) {
    return body.b.BinaryOf(op, body[0], Limit(body, limit));
  }

  Legalizer& legalizer_;
  Program& program_;
  FloatRanges ranges_;
  std::optional<IndexUses> uses_;  // made for the first conversion that may not fit
  std::vector<bool> done_;         // by ExprId: conversions that are kept
};

}  // namespace

void LowerConversions(Legalizer& legalizer) {
  const Program& program = legalizer.program;
  if (!Saturates(program.profile)) return;
  const bool has_any = program.exprs.AnyOf([&](const Expr& expr) {
    const auto* convert = std::get_if<Convert>(&expr.node);
    if (!convert || !convert->operand) return false;
    const Scalar to = BaseOf(program.types[expr.type].scalar);
    return (to == Scalar::kInt || to == Scalar::kUint) &&
           IsFloat(TypeOf(program, convert->operand).scalar);
  });
  if (has_any) ConversionLowering(legalizer).Run();
}

}  // namespace clipc::legalize
