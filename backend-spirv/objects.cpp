// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Textures, samplers and buffers. An image and its sampler are two variables, but for Direct3D 9's
// samplers.
#include <algorithm>

#include "backend-spirv/image_format.h"
#include "backend-spirv/texture_read.h"

namespace clipc::spirv {

using namespace ir;

namespace {

// OpenGL has no subpasses: what was drawn is bound as a texture.
spv::Dim DimensionOf(const ObjectInfo& info, bool is_opengl) {
  if (info.category == ObjectCategory::kTypedBuffer) return spv::Dim::Buffer;
  if (info.category == ObjectCategory::kSubpass && !is_opengl) return spv::Dim::SubpassData;
  if (info.is_cube) return spv::Dim::Cube;
  if (info.axes == 1) return spv::Dim::Dim1D;
  return info.axes == 3 ? spv::Dim::Dim3D : spv::Dim::Dim2D;
}

}  // namespace

spv::Capability NonUniformOf(ObjectKind object) {
  const ObjectInfo& info = InfoOf(object);
  const bool is_buffer = info.category == ObjectCategory::kTypedBuffer;
  using enum spv::Capability;
  if (info.category == ObjectCategory::kSubpass) return InputAttachmentArrayNonUniformIndexing;
  if (IsStorageBuffer(object)) return StorageBufferArrayNonUniformIndexing;
  if (info.is_writable)
    return is_buffer ? StorageTexelBufferArrayNonUniformIndexing
                     : StorageImageArrayNonUniformIndexing;
  return is_buffer ? UniformTexelBufferArrayNonUniformIndexing
                   : SampledImageArrayNonUniformIndexing;
}

bool IsShadow(const Program& program, VarId sampler) {
  return sampler &&
         InfoOf(program.types[program.types.Innermost(program.vars[sampler].type)].object).compares;
}

// Four components as the texels of a texture or a typed buffer have them: other kinds than integers
// are floats.
Shape Writer::FourTexels(const Type& object) const {
  const Scalar of = object.element ? BaseOf(program_.types[object.element].scalar) : Scalar::kFloat;
  const bool is_whole = of == Scalar::kInt || of == Scalar::kUint;
  return ShapeOf(is_whole ? of : Scalar::kFloat, 1, 4);
}

// The type of an image, of the format where it is written, else as a texture.
Ref Writer::ImageType(const Type& object, std::string_view format, bool is_shadow) {
  const ObjectInfo& info = InfoOf(object.object);
  const spv::Dim dimension = DimensionOf(info, options_.is_opengl);
  if (object.element && IsInteger(program_.types[object.element].scalar) &&
      IsWide(program_.types[object.element].scalar))
    return Lack("texels of 64 bits");
  const bool is_subpass = dimension == spv::Dim::SubpassData;
  const bool is_image = info.is_writable || is_subpass;
  using enum spv::Capability;
  if (dimension == spv::Dim::Dim1D) module_.Require(is_image ? Image1D : Sampled1D);
  if (dimension == spv::Dim::Buffer) module_.Require(is_image ? ImageBuffer : SampledBuffer);
  if (info.is_cube && info.is_array) module_.Require(is_image ? ImageCubeArray : SampledCubeArray);
  const spv::ImageFormat of = FormatOf(format);
  if (is_subpass) module_.Require(InputAttachment);
  if (info.is_writable && !IsBasic(of)) module_.Require(StorageImageExtendedFormats);
  constexpr std::uint32_t kNeverCompares = 0, kMayCompare = 2, kIsSampled = 1, kIsStorage = 2;
  const std::uint32_t compares = options_.is_opengl ? is_shadow : kMayCompare;
  return module_.Type(spv::Op::OpTypeImage,
                      {types_.Of(FourTexels(object).scalar), NumberOf(dimension),
                       is_image ? kNeverCompares : compares, info.is_array, info.is_multisampled,
                       is_image ? kIsStorage : kIsSampled, NumberOf(of)});
}

// The type of an object, or the block of a structured buffer.
Ref Writer::ObjectType(TypeId id, const Interface::Object& place) {
  const Type& type = program_.types[id];
  const ObjectInfo& info = InfoOf(type.object);
  switch (info.category) {
    case ObjectCategory::kSampler: return module_.Type(spv::Op::OpTypeSampler, {});
    case ObjectCategory::kTexture:
    case ObjectCategory::kSubpass:
    case ObjectCategory::kTypedBuffer: {
      const Ref image = ImageType(type, place.format, IsShadow(program_, place.sampler));
      const bool is_together = options_.is_opengl && !info.is_writable;
      return is_together ? module_.Type(spv::Op::OpTypeSampledImage, {image}) : image;
    }
    case ObjectCategory::kCombinedSampler:
      return module_.Type(spv::Op::OpTypeSampledImage, {ImageType(type, {}, info.compares)});
    case ObjectCategory::kStructuredBuffer: return BufferBlock(type, place);
    default: return Lack("an object of another kind");
  }
}

// The place of an object. OpenGL has one for a texture with each of its samplers; a read without a
// sampler goes through any that does not compare.
const Interface::Object* Writer::PlaceOfObject(VarId id, VarId sampler) const {
  const Interface::Object* found = nullptr;
  for (const Interface::Object& object : interface_.objects) {
    if (object.var != id) continue;
    if (object.sampler == sampler) return &object;
    if (!found && !IsShadow(program_, object.sampler)) found = &object;
  }
  return found;
}

const DeclaredObject& Writer::DeclaredOf(VarId id, VarId sampler) {
  const Interface::Object* place = PlaceOfObject(id, options_.is_opengl ? sampler : VarId{});
  const std::uint32_t with = place && place->sampler ? place->sampler.index + 1 : 0;
  DeclaredObject& declared = objects_[{id.index, with}];
  if (declared.variable != 0) return declared;
  const Var& var = (*this)[id];
  if (!place || !place->binding) {
    declared.variable = Lack("an object without a place");
    return declared;
  }
  const Type& object = program_.types[program_.types.Innermost(var.type)];
  declared.type = ObjectType(program_.types.Innermost(var.type), *place);
  declared.storage = !IsStorageBuffer(object.object) ? spv::StorageClass::UniformConstant
                     : HasStorageClass()             ? spv::StorageClass::StorageBuffer
                                                     : spv::StorageClass::Uniform;
  Ref of = declared.type;
  std::vector<std::uint32_t> counts;
  for (const Type* part = &program_.types[var.type]; part->kind == TypeKind::kArray;
       part = &program_.types[part->element])
    counts.insert(counts.begin(), part->count);
  for (const std::uint32_t count : counts) {
    if (count > 0) {
      of = module_.Type(spv::Op::OpTypeArray, {of, types_.Uint(count)});
      continue;
    }
    module_.Require(spv::Capability::RuntimeDescriptorArray);
    RequireDescriptorIndexing();
    of = module_.Type(spv::Op::OpTypeRuntimeArray, {of});
  }
  declared.variable = module_.Variable(types_.Pointer(declared.storage, of), declared.storage);
  module_.Name(declared.variable, place->name);
  Bind(declared.variable, *place);
  NameType(declared.variable, place->user_type);
  if (place->input_attachment && !options_.is_opengl)
    module_.Decorate(declared.variable, spv::Decoration::InputAttachmentIndex,
                     {*place->input_attachment});
  if (var.coherent && IsImage(object.object))
    module_.Decorate(declared.variable, spv::Decoration::Coherent);
  if (module_.minor_version() >= 4) shared_.push_back(declared.variable);
  return declared;
}

void Writer::RequireDescriptorIndexing() {
  if (module_.minor_version() < 5) module_.Require("SPV_EXT_descriptor_indexing");
}

// The indices of a path to an element of an array of objects.
std::vector<Ref> Writer::IndicesOf(ExprId path) {
  std::vector<Ref> indices;
  for (const Index* index = As<Index>(path); index; index = As<Index>(index->base))
    indices.insert(indices.begin(), Value(index->index));
  return indices;
}

// Whether the object differs between invocations, as NonUniformResourceIndex says.
bool Writer::IsNonUniform(ExprId path) const {
  if (options_.is_opengl) return false;
  for (const Index* index = As<Index>(path); index; index = As<Index>(index->base)) {
    const auto* mark = As<IntrinsicCall>(index->index);
    if (mark && mark->op == CommonIntrinsic::kNonUniform) return true;
  }
  return false;
}

Ref Writer::Marked(Ref value, bool is_non_uniform) {
  if (is_non_uniform) module_.Decorate(value, spv::Decoration::NonUniform);
  return value;
}

void Writer::RequireNonUniform(spv::Capability capability) {
  RequireDescriptorIndexing();
  module_.Require(spv::Capability::ShaderNonUniform);
  module_.Require(capability);
}

// The pointer to the object that a path names.
Ref Writer::ObjectPointer(ExprId path, ExprId sampler) {
  const std::vector<Ref> indices = IndicesOf(path);
  const DeclaredObject& declared =
      DeclaredOf(RootOf(program_, path), sampler ? RootOf(program_, sampler) : VarId{});
  if (indices.empty()) return declared.variable;
  Words operands{declared.variable};
  operands.insert(operands.end(), indices.begin(), indices.end());
  const bool is_non_uniform = IsNonUniform(path);
  if (is_non_uniform) RequireNonUniform(NonUniformOf(TypeAt(path).object));
  return Marked(
      Emit(spv::Op::OpAccessChain, types_.Pointer(declared.storage, declared.type), operands),
      is_non_uniform);
}

// Loads the object that a path names.
Ref Writer::Object(ExprId path, ExprId sampler) {
  const Ref pointer = ObjectPointer(path, sampler);
  const Ref type =
      DeclaredOf(RootOf(program_, path), sampler ? RootOf(program_, sampler) : VarId{}).type;
  return Marked(Emit(spv::Op::OpLoad, type, {pointer}), IsNonUniform(path));
}

Ref Writer::ObjectCall(TypeId result, const clipc::ir::ObjectCall& node) {
  const ExprId object = OperandOf(program_, node, OperandKind::kObject);
  const ObjectInfo& info = InfoOf(TypeAt(object).object);
  switch (info.category) {
    case ObjectCategory::kTexture:
    case ObjectCategory::kTypedBuffer:
      return info.is_writable ? ImageCall(result, node) : TextureRead(*this, result, node).Write();
    case ObjectCategory::kCombinedSampler: return TextureRead(*this, result, node).Write();
    case ObjectCategory::kStructuredBuffer: return BufferCall(result, node);
    case ObjectCategory::kSubpass:
      return options_.is_opengl ? TextureRead(*this, result, node).WriteSubpassLoad()
                                : SubpassLoad(result, node);
    default: return Lack("an object of another kind");
  }
}

}  // namespace clipc::spirv
