// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/pixel_inputs.h"

#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::rules {

ExprId CenterOf(Program& program, ExprId position) {
  Builder builder(program);
  const ExprId corner = builder.Swizzled(position, {0, 1});
  const ExprId rest = builder.Swizzled(Clone(program, position), {2, 3});
  const TypeId pair = builder.TypeOf(corner);
  const ExprId center =
      builder.BinaryOf(BinaryOp::kAdd, builder.IntrinsicOf(Intrinsic::kFloor, pair, {corner}),
                       builder.SplatTo(pair, builder.Float(0.5f)));
  return builder.ConstructOf(builder.TypeOf(position), {center, rest});
}

ExprId FirstBitOf(Program& program, ExprId coverage) {
  Builder builder(program);
  const ExprId bit = builder.BinaryOf(BinaryOp::kBitAnd, coverage, builder.Uint(1));
  return builder.BinaryOf(BinaryOp::kNotEqual, bit, builder.Uint(0));
}

}  // namespace clipc::rules
