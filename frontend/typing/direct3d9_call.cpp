// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Direct3D 9's functions that read a texture: tex2D, tex2Dlod and the like. Source: the pages of
// Microsoft's HLSL reference on them, and fxc, which takes two more arguments of tex2D for
// gradients.
#include <array>
#include <initializer_list>
#include <vector>

#include "frontend/typing/intrinsic_call.h"
#include "frontend/typing/object_call.h"

namespace clipc::typing {
namespace {

// A call in progress. The digit or C after "tex" in its name gives the sampler.
class TexCheck : IntrinsicCheck {
 public:
  explicit TexCheck(const IntrinsicCheck& call) : IntrinsicCheck(call) {
    const char letter = name[3];
    sampler_ = letter == '1'   ? ObjectKind::kSampler1D
               : letter == '2' ? ObjectKind::kSampler2D
               : letter == '3' ? ObjectKind::kSampler3D
                               : ObjectKind::kSamplerCube;
    const ObjectInfo& info = InfoOf(sampler_);
    dimensions_ = info.is_cube ? 3 : info.axes;
  }

  // Checks tex2D(sampler, coordinate [, ddx, ddy]).
  ExprId Plain() {
    if (arguments.size() == 4) return Gradient();
    const auto object = Sampler(2);
    const auto place = object ? Converted(1, Coordinate()) : std::nullopt;
    if (!place) return Error();
    return Finish(ObjectOp::kD3d9Sample, *object, *place);
  }

  ExprId Gradient() {
    const auto object = Sampler(4);
    if (!object) return Error();
    std::array<ExprId, 3> values;
    for (const std::size_t i : {0u, 1u, 2u}) {
      const auto value = Converted(i + 1, Coordinate());
      if (!value) return Error();
      values[i] = *value;
    }
    const NamedOperand ddx{OperandKind::kDdx, values[1]}, ddy{OperandKind::kDdy, values[2]};
    return Finish(ObjectOp::kD3d9SampleGrad, *object, values[0], {ddx, ddy});
  }

  // Checks tex2Dlod(sampler, float4(coordinate, level)) and tex2Dbias, where the last component is
  // a bias.
  ExprId WithLast(ObjectOp op, OperandKind kind) {
    const auto object = Sampler(2);
    const auto location = object ? Converted(1, Float4()) : std::nullopt;
    if (!location) return Error();
    const bool keeps_third = program.keeps_third_coordinate && sampler_ == ObjectKind::kSampler2D;
    const auto parts = Split(*location, keeps_third ? 3 : dimensions_, 3);
    return After(*this, {&parts.prologue, 1},
                 Finish(op, *object, parts.leading, {{kind, parts.last}}));
  }

  // Checks tex2Dproj(sampler, float4(coordinate, divisor)). GLSL projects on no cube.
  ExprId Projected() {
    const auto object = Sampler(2);
    const auto location = object ? Converted(1, Float4()) : std::nullopt;
    if (!location) return Error();
    if (sampler_ != ObjectKind::kSamplerCube)
      return Finish(ObjectOp::kD3d9SampleProjected, *object, *location);
    const auto parts = Split(*location, dimensions_, 3);
    Builder builder = Make();
    const ExprId place =
        builder.BinaryOf(BinaryOp::kDiv, parts.leading, builder.SplatTo(Coordinate(), parts.last));
    return After(*this, {&parts.prologue, 1}, Finish(ObjectOp::kD3d9Sample, *object, place));
  }

 private:
  TypeId Float4() const { return program.types.Vector(Scalar::kFloat, 4); }
  TypeId Coordinate() const { return VectorOf(Scalar::kFloat, dimensions_); }

  // The first of `count` arguments as the sampler of the function; nullopt after an error.
  std::optional<ExprId> Sampler(std::size_t count) const {
    if (!HasCount(count, count)) return std::nullopt;
    const TypeId wanted = program.types.Object(sampler_);
    if (RankImplicit(program.types, ArgumentTypeId(0), wanted)) return ConvertArgument(0, wanted);
    BadArgument(0, "a `" + program.types.Name(wanted) + "`");
    return std::nullopt;
  }

  ExprId Finish(ObjectOp op, ExprId object, ExprId coordinate,
                std::initializer_list<NamedOperand> rest = {}) const {
    std::vector<NamedOperand> operands = {{OperandKind::kObject, object},
                                          {OperandKind::kCoordinate, coordinate}};
    operands.insert(operands.end(), rest);
    return Make().ObjectCallOf(op, Float4(), operands);
  }

  ObjectKind sampler_;
  int dimensions_;
};

}  // namespace

ExprId CheckTexLod(const IntrinsicCheck& call) {
  // Microsoft's pages on the functions: shader model 3 and later.
  if (!call.program.profile.IsAtLeast(3, 0)) {
    return call.Fail(call.name_span, diag::IntrinsicProfile, call.name,
                     fmt::format("{}_3_0", call.ThisStage().prefix), call.program.profile.name);
  }
  return TexCheck(call).WithLast(ObjectOp::kD3d9SampleLevel, OperandKind::kLevel);
}
ExprId CheckTex(const IntrinsicCheck& call) { return TexCheck(call).Plain(); }
ExprId CheckTexBias(const IntrinsicCheck& call) {
  return TexCheck(call).WithLast(ObjectOp::kD3d9SampleBias, OperandKind::kBias);
}
ExprId CheckTexGrad(const IntrinsicCheck& call) { return TexCheck(call).Gradient(); }
ExprId CheckTexProj(const IntrinsicCheck& call) { return TexCheck(call).Projected(); }

}  // namespace clipc::typing
