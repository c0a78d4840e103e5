// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/signature/pixel_inputs.h"

#include <cstdint>
#include <span>

#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::signature {

ExprId CenterOf(Program& program, ExprId position) {
  Builder builder(program);
  const ExprId corner = builder.Swizzled(position, {0, 1});
  const ExprId rest = builder.Swizzled(Clone(program, position), {2, 3});
  const TypeId pair = builder.TypeOf(corner);
  const ExprId center =
      builder.BinaryOf(BinaryOp::kAdd, builder.IntrinsicOf(CommonIntrinsic::kFloor, pair, {corner}),
                       builder.SplatTo(pair, builder.Float(0.5f)));
  return builder.ConstructOf(builder.TypeOf(position), {center, rest});
}

ExprId CornerOf(Builder builder, ExprId position, std::uint32_t count) {
  const TypeId type = builder.TypeOf(position);
  const ExprId half[] = {builder.Float(0.5f), builder.Float(0.5f), builder.Float(0),
                         builder.Float(0)};
  const ExprId offset = count == 1   ? half[0]
                        : count == 2 ? builder.SplatTo(type, half[0])
                                     : builder.ConstructOf(type, std::span(half).first(count));
  return builder.BinaryOf(BinaryOp::kSub, position, offset);
}

ExprId AfterSampleNumber(Builder builder, ExprId position, ExprId number) {
  const ExprId zero = builder.BinaryOf(BinaryOp::kShiftRight, number, builder.Uint(5));
  return builder.BinaryOf(
      BinaryOp::kAdd, position,
      builder.SplatTo(builder.TypeOf(position), builder.ConvertTo(Scalar::kFloat, zero)));
}

ExprId FacingOf(Builder builder, ExprId is_front, Scalar kind) {
  if (kind == Scalar::kBool) return is_front;
  const bool is_sign = kind == Scalar::kFloat;
  const ExprId front = is_sign ? builder.Float(1) : builder.Int(-1);
  const ExprId back = is_sign ? builder.Float(-1) : builder.Int(0);
  return builder.Add(builder.TypeOf(front), Conditional{is_front, front, back});
}

ExprId FirstBitOf(Program& program, ExprId coverage) {
  Builder builder(program);
  const ExprId bit = builder.BinaryOf(BinaryOp::kBitAnd, coverage, builder.Uint(1));
  return builder.BinaryOf(BinaryOp::kNotEqual, bit, builder.Uint(0));
}

}  // namespace clipc::signature
