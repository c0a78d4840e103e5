// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Inputs at other places of the pixel, and at the vertices of the primitive.
#include <spirv/unified1/GLSL.std.450.h>

#include "backend-spirv/writer.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::spirv {

using namespace ir;

// The input's value at another place. A snapped place is given in sixteenths of a pixel.
Ref Writer::Interpolant(const IntrinsicCall& node) {
  const auto arguments = (*this)[node.arguments];
  const auto* swizzle = As<Swizzle>(arguments[0]);
  const ExprId input = swizzle ? swizzle->base : arguments[0];
  const auto* ref = As<VarRef>(input);
  if (!ref || pointers_[ref->var.index] == 0) return Lack("a part of an input at another place");
  Place place = PlaceOfVariable(ref->var);
  const Ref type = types_.Of(place.type);
  Ref value = 0;
  if (node.op == ir::Intrinsic::kAttributeAtVertex) {
    place.indices[0] = Value(arguments[1]);
    value = Load(place);
  } else {
    module_.Require(spv::Capability::InterpolationFunction);
    const Ref pointer = PointerTo(place);
    if (node.op == ir::Intrinsic::kEvaluateAtSample) {
      const Ref sample = Converted(Value(arguments[1]), ShapeAt(arguments[1]), Scalar::kInt);
      value = Extended(GLSLstd450InterpolateAtSample, type, {pointer, sample});
    } else if (node.op == ir::Intrinsic::kEvaluateSnapped) {
      const Ref offset = Converted(Value(arguments[1]), ShapeAt(arguments[1]), Scalar::kFloat);
      const Shape two = ShapeOf(Scalar::kFloat, 1, 2);
      const float down = options_.has_upper_left_origin ? 1.0f / 16 : -1.0f / 16;
      const Ref steps = module_.Constant(spv::Op::OpConstantComposite, types_.Of(two),
                                         {types_.Float(1.0f / 16), types_.Float(down)});
      const Ref pixels = Emit(spv::Op::OpFMul, types_.Of(two), {offset, steps});
      value = Extended(GLSLstd450InterpolateAtOffset, type, {pointer, pixels});
    } else {
      value = Extended(GLSLstd450InterpolateAtCentroid, type, {pointer});
    }
  }
  if (!swizzle) return value;
  return Components(value, ShapeAt(input), std::span(swizzle->components).first(swizzle->count));
}

// Reads an input at a vertex of the primitive or of the patch, or makes such.
Ref Writer::Vertices(const IntrinsicCall& node) {
  const auto arguments = (*this)[node.arguments];
  if (node.op == ir::Intrinsic::kEndPoints) {
    Do(spv::Op::OpControlBarrier, {types_.Uint(NumberOf(spv::Scope::Workgroup)),
                                   types_.Uint(NumberOf(spv::Scope::Invocation)), types_.Uint(0)});
    return 0;
  }
  if (node.op == ir::Intrinsic::kIsFirstPoint)
    return Emit(spv::Op::OpIEqual, types_.Of(Scalar::kBool),
                {LoadBuiltin(Builtin::kControlPointId), types_.Int(0)});
  if (node.op == ir::Intrinsic::kInputOfVertex || node.op == ir::Intrinsic::kOutputOfPoint) {
    Place place = PlaceOfVariable(As<VarRef>(arguments[0])->var);
    place.indices[0] = Value(arguments[1]);
    return Load(place);
  }
  const bool emits = node.op == ir::Intrinsic::kEmitVertex;
  if (program_.emission.streams.size() > 1) {
    module_.Require(spv::Capability::GeometryStreams);
    Do(emits ? spv::Op::OpEmitStreamVertex : spv::Op::OpEndStreamPrimitive, {Value(arguments[0])});
  } else {
    Do(emits ? spv::Op::OpEmitVertex : spv::Op::OpEndPrimitive, {});
  }
  return 0;
}

}  // namespace clipc::spirv
