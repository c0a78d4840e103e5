// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Constant buffers whose members lie where no block of Vulkan has them: an array of rows of four
// words, out of which values are put together.
#include <algorithm>

#include "backend-spirv/writer.h"
#include "ir/packing.h"

namespace clipc::spirv {

using namespace ir;

namespace {

constexpr std::uint32_t kWord = 4;  // bytes

std::uint32_t Rounded(std::uint32_t bytes) {
  return static_cast<std::uint32_t>(RoundUp(bytes, kRow));
}

}  // namespace

// The reading of values out of rows.
class RowReader {
 public:
  explicit RowReader(Writer& writer) : writer_(writer) {}
  Ref Load(const Place& place);

 private:
  Ref LoadRow(const Place& place, std::uint32_t offset);
  Ref LoadWord(const Place& place, std::uint32_t offset);
  Ref FromWords(Ref words, const Shape& shape);
  Ref VectorInRows(const Place& place, const Shape& shape, std::uint32_t stride);

  Writer& writer_;
};

Ref Writer::LoadInRows(const Place& place) { return RowReader(*this).Load(place); }

Ref Writer::RowsBlock(const Cbuffer& cbuffer, std::string_view name) {
  const Ref row = types_.Of(ShapeOf(Scalar::kUint, 1, 4));
  const std::uint32_t count = std::max(cbuffer.size / kRow, 1u);
  const Ref list = types_.ArrayInMemory(row, count, kRow);
  const Ref made = module_.OwnType(spv::Op::OpTypeStruct, std::span(&list, 1));
  module_.Name(made, name);
  module_.NameMember(made, 0, "rows");
  module_.Decorate(made, spv::Decoration::Block);
  module_.DecorateMember(made, 0, spv::Decoration::Offset, {0});
  return made;
}

// Moves the place by `index` times so many bytes: of whole rows, or of words in one row.
void Writer::MoveInRows(Place& place, ExprId index, std::uint32_t bytes) {
  if (const auto* number = As<Literal>(index)) {
    place.offset += static_cast<std::uint32_t>(number->bits) * bytes;
    return;
  }
  StepInRows(place, Converted(Value(index), ShapeAt(index), Scalar::kInt), bytes);
}

void Writer::StepInRows(Place& place, Ref steps, std::uint32_t bytes) {
  const Ref type = types_.Of(Scalar::kInt);
  const std::uint32_t unit = bytes % kRow == 0 ? kRow : kWord;
  if (bytes != unit) {
    const Ref each = types_.Int(static_cast<std::int32_t>(bytes / unit));
    steps = Emit(spv::Op::OpIMul, type, {steps, each});
  }
  Ref& sum = unit == kRow ? place.row : place.component;
  sum = sum == 0 ? steps : Emit(spv::Op::OpIAdd, type, {sum, steps});
}

// The element, row or component of a place in rows.
void Writer::ElementInRows(Place& place, ExprId index) {
  const Type& type = program_.types[place.type];
  const std::uint32_t size = ByteSize(type.scalar);
  if (type.kind == TypeKind::kArray) {
    MoveInRows(place, index, ArrayStride(program_.types, place.type, place.row_major));
  } else if (type.kind != TypeKind::kMatrix) {
    MoveInRows(place, index, place.stride != 0 ? place.stride : size);
  } else if (place.row_major) {
    MoveInRows(place, index, Rounded(size * type.columns));
  } else {
    MoveInRows(place, index, size);
    place.stride = Rounded(size * type.rows);
  }
}

// The row that holds a byte of the buffer.
Ref RowReader::LoadRow(const Place& place, std::uint32_t offset) {
  const Ref four = writer_.types_.Of(ShapeOf(Scalar::kUint, 1, 4));
  Ref number = writer_.types_.Int(static_cast<std::int32_t>(offset / kRow));
  if (place.row != 0)
    number = writer_.Emit(spv::Op::OpIAdd, writer_.types_.Of(Scalar::kInt), {place.row, number});
  Words operands{place.base};
  operands.insert(operands.end(), place.indices.begin(), place.indices.end());
  operands.push_back(writer_.types_.Int(0));
  operands.push_back(number);
  const Ref pointer = writer_.Marked(
      writer_.Emit(spv::Op::OpAccessChain, writer_.types_.Pointer(place.storage, four), operands),
      place.is_non_uniform);
  return writer_.Emit(spv::Op::OpLoad, four, {pointer});
}

Ref RowReader::LoadWord(const Place& place, std::uint32_t offset) {
  const Ref row = LoadRow(place, offset), word = writer_.types_.Of(Scalar::kUint);
  const std::uint32_t number = offset % kRow / kWord;
  if (place.component == 0) return writer_.Part(word, row, number);
  const Ref known = writer_.types_.Int(static_cast<std::int32_t>(number));
  const Ref at =
      writer_.Emit(spv::Op::OpIAdd, writer_.types_.Of(Scalar::kInt), {place.component, known});
  return writer_.Emit(spv::Op::OpVectorExtractDynamic, word, {row, at});
}

// Words as numbers of a kind.
Ref RowReader::FromWords(Ref words, const Shape& shape) {
  const Shape of_words = shape.With(Scalar::kUint);
  if (shape.scalar == Scalar::kBool) return writer_.Converted(words, of_words, Scalar::kBool);
  return shape.scalar == Scalar::kUint
             ? words
             : writer_.Emit(spv::Op::OpBitcast, writer_.types_.Of(shape), {words});
}

// A scalar or vector whose components are `stride` bytes apart.
Ref RowReader::VectorInRows(const Place& place, const Shape& shape, std::uint32_t stride) {
  const bool is_wide = IsWide(shape.scalar);
  const std::uint32_t begin = place.offset % kRow / kWord;
  if (!is_wide && stride == kWord && place.component == 0 && begin + shape.size <= 4) {
    constexpr std::uint8_t kAll[] = {0, 1, 2, 3};
    const Ref row = LoadRow(place, place.offset);
    return FromWords(writer_.Components(row, ShapeOf(Scalar::kUint, 1, 4),
                                        std::span(kAll).subspan(begin, shape.size)),
                     shape);
  }
  std::vector<Ref> components;
  for (std::uint32_t i = 0; i < shape.size; ++i) {
    const std::uint32_t offset = place.offset + i * stride;
    const Ref low = LoadWord(place, offset);
    if (!is_wide) {
      components.push_back(FromWords(low, shape.Component()));
      continue;
    }
    const Ref words[] = {low, LoadWord(place, offset + kWord)};
    const Ref both = writer_.Compose(writer_.types_.Of(ShapeOf(Scalar::kUint, 1, 2)), words);
    components.push_back(
        writer_.Emit(spv::Op::OpBitcast, writer_.types_.Of(shape.Component()), {both}));
  }
  return components.size() == 1 ? components[0]
                                : writer_.Compose(writer_.types_.Of(shape), components);
}

Ref RowReader::Load(const Place& place) {
  const Type& type = writer_.program_.types[place.type];
  std::vector<Ref> parts;
  if (type.kind == TypeKind::kStruct) {
    const auto count = writer_.program_.types.StructOf(place.type).fields.size();
    for (std::uint32_t i = 0; i < count; ++i) parts.push_back(Load(writer_.PlaceOfField(place, i)));
    return writer_.Compose(writer_.types_.Of(place.type), parts);
  }
  if (type.kind == TypeKind::kArray) {
    if (writer_.IsLong(place.type)) return writer_.LoadLong(place);
    Place element = place;
    element.type = type.element;
    for (std::uint32_t i = 0; i < type.count; ++i) {
      parts.push_back(Load(element));
      element.offset += ArrayStride(writer_.program_.types, place.type, place.row_major);
    }
    return writer_.Compose(writer_.types_.Of(place.type), parts);
  }
  const Shape shape = ShapeOf(type);
  const std::uint32_t size = ByteSize(type.scalar);
  if (type.kind != TypeKind::kMatrix)
    return VectorInRows(place, shape, place.stride != 0 ? place.stride : size);
  const std::uint32_t next = Rounded(size * (place.row_major ? type.columns : type.rows));
  if (!shape.HasRows()) {
    const bool lies_along = place.row_major ? type.rows == 1 : type.columns == 1;
    return VectorInRows(place, shape, lies_along ? size : next);
  }
  Place row = place;
  for (std::uint32_t i = 0; i < shape.rows; ++i) {
    parts.push_back(VectorInRows(row, shape.Row(), place.row_major ? size : next));
    row.offset += place.row_major ? next : size;
  }
  return writer_.Compose(writer_.types_.Of(shape), parts);
}

}  // namespace clipc::spirv
