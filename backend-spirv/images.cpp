// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Textures and typed buffers that are written. A texel has four components, whatever the format.
#include "backend-spirv/writer.h"

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
  const ExprId object = OperandOf(program_, node, OperandKind::kObject);
  const Ref image = Object(object);
  if (!Takes(node.op, OperandKind::kPlace)) {
    module_.Require(spv::Capability::ImageQuery);
    return Emit(spv::Op::OpImageQuerySize, types_.Of(result), {image});
  }
  const Ref place = Value(OperandOf(program_, node, OperandKind::kPlace));
  const Shape four = FourTexels(TypeAt(object));
  constexpr std::uint8_t kFirst[] = {0, 1, 2, 3};
  if (node.op != ObjectOp::kStore) {
    const std::uint32_t count = ShapeOf(program_.types[result]).size;
    const Ref texel = Emit(spv::Op::OpImageRead, types_.Of(four), {image, place});
    return Components(texel, four, std::span(kFirst).first(count));
  }
  const ExprId stored = OperandOf(program_, node, OperandKind::kValue);
  Words parts{Value(stored)};
  for (std::uint32_t i = ShapeAt(stored).size; i < 4; ++i)
    parts.push_back(types_.Splat(four.Component(), 0));
  const Ref texel = parts.size() == 1 ? parts[0] : Compose(types_.Of(four), parts);
  Do(spv::Op::OpImageWrite, {image, place, texel});
  return 0;
}

}  // namespace clipc::spirv
