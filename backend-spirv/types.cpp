// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "backend-spirv/types.h"

#include <array>
#include <bit>
#include <string>
#include <vector>

#include "base/invariant.h"
#include "ir/packing.h"
#include "ir/scalar.h"

namespace clipc::spirv {

using namespace ir;

namespace {

// The bytes from one row (column) of a matrix in memory to the next.
std::uint32_t RegisterStride(const Type& matrix, bool row_major, Layout layout) {
  const std::uint32_t length = row_major ? matrix.columns : matrix.rows;
  const std::uint32_t bytes = ByteSize(matrix.scalar) * length;
  return layout == Layout::kElements ? bytes : static_cast<std::uint32_t>(RoundUp(bytes, kRow));
}

struct FieldExtent {
  std::uint32_t offset, size;  // bytes
};
// The place of a field when the fields before it end at `end`.
FieldExtent ExtentOf(const TypeTable& types, const Field& field, std::uint32_t end, Layout layout) {
  if (layout == Layout::kConstants) {
    return {FieldPlace(types, field, end), PackedExtent(types, field.type, field.row_major).size};
  }
  const StructuredExtent extent = Structured(types, field.type);
  return {static_cast<std::uint32_t>(RoundUp(end, extent.alignment)), extent.size};
}

}  // namespace

Shape Shape::With(Scalar of) const {
  Shape shape = *this;
  shape.scalar = BaseOf(of);
  const bool is_floating = shape.IsFloating();
  if (kind == kMatrix && !is_floating) shape.kind = kRows;
  if (kind == kRows && is_floating) shape.kind = kMatrix;
  return shape;
}

Shape ShapeOf(Scalar scalar, std::uint32_t rows, std::uint32_t columns) {
  const Scalar base = BaseOf(scalar);
  if (rows == 1 || columns == 1) {
    const std::uint32_t size = rows * columns;
    return {size == 1 ? Shape::kScalar : Shape::kVector, base, 1, size};
  }
  return {IsFloat(base) ? Shape::kMatrix : Shape::kRows, base, rows, columns};
}

Shape ShapeOf(const Type& type) { return ShapeOf(type.scalar, type.rows, type.columns); }

Ref Types::Of(Scalar scalar) {
  switch (BaseOf(scalar)) {
    case Scalar::kBool: return module_.Type(spv::Op::OpTypeBool, {});
    case Scalar::kInt: return module_.Type(spv::Op::OpTypeInt, {32, 1});
    case Scalar::kUint: return module_.Type(spv::Op::OpTypeInt, {32, 0});
    case Scalar::kInt64:
      module_.Require(spv::Capability::Int64);
      return module_.Type(spv::Op::OpTypeInt, {64, 1});
    case Scalar::kUint64:
      module_.Require(spv::Capability::Int64);
      return module_.Type(spv::Op::OpTypeInt, {64, 0});
    case Scalar::kDouble:
      module_.Require(spv::Capability::Float64);
      return module_.Type(spv::Op::OpTypeFloat, {64});
    default: return module_.Type(spv::Op::OpTypeFloat, {32});
  }
}

Ref Types::Vector(Ref component, std::uint32_t size) {
  return size == 1 ? component : module_.Type(spv::Op::OpTypeVector, {component, size});
}

// Most instructions ask for one of a few types, so each is looked up once.
Ref Types::Of(const Shape& shape) {
  Ref& known = shapes_[static_cast<std::size_t>(BaseOf(shape.scalar))][shape.rows - 1]
                      [shape.size - 1][static_cast<std::size_t>(shape.kind)];
  if (known == 0) known = Make(shape);
  return known;
}

Ref Types::Make(const Shape& shape) {
  const Ref row = Vector(Of(shape.scalar), shape.size);
  switch (shape.kind) {
    case Shape::kMatrix: return module_.Type(spv::Op::OpTypeMatrix, {row, shape.rows});
    case Shape::kRows: return module_.Type(spv::Op::OpTypeArray, {row, Uint(shape.rows)});
    default: return row;
  }
}

Ref Types::Of(TypeId id) {
  const Type& type = program_.types[id];
  if (type.IsNumeric()) return Of(ShapeOf(type));
  if (type.kind == TypeKind::kVoid) return Void();
  if (type.kind == TypeKind::kArray) {
    const Ref element = Of(type.element);
    return module_.Type(spv::Op::OpTypeArray, {element, Uint(type.count)});
  }
  CLIPC_CHECK(type.kind == TypeKind::kStruct);
  if (const auto found = structs_.find(type.structure.index); found != structs_.end())
    return found->second;
  const Struct& structure = program_.types[type.structure];
  Words members;
  for (const Field& field : structure.fields) members.push_back(Of(field.type));
  if (members.empty()) members.push_back(Of(Scalar::kFloat));  // as in the GLSL: drivers want one
  const Ref made = module_.OwnType(spv::Op::OpTypeStruct, members);
  structs_.emplace(type.structure.index, made);
  module_.Name(made, structure.name);
  for (std::uint32_t i = 0; i < structure.fields.size(); ++i) {
    module_.NameMember(made, i, structure.fields[i].name);
    if (IsRelaxed(structure.fields[i].type))
      module_.DecorateMember(made, i, spv::Decoration::RelaxedPrecision);
  }
  return made;
}

Ref Types::Pointer(spv::StorageClass storage, Ref to) {
  return module_.Type(spv::Op::OpTypePointer, {static_cast<std::uint32_t>(storage), to});
}

bool Types::DiffersInMemory(TypeId id) const {
  const Type& type = program_.types[id];
  if (!type.IsNumeric()) return true;
  return BaseOf(type.scalar) == Scalar::kBool || ShapeOf(type).kind == Shape::kRows;
}

Ref Types::ArrayInMemory(Ref element, std::uint32_t count, std::uint32_t stride) {
  auto [found, is_new] = arrays_.try_emplace({element, count, stride}, 0);
  if (is_new) {
    if (count == 0)
      found->second = module_.OwnType(spv::Op::OpTypeRuntimeArray, std::span(&element, 1));
    else
      found->second = module_.OwnType(spv::Op::OpTypeArray, std::array{element, Uint(count)});
    module_.Decorate(found->second, spv::Decoration::ArrayStride, {stride});
  }
  return found->second;
}

Ref Types::InMemory(TypeId id, bool row_major, Layout layout) {
  if (layout == Layout::kValue) return Of(id);
  const Type& type = program_.types[id];
  if (type.IsNumeric()) {
    const Shape shape = InMemory(ShapeOf(type));
    if (shape.kind == Shape::kRows)
      return ArrayInMemory(Of(shape.Row()), shape.rows, RegisterStride(type, true, layout));
    return Of(shape);
  }
  if (type.kind == TypeKind::kArray) {
    const Ref element = InMemory(type.element, row_major, layout);
    const std::uint32_t stride = layout == Layout::kElements
                                     ? Structured(program_.types, type.element).size
                                     : ArrayStride(program_.types, id, row_major);
    return ArrayInMemory(element, type.count, stride);
  }
  return StructInMemory(type.structure, layout);
}

Ref Types::StructInMemory(StructId id, Layout layout) {
  const auto found = structs_in_memory_.find({id.index, layout});
  if (found != structs_in_memory_.end()) return found->second;
  const Ref made = NewStructInMemory(id, layout);
  structs_in_memory_.emplace(std::pair(id.index, layout), made);
  return made;
}

Ref Types::NewStructInMemory(StructId id, Layout layout) {
  const Struct& structure = program_.types[id];
  Words members;
  for (const Field& field : structure.fields)
    members.push_back(InMemory(field.type, field.row_major, layout));
  const Ref made = module_.OwnType(spv::Op::OpTypeStruct, members);
  module_.Name(made, structure.name);
  std::uint32_t end = 0;
  for (std::uint32_t i = 0; i < structure.fields.size(); ++i) {
    const Field& field = structure.fields[i];
    const auto [offset, size] = ExtentOf(program_.types, field, end, layout);
    end = offset + size;
    module_.NameMember(made, i, field.name);
    module_.DecorateMember(made, i, spv::Decoration::Offset, {offset});
    DecorateMatrix(made, i, field.type, field.row_major, layout);
  }
  return made;
}

// HLSL's rows are SPIR-V's columns.
void Types::DecorateMatrix(Ref structure, std::uint32_t member, TypeId id, bool row_major,
                           Layout layout) {
  const Type& type = program_.types[program_.types.Innermost(id)];
  if (!type.IsNumeric() || ShapeOf(type).kind != Shape::kMatrix) return;
  module_.DecorateMember(structure, member,
                         row_major ? spv::Decoration::ColMajor : spv::Decoration::RowMajor);
  module_.DecorateMember(structure, member, spv::Decoration::MatrixStride,
                         {RegisterStride(type, row_major, layout)});
}

Ref Types::Elements(TypeId element, bool row_major, std::string_view name, bool is_storage) {
  const std::uint32_t size = Structured(program_.types, element).size;
  const Ref list = ArrayInMemory(InMemory(element, row_major, Layout::kElements), 0, size);
  const Ref made = module_.OwnType(spv::Op::OpTypeStruct, std::span(&list, 1));
  module_.Name(made, std::string(name) + "_block");
  module_.NameMember(made, 0, "elements");
  module_.Decorate(made, is_storage ? spv::Decoration::Block : spv::Decoration::BufferBlock);
  module_.DecorateMember(made, 0, spv::Decoration::Offset, {0});
  DecorateMatrix(made, 0, element, row_major, Layout::kElements);
  return made;
}

Ref Types::Block(const Cbuffer& cbuffer, std::span<const std::uint32_t> kept,
                 std::string_view name) {
  if (cbuffer.kind == CbufferKind::kConstantBuffer) {
    const TypeId type = program_.types.Innermost(program_.vars[cbuffer.members[0].var].type);
    const Ref made = NewStructInMemory(program_.types[type].structure, Layout::kConstants);
    module_.Decorate(made, spv::Decoration::Block);
    return made;
  }
  Words members;
  for (const std::uint32_t member : kept) {
    const Var& var = program_.vars[cbuffer.members[member].var];
    members.push_back(InMemory(var.type, var.row_major, Layout::kConstants));
  }
  const Ref made = module_.OwnType(spv::Op::OpTypeStruct, members);
  module_.Name(made, name);
  module_.Decorate(made, spv::Decoration::Block);
  for (std::uint32_t i = 0; i < kept.size(); ++i) {
    const CbufferMember& member = cbuffer.members[kept[i]];
    const Var& var = program_.vars[member.var];
    module_.NameMember(made, i, var.name);
    module_.DecorateMember(made, i, spv::Decoration::Offset, {member.offset});
    DecorateMatrix(made, i, var.type, var.row_major, Layout::kConstants);
  }
  return made;
}

Ref Types::Uint(std::uint32_t value) {
  return module_.Constant(spv::Op::OpConstant, Of(Scalar::kUint), {value});
}
Ref Types::Int(std::int32_t value) {
  return module_.Constant(spv::Op::OpConstant, Of(Scalar::kInt),
                          {static_cast<std::uint32_t>(value)});
}
Ref Types::Float(float value) {
  return module_.Constant(spv::Op::OpConstant, Of(Scalar::kFloat),
                          {std::bit_cast<std::uint32_t>(value)});
}
Ref Types::Bool(bool value) {
  return module_.Constant(value ? spv::Op::OpConstantTrue : spv::Op::OpConstantFalse,
                          Of(Scalar::kBool));
}

Ref Types::Component(Scalar scalar, std::uint64_t bits) {
  const Scalar base = BaseOf(scalar);
  if (base == Scalar::kBool) return Bool(bits != 0);
  const auto low = static_cast<std::uint32_t>(bits), high = static_cast<std::uint32_t>(bits >> 32);
  if (IsWide(base)) return module_.Constant(spv::Op::OpConstant, Of(base), {low, high});
  return module_.Constant(spv::Op::OpConstant, Of(base), {low});
}

Ref Types::Composite(Ref type, std::span<const Ref> parts) {
  if (parts.empty()) return module_.Constant(spv::Op::OpConstantNull, type);
  return module_.Constant(spv::Op::OpConstantComposite, type, parts);
}

Ref Types::Splat(const Shape& shape, std::uint64_t bits) {
  if (shape.IsScalar()) return Component(shape.scalar, bits);
  const Ref part = Splat(shape.HasRows() ? shape.Row() : shape.Component(), bits);
  const std::vector<Ref> parts(shape.HasRows() ? shape.rows : shape.size, part);
  return Composite(Of(shape), parts);
}

Ref Types::Value(TypeId id, std::span<const std::uint64_t>& bits) {
  const Type& type = program_.types[id];
  const auto next = [&] {
    const std::uint64_t first = bits.front();
    bits = bits.subspan(1);
    return first;
  };
  std::vector<Ref> parts;
  if (type.IsNumeric()) {
    const Shape shape = ShapeOf(type);
    if (shape.IsScalar()) return Component(shape.scalar, next());
    const auto row = [&] {
      std::vector<Ref> components;
      for (std::uint32_t i = 0; i < shape.size; ++i)
        components.push_back(Component(shape.scalar, next()));
      return Composite(Of(shape.HasRows() ? shape.Row() : shape), components);
    };
    if (!shape.HasRows()) return row();
    for (std::uint32_t i = 0; i < shape.rows; ++i) parts.push_back(row());
  } else if (type.kind == TypeKind::kArray) {
    for (std::uint32_t i = 0; i < type.count; ++i) parts.push_back(Value(type.element, bits));
  } else {
    for (const Field& field : program_.types[type.structure].fields)
      parts.push_back(Value(field.type, bits));
  }
  return Composite(Of(id), parts);
}

std::uint64_t Types::OneOf(Scalar scalar) {
  switch (BaseOf(scalar)) {
    case Scalar::kFloat: return BitsOf(1.0f);
    case Scalar::kDouble: return BitsOf(1.0);
    default: return 1;
  }
}

}  // namespace clipc::spirv
