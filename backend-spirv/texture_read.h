// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "backend-spirv/writer.h"

namespace clipc::spirv {

// The operands of a sample, a fetch or a gather that follow those that each has: a mask, and what
// its bits name, in their order.
struct ImageOperands {
  std::uint32_t mask = 0;
  Words values = {};

  void Add(spv::ImageOperandsMask bit, std::initializer_list<Ref> operands) {
    mask |= NumberOf(bit);
    values.insert(values.end(), operands);
  }
  void AppendTo(Words& operands) const {
    if (mask == 0) return;
    operands.push_back(mask);
    operands.insert(operands.end(), values.begin(), values.end());
  }
};

// Whether it is a sampler that compares; none is not.
bool IsShadow(const ir::Program& program, ir::VarId sampler);

// The instruction that gives the status of a read too.
spv::Op SparseOf(spv::Op read);

// The writing of one read of a texture.
class TextureRead {
 public:
  TextureRead(Writer& writer, ir::TypeId result, const ir::ObjectCall& node);
  Ref Write();
  // Reads a texel of an image that may be written, which has one level.
  Ref WriteImageLoad();
  // Reads what an earlier subpass drew, where that is a texture.
  Ref WriteSubpassLoad();

 private:
  Ref WriteRead();
  Ref Sample();
  Ref SampleShadow();
  Ref Compare();
  Ref Gather();
  Ref GatherAt(ir::ExprId offset, Ref coordinate, Ref component);
  Ref Fetch();
  Ref Query();

  ir::ExprId At(ir::OperandKind kind) const;
  bool Has(ir::OperandKind kind) const { return bool(At(kind)); }
  Ref Operand(ir::OperandKind kind) { return writer_.Value(At(kind)); }
  // The coordinate of a projected read, divided by its last component.
  Ref Projected();
  // Adds the level of detail, the bias or the gradients. Returns whether they name the level, and
  // not the neighbours of the pixel.
  bool AddLevel(ImageOperands& to);
  // Adds the least level of detail.
  void AddClamp(ImageOperands& to);
  // Offsets are constants, but for those of gathers.
  void AddOffset(ImageOperands& to, ir::ExprId offset);
  // The texel or its first components, as the texture's element has them.
  Ref Narrow(Ref texel);
  Ref Sampled();
  // The image alone.
  Ref Image();
  Ref ReadBy(spv::Op op, const Shape& shape, Words operands, const ImageOperands& more);
  // Emits the read; in tiled resources, it writes the texel where the call says, and keeps its
  // status.
  Ref Read(spv::Op op, const Shape& shape, const Words& operands);
  Ref ReadTiled(spv::Op op, const Shape& shape, const Words& operands);

  Writer& writer_;
  ir::TypeId result_;
  const ir::ObjectCall& node_;
  const ir::Type& type_;  // of the texture
  const ir::ObjectInfo& info_;
  Shape four_;  // four components as the texture has them
  Ref image_ = 0;
  Ref status_ = 0;  // of a read in tiled resources that asks for it
};

}  // namespace clipc::spirv
