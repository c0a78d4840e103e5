// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-spirv/texture_read.h"

#include <utility>

#include "ir/evaluate.h"

namespace clipc::spirv {

using namespace ir;

namespace {

constexpr std::uint8_t kFirst[] = {0, 1, 2, 3};
constexpr Shape kNumber{};

}  // namespace

spv::Op SparseOf(spv::Op read) {
  using enum spv::Op;
  switch (read) {
    case OpImageSampleImplicitLod: return OpImageSparseSampleImplicitLod;
    case OpImageSampleExplicitLod: return OpImageSparseSampleExplicitLod;
    case OpImageSampleDrefImplicitLod: return OpImageSparseSampleDrefImplicitLod;
    case OpImageSampleDrefExplicitLod: return OpImageSparseSampleDrefExplicitLod;
    case OpImageFetch: return OpImageSparseFetch;
    case OpImageGather: return OpImageSparseGather;
    case OpImageDrefGather: return OpImageSparseDrefGather;
    default: return OpImageSparseRead;
  }
}

TextureRead::TextureRead(Writer& writer, TypeId result, const ir::ObjectCall& node)
    : writer_(writer),
      result_(result),
      node_(node),
      type_(writer.TypeAt(OperandOf(writer.program_, node, OperandKind::kObject))),
      info_(InfoOf(type_.object)),
      four_(writer.FourTexels(type_)) {}

Ref TextureRead::Write() {
  const Ref value = WriteRead();
  return node_.has_texel ? status_ : value;
}

Ref TextureRead::WriteRead() {
  image_ = writer_.Object(At(OperandKind::kObject), At(OperandKind::kSampler));
  switch (InfoOf(node_.op).result) {
    case ObjectResult::kFourTexels: return Gather();
    case ObjectResult::kElement: return Takes(node_.op, OperandKind::kPlace) ? Fetch() : Sample();
    case ObjectResult::kFloat:
      if (Takes(node_.op, OperandKind::kReference)) return Compare();
      break;
    default: break;
  }
  return Query();
}

ExprId TextureRead::At(OperandKind kind) const { return OperandOf(writer_.program_, node_, kind); }

Ref TextureRead::Narrow(Ref texel) {
  if (node_.has_texel) return texel;
  const Shape result = ShapeOf(writer_.program_.types[result_]);
  const Ref value = writer_.Components(texel, four_, std::span(kFirst).first(result.size));
  return writer_.Converted(value, ShapeOf(four_.scalar, 1, result.size), result.scalar);
}

Ref TextureRead::Sampled() {
  if (IsCombinedSampler(type_.object) || writer_.options_.is_opengl) return image_;
  const ExprId texture = At(OperandKind::kObject), sampler_path = At(OperandKind::kSampler);
  const Ref sampler = writer_.Object(sampler_path);
  const Ref type = writer_.module_.Type(spv::Op::OpTypeSampledImage, {writer_.ImageType(type_)});
  return writer_.Marked(writer_.Emit(spv::Op::OpSampledImage, type, {image_, sampler}),
                        writer_.IsNonUniform(texture) || writer_.IsNonUniform(sampler_path));
}

bool TextureRead::AddLevel(ImageOperands& to) {
  using enum spv::ImageOperandsMask;
  if (Has(OperandKind::kBias)) {
    to.Add(Bias, {Operand(OperandKind::kBias)});
    return false;
  }
  if (Has(OperandKind::kLevel)) {
    to.Add(Lod, {Operand(OperandKind::kLevel)});
    return true;
  }
  if (Has(OperandKind::kDdx)) {
    const Ref ddx = Operand(OperandKind::kDdx), ddy = Operand(OperandKind::kDdy);
    to.Add(Grad, {ddx, ddy});
    return true;
  }
  const bool has_neighbours = InfoOf(writer_.program_.stage).has_neighbours;
  if (has_neighbours && node_.op != ObjectOp::kSampleCmpLevelZero) return false;
  to.Add(Lod, {writer_.types_.Float(0)});
  return true;
}

void TextureRead::AddOffset(ImageOperands& to, ExprId offset) {
  if (!offset) return;
  const auto bits = ConstantBits(writer_.program_, offset);
  if (!bits) {
    writer_.module_.Require(spv::Capability::ImageGatherExtended);
    return to.Add(spv::ImageOperandsMask::Offset, {writer_.Value(offset)});
  }
  std::span<const std::uint64_t> left(*bits);
  to.Add(spv::ImageOperandsMask::ConstOffset, {writer_.types_.Value(writer_[offset].type, left)});
}

void TextureRead::AddClamp(ImageOperands& to) {
  if (!node_.has_clamp) return;
  writer_.module_.Require(spv::Capability::MinLod);
  to.Add(spv::ImageOperandsMask::MinLod, {Operand(OperandKind::kClamp)});
}

Ref TextureRead::Projected() {
  const Ref whole = Operand(OperandKind::kCoordinate);
  const std::uint32_t axes = info_.axes == 0 ? 2 : info_.axes;
  const Shape four = ShapeOf(Scalar::kFloat, 1, 4), place = ShapeOf(Scalar::kFloat, 1, axes);
  const Ref divisor = writer_.Part(writer_.types_.Of(kNumber), whole, 3);
  return writer_.Combine(BinaryOp::kDiv, place,
                         writer_.Components(whole, four, std::span(kFirst).first(axes)),
                         writer_.Splat(place, divisor));
}

Ref TextureRead::Image() {
  if (!writer_.options_.is_opengl) return image_;
  const VarId texture = RootOf(writer_.program_, At(OperandKind::kObject));
  const Interface::Object* place = writer_.PlaceOfObject(texture, VarId{});
  const bool is_shadow = place && IsShadow(writer_.program_, place->sampler);
  return writer_.Emit(spv::Op::OpImage, writer_.ImageType(type_, {}, is_shadow), {image_});
}

// The instruction that takes the texture with its sampler, and these operands. Both are put
// together last, since they must be in the block that uses them.
Ref TextureRead::ReadBy(spv::Op op, const Shape& shape, Words operands, const ImageOperands& more) {
  operands.insert(operands.begin(), Sampled());
  more.AppendTo(operands);
  return Read(op, shape, operands);
}

Ref TextureRead::Read(spv::Op op, const Shape& shape, const Words& operands) {
  return node_.has_texel ? ReadTiled(op, shape, operands)
                         : writer_.Emit(op, writer_.types_.Of(shape), operands);
}

Ref TextureRead::ReadTiled(spv::Op op, const Shape& shape, const Words& operands) {
  writer_.module_.Require(spv::Capability::SparseResidency);
  const Ref texel = writer_.types_.Of(shape), status = writer_.types_.Of(result_);
  const Ref both = writer_.module_.Type(spv::Op::OpTypeStruct, {status, texel});
  const Ref read = writer_.Emit(SparseOf(op), both, operands);
  const Ref value = writer_.Part(texel, read, 1);
  writer_.Store(writer_.PlaceOf(At(OperandKind::kTexel)), value);
  status_ = writer_.Part(status, read, 0);
  return value;
}

// A read by a sampler of Direct3D 9 whose texture is compared with the third coordinate.
Ref TextureRead::SampleShadow() {
  const ExprId operand = At(OperandKind::kCoordinate);
  const Shape whole = writer_.ShapeAt(operand), three = ShapeOf(Scalar::kFloat, 1, 3);
  Ref place = writer_.Value(operand);
  if (node_.op == ObjectOp::kD3d9SampleProjected) {
    const Ref divisor = writer_.Part(writer_.types_.Of(kNumber), place, 3);
    place = writer_.Combine(BinaryOp::kDiv, three,
                            writer_.Components(place, whole, std::span(kFirst).first(3)),
                            writer_.Splat(three, divisor));
  }
  const Shape of = node_.op == ObjectOp::kD3d9SampleProjected ? three : whole;
  Words operands{writer_.Components(place, of, std::span(kFirst).first(2)),
                 writer_.Part(writer_.types_.Of(kNumber), place, 2)};
  ImageOperands more;
  const bool is_explicit = AddLevel(more);
  return ReadBy(
      is_explicit ? spv::Op::OpImageSampleDrefExplicitLod : spv::Op::OpImageSampleDrefImplicitLod,
      kNumber, std::move(operands), more);
}

Ref TextureRead::Sample() {
  if (IsCombinedSampler(type_.object) && info_.compares) return SampleShadow();
  Words operands{node_.op == ObjectOp::kD3d9SampleProjected ? Projected()
                                                            : Operand(OperandKind::kCoordinate)};
  ImageOperands more;
  const bool is_explicit = AddLevel(more);
  AddOffset(more, At(OperandKind::kOffset));
  AddClamp(more);
  return Narrow(
      ReadBy(is_explicit ? spv::Op::OpImageSampleExplicitLod : spv::Op::OpImageSampleImplicitLod,
             four_, std::move(operands), more));
}

Ref TextureRead::Compare() {
  const Ref coordinate = Operand(OperandKind::kCoordinate);
  Words operands{coordinate, Operand(OperandKind::kReference)};
  ImageOperands more;
  const bool is_explicit = AddLevel(more);
  AddOffset(more, At(OperandKind::kOffset));
  AddClamp(more);
  return ReadBy(
      is_explicit ? spv::Op::OpImageSampleDrefExplicitLod : spv::Op::OpImageSampleDrefImplicitLod,
      kNumber, std::move(operands), more);
}

Ref TextureRead::GatherAt(ExprId offset, Ref coordinate, Ref component) {
  const bool compares = node_.op == ObjectOp::kGatherCmp;
  ImageOperands more;
  AddOffset(more, offset);
  return ReadBy(compares ? spv::Op::OpImageDrefGather : spv::Op::OpImageGather, four_,
                {coordinate, component}, more);
}

Ref TextureRead::Gather() {
  const Ref coordinate = Operand(OperandKind::kCoordinate);
  const Ref component = node_.op == ObjectOp::kGatherCmp
                            ? Operand(OperandKind::kReference)
                            : writer_.types_.Int(ComponentOf(node_.op));
  const List<ExprId> offsets = OperandsOf(node_, OperandKind::kOffset);
  if (offsets.size > 1 && node_.has_texel) return writer_.Lack("the status of four gathers");
  if (offsets.size <= 1) return GatherAt(At(OperandKind::kOffset), coordinate, component);
  // Component i is that of the gather with offset i.
  std::vector<Ref> texels;
  const Ref type = writer_.types_.Of(four_.Component());
  for (std::uint32_t i = 0; i < offsets.size; ++i) {
    const Ref four = GatherAt(writer_.program_.expr_lists[offsets][i], coordinate, component);
    texels.push_back(writer_.Part(type, four, i));
  }
  return writer_.Compose(writer_.types_.Of(four_), texels);
}

Ref TextureRead::WriteImageLoad() {
  image_ = writer_.Object(At(OperandKind::kObject));
  const Ref texel =
      Narrow(Read(spv::Op::OpImageRead, four_, {image_, Operand(OperandKind::kPlace)}));
  return node_.has_texel ? status_ : texel;
}

// The pixel's own texel. The texture's rows are counted as OpenGL counts those of the window.
Ref TextureRead::WriteSubpassLoad() {
  image_ = writer_.Object(At(OperandKind::kObject));
  const Shape whole = ShapeOf(Scalar::kFloat, 1, 4), two = ShapeOf(Scalar::kFloat, 1, 2);
  const Ref image = Image(), int2 = writer_.types_.Of(two.With(Scalar::kInt));
  Ref pixel = writer_.Components(writer_.LoadBuiltin(Builtin::kPixelPosition), whole,
                                 std::span(kFirst).first(2));
  if (!writer_.options_.has_upper_left_origin) {
    writer_.module_.Require(spv::Capability::ImageQuery);
    const Ref size = info_.is_multisampled ? writer_.Emit(spv::Op::OpImageQuerySize, int2, {image})
                                           : writer_.Emit(spv::Op::OpImageQuerySizeLod, int2,
                                                          {image, writer_.types_.Int(0)});
    const Ref number = writer_.types_.Of(kNumber);
    const Ref rows =
        writer_.Part(number, writer_.Converted(size, two.With(Scalar::kInt), Scalar::kFloat), 1);
    const Ref row = writer_.Emit(spv::Op::OpFSub, number, {rows, writer_.Part(number, pixel, 1)});
    pixel = writer_.Emit(spv::Op::OpCompositeInsert, writer_.types_.Of(two), {row, pixel, 1});
  }
  Words operands{image, writer_.Emit(spv::Op::OpConvertFToS, int2, {pixel})};
  ImageOperands more;
  if (Has(OperandKind::kSample))
    more.Add(spv::ImageOperandsMask::Sample, {Operand(OperandKind::kSample)});
  else
    more.Add(spv::ImageOperandsMask::Lod, {writer_.types_.Int(0)});
  more.AppendTo(operands);
  return Narrow(writer_.Emit(spv::Op::OpImageFetch, writer_.types_.Of(four_), operands));
}

// Reads a texel. The level of a multisampled texture is the number of the sample.
Ref TextureRead::Fetch() {
  Words operands{Image(), Operand(OperandKind::kPlace)};
  ImageOperands more;
  const Ref level = Has(OperandKind::kLevel) ? Operand(OperandKind::kLevel) : 0;
  if (level != 0 && !info_.is_multisampled) more.Add(spv::ImageOperandsMask::Lod, {level});
  AddOffset(more, At(OperandKind::kOffset));
  if (level != 0 && info_.is_multisampled) more.Add(spv::ImageOperandsMask::Sample, {level});
  more.AppendTo(operands);
  return Narrow(Read(spv::Op::OpImageFetch, four_, operands));
}

Ref TextureRead::Query() {
  writer_.module_.Require(spv::Capability::ImageQuery);
  const Ref type = writer_.types_.Of(result_);
  switch (node_.op) {
    case ObjectOp::kTextureLevels:
      return writer_.Emit(spv::Op::OpImageQueryLevels, type, {Image()});
    case ObjectOp::kTextureSamples:
      return writer_.Emit(spv::Op::OpImageQuerySamples, type, {Image()});
    case ObjectOp::kLevelOfDetail:
    case ObjectOp::kLevelOfDetailUnclamped: {
      const Ref two = writer_.types_.Of(ShapeOf(Scalar::kFloat, 1, 2));
      const Ref source = Sampled();
      const Ref both =
          writer_.Emit(spv::Op::OpImageQueryLod, two, {source, Operand(OperandKind::kCoordinate)});
      return writer_.Part(type, both, node_.op == ObjectOp::kLevelOfDetail ? 0 : 1);
    }
    default: break;
  }
  const bool has_level = info_.category == ObjectCategory::kTexture && !info_.is_multisampled;
  if (!has_level) return writer_.Emit(spv::Op::OpImageQuerySize, type, {Image()});
  return writer_.Emit(spv::Op::OpImageQuerySizeLod, type, {Image(), Operand(OperandKind::kLevel)});
}

}  // namespace clipc::spirv
