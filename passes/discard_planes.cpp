// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "passes/discard_planes.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "base/invariant.h"
#include "ir/access.h"
#include "ir/builder.h"

namespace clipc::passes {

using namespace ir;

namespace {

// The location after those of all inputs.
std::uint32_t LocationAfterInputs(const Program& program) {
  std::uint32_t next = 0;
  for (const IoVar& input : program.inputs) {
    if (input.builtin != Builtin::kNone) continue;
    next =
        std::max(next, input.location + LocationCount(program.types[program.vars[input.var].type]));
  }
  return next;
}

// Adds an input with the distances to `count` planes, and returns whether one of them is below zero
// or not a number. Each is asked by itself: drivers make `any(x < 0)` of `!all(x >= 0)`.
ExprId AddDistances(Program& program, std::uint32_t index, int count) {
  IoVar input;
  const TypeId type =
      count == 1 ? program.types.Make(Scalar::kFloat) : program.types.Vector(Scalar::kFloat, count);
  input.location = LocationAfterInputs(program);
  input.var = program.vars.Add({.name = "clip_plane_distance" + std::to_string(index),
                                .type = type,
                                .storage = Storage::kInput});
  input.semantic = kClipPlaneDistance;
  input.index = index;
  program.inputs.push_back(input);
  Builder b(program);
  const auto any = [&](ExprId of) {
    return b.IntrinsicOf(CommonIntrinsic::kAny, program.types.Make(Scalar::kBool), {of});
  };
  const TypeId truths =
      count == 1 ? program.types.Make(Scalar::kBool) : program.types.Vector(Scalar::kBool, count);
  const ExprId is_nan = b.IntrinsicOf(CommonIntrinsic::kIsNan, truths, {b.Ref(input.var)});
  const ExprId is_below = b.BinaryOf(BinaryOp::kLess, b.Ref(input.var), b.ZeroOf(type));
  return count == 1 ? b.BinaryOf(BinaryOp::kLogicalOr, is_nan, is_below)
                    : b.BinaryOf(BinaryOp::kLogicalOr, any(is_nan), any(is_below));
}

}  // namespace

void DiscardPlanes(Program& program, std::size_t planes) {
  CLIPC_CHECK(program.form == Form::kInlined);
  if (planes == 0) return;
  Builder b(program);
  ExprId is_outside;
  for (std::size_t first = 0; first < planes; first += 4) {
    const auto count = static_cast<int>(std::min<std::size_t>(planes - first, 4));
    const ExprId part = AddDistances(program, static_cast<std::uint32_t>(first / 4), count);
    is_outside = is_outside ? b.BinaryOf(BinaryOp::kLogicalOr, is_outside, part) : part;
  }
  const StmtId discard = b.Stmt(Discard{});
  std::vector<StmtId> body{b.Stmt(If{is_outside, b.BlockOf({&discard, 1}), {}})};
  body.insert(body.end(), MainBody(program).begin(), MainBody(program).end());
  SetMainBody(program, body);
}

}  // namespace clipc::passes
