// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Textures and samplers. An image and its sampler are two variables, but for Direct3D 9's samplers.
#include <algorithm>

#include "backend-spirv/texture_read.h"

namespace clipc::spirv {

using namespace ir;

namespace {

spv::Dim DimensionOf(const ObjectInfo& info) {
  if (info.category == ObjectCategory::kTypedBuffer) return spv::Dim::Buffer;
  if (info.is_cube) return spv::Dim::Cube;
  if (info.axes == 1) return spv::Dim::Dim1D;
  return info.axes == 3 ? spv::Dim::Dim3D : spv::Dim::Dim2D;
}

}  // namespace

Ref Writer::ImageType(const Type& object) {
  const ObjectInfo& info = InfoOf(object.object);
  const Scalar scalar =
      object.element ? BaseOf(program_.types[object.element].scalar) : Scalar::kFloat;
  const spv::Dim dimension = DimensionOf(info);
  if (dimension == spv::Dim::Dim1D) module_.Require(spv::Capability::Sampled1D);
  if (dimension == spv::Dim::Buffer) module_.Require(spv::Capability::SampledBuffer);
  if (info.is_cube && info.is_array) module_.Require(spv::Capability::SampledCubeArray);
  constexpr std::uint32_t kMayCompare = 2, kIsSampled = 1;
  return module_.Type(spv::Op::OpTypeImage,
                      {types_.Of(scalar), NumberOf(dimension), kMayCompare, info.is_array,
                       info.is_multisampled, kIsSampled, NumberOf(spv::ImageFormat::Unknown)});
}

Ref Writer::ObjectType(TypeId id) {
  const Type& type = program_.types[id];
  const ObjectInfo& info = InfoOf(type.object);
  if (info.category == ObjectCategory::kSampler) return module_.Type(spv::Op::OpTypeSampler, {});
  const bool is_read =
      (info.category == ObjectCategory::kTexture || info.category == ObjectCategory::kTypedBuffer ||
       IsCombinedSampler(type.object)) &&
      !info.is_writable;
  if (!is_read) return Lack("an object that is not a texture");
  if (!IsCombinedSampler(type.object)) return ImageType(type);
  if (info.compares) return Lack("a sampler of Direct3D 9 that compares");
  return module_.Type(spv::Op::OpTypeSampledImage, {ImageType(type)});
}

Ref Writer::ObjectVariable(VarId id) {
  Ref& variable = objects_[id.index];
  if (variable != 0) return variable;
  const TypeId type = (*this)[id].type;
  const auto place = std::ranges::find(interface_.objects, id, &Interface::Object::var);
  if (place == interface_.objects.end()) return Lack("an object without a place");
  Ref of = ObjectType(program_.types.Innermost(type));
  std::vector<std::uint32_t> counts;
  for (const Type* part = &program_.types[type]; part->kind == TypeKind::kArray;
       part = &program_.types[part->element])
    counts.insert(counts.begin(), part->count);
  for (const std::uint32_t count : counts) {
    if (count == 0) return Lack("an array without a size");
    of = module_.Type(spv::Op::OpTypeArray, {of, types_.Uint(count)});
  }
  constexpr auto kStorage = spv::StorageClass::UniformConstant;
  variable = module_.Variable(types_.Pointer(kStorage, of), kStorage);
  module_.Name(variable, place->name);
  module_.Decorate(variable, spv::Decoration::DescriptorSet, {place->set});
  module_.Decorate(variable, spv::Decoration::Binding, {place->binding});
  if (module_.minor_version() >= 4) shared_.push_back(variable);
  return variable;
}

// Loads the object that a path names.
Ref Writer::Object(ExprId path) {
  std::vector<Ref> indices;
  for (ExprId part = path; const auto* index = As<Index>(part); part = index->base) {
    if (!As<Literal>(index->index)) return Lack("an array of objects with a varying index");
    indices.insert(indices.begin(), Value(index->index));
  }
  const Ref type = ObjectType((*this)[path].type);
  Ref pointer = ObjectVariable(RootOf(program_, path));
  if (!indices.empty()) {
    Words operands{pointer};
    operands.insert(operands.end(), indices.begin(), indices.end());
    const Ref to = types_.Pointer(spv::StorageClass::UniformConstant, type);
    pointer = Emit(spv::Op::OpAccessChain, to, operands);
  }
  return Emit(spv::Op::OpLoad, type, {pointer});
}

Ref Writer::ObjectCall(TypeId result, const clipc::ir::ObjectCall& node) {
  if (node.has_clamp || node.has_texel) return Lack("a read of tiled resources");
  const ExprId object = OperandOf(program_, node, OperandKind::kObject);
  const ObjectCategory category = InfoOf(TypeAt(object).object).category;
  if (InfoOf(TypeAt(object).object).is_writable) return Lack("a writable object");
  if (category != ObjectCategory::kTexture && category != ObjectCategory::kCombinedSampler &&
      category != ObjectCategory::kTypedBuffer)
    return Lack("an object that is not a texture");
  return TextureRead(*this, result, node).Write();
}

}  // namespace clipc::spirv
