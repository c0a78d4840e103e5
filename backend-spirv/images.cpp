// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Textures and typed buffers that are written. A texel has four components, whatever the format.
#include "backend-spirv/texture_read.h"

namespace clipc::spirv {

using namespace ir;

// The pointer to a texel.
Ref Writer::ImagePointer(const clipc::ir::ObjectCall& node) {
  const ExprId object = OperandOf(program_, node, OperandKind::kObject);
  const Ref image = ObjectPointer(object);
  const Ref place = Value(OperandOf(program_, node, OperandKind::kPlace));
  const Scalar scalar = FourTexels(TypeAt(object)).scalar;
  const Ref type = types_.Pointer(spv::StorageClass::Image, types_.Of(scalar));
  return Marked(Emit(spv::Op::OpImageTexelPointer, type, {image, place, types_.Uint(0)}),
                IsNonUniform(object));
}

Ref Writer::ImageCall(TypeId result, const clipc::ir::ObjectCall& node) {
  if (IsAtomic(node.op)) return Atomic(node, ImagePointer(node));
  if (node.op != ObjectOp::kStore && Takes(node.op, OperandKind::kPlace))
    return TextureRead(*this, result, node).WriteImageLoad();
  const ExprId object = OperandOf(program_, node, OperandKind::kObject);
  const Ref image = Object(object);
  if (node.op != ObjectOp::kStore) {
    module_.Require(spv::Capability::ImageQuery);
    return Emit(spv::Op::OpImageQuerySize, types_.Of(result), {image});
  }
  const Ref place = Value(OperandOf(program_, node, OperandKind::kPlace));
  const Shape four = FourTexels(TypeAt(object));
  const ExprId stored = OperandOf(program_, node, OperandKind::kValue);
  Words parts{Converted(Value(stored), ShapeAt(stored), four.scalar)};
  for (std::uint32_t i = ShapeAt(stored).size; i < 4; ++i)
    parts.push_back(types_.Splat(four.Component(), 0));
  const Ref texel = parts.size() == 1 ? parts[0] : Compose(types_.Of(four), parts);
  Do(spv::Op::OpImageWrite, {image, place, texel});
  return 0;
}

// SubpassInput: the pixel's own place of what an earlier subpass drew.
Ref Writer::SubpassLoad(TypeId result, const clipc::ir::ObjectCall& node) {
  const ExprId object = OperandOf(program_, node, OperandKind::kObject);
  const Shape four = FourTexels(TypeAt(object));
  const Ref image = Object(object);
  const ExprId sample = OperandOf(program_, node, OperandKind::kSample);
  Words operands{image, types_.Splat(ShapeOf(Scalar::kInt, 1, 2), 0)};
  ImageOperands more;
  if (sample) more.Add(spv::ImageOperandsMask::Sample, {Value(sample)});
  more.AppendTo(operands);
  constexpr std::uint8_t kFirst[] = {0, 1, 2, 3};
  return Components(Emit(spv::Op::OpImageRead, types_.Of(four), operands), four,
                    std::span(kFirst).first(ShapeOf(program_.types[result]).size));
}

}  // namespace clipc::spirv
