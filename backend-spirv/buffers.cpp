// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Structured buffers, which byte address buffers are too: blocks with an array of elements.
#include "backend-spirv/writer.h"
#include "ir/intrinsic_list.h"
#include "ir/scalar.h"

namespace clipc::spirv {

using namespace ir;

namespace {

struct AtomicInstructions {
  spv::Op of_int, of_uint;
};

AtomicInstructions InstructionsOf(ObjectOp op) {
  using enum spv::Op;
  switch (op) {
    case ObjectOp::kAtomicAdd: return {OpAtomicIAdd, OpAtomicIAdd};
    case ObjectOp::kAtomicAnd: return {OpAtomicAnd, OpAtomicAnd};
    case ObjectOp::kAtomicOr: return {OpAtomicOr, OpAtomicOr};
    case ObjectOp::kAtomicXor: return {OpAtomicXor, OpAtomicXor};
    case ObjectOp::kAtomicMin: return {OpAtomicSMin, OpAtomicUMin};
    case ObjectOp::kAtomicMax: return {OpAtomicSMax, OpAtomicUMax};
    case ObjectOp::kAtomicExchange: return {OpAtomicExchange, OpAtomicExchange};
    default: return {OpAtomicCompareExchange, OpAtomicCompareExchange};
  }
}

// The operation of objects that does the same.
ObjectOp SameOfObjects(ir::Intrinsic op) {
  using enum ir::Intrinsic;
  switch (op) {
    case kInterlockedAdd: return ObjectOp::kAtomicAdd;
    case kInterlockedAnd: return ObjectOp::kAtomicAnd;
    case kInterlockedOr: return ObjectOp::kAtomicOr;
    case kInterlockedXor: return ObjectOp::kAtomicXor;
    case kInterlockedMin: return ObjectOp::kAtomicMin;
    case kInterlockedMax: return ObjectOp::kAtomicMax;
    case kInterlockedExchange: return ObjectOp::kAtomicExchange;
    default: return ObjectOp::kAtomicCompareExchange;
  }
}

}  // namespace

Ref Writer::BufferBlock(const Type& buffer, const Interface::Object& place) {
  const Var& var = (*this)[place.var];
  const Ref block = types_.Elements(buffer.element, var.row_major, place.name, HasStorageClass());
  if (var.coherent)
    module_.DecorateMember(block, 0, spv::Decoration::Coherent);
  else if (!IsWritable(buffer.object))
    module_.DecorateMember(block, 0, spv::Decoration::NonWritable);
  return block;
}

// The element of a structured buffer that a call reads, writes or changes.
Place Writer::ElementPlace(const clipc::ir::ObjectCall& node) {
  const ExprId object = OperandOf(program_, node, OperandKind::kObject);
  const VarId root = RootOf(program_, object);
  const DeclaredObject& declared = DeclaredOf(root);
  Place place{.base = declared.variable,
              .storage = declared.storage,
              .indices = IndicesOf(object),
              .type = TypeAt(object).element,
              .layout = Layout::kElements,
              .row_major = (*this)[root].row_major,
              .is_non_uniform = IsNonUniform(object)};
  if (place.is_non_uniform) RequireNonUniform(NonUniformOf(TypeAt(object).object));
  place.indices.push_back(types_.Int(0));
  place.indices.push_back(Value(OperandOf(program_, node, OperandKind::kPlace)));
  return place;
}

// Follows the steps of a store or an atomic operation, ir/ops.def.
StoredPart Writer::PartAlong(const clipc::ir::ObjectCall& node) {
  StoredPart part{.place = ElementPlace(node)};
  Place& place = part.place;
  const ExprId stored = OperandOf(program_, node, OperandKind::kValue);
  const std::uint32_t count = TypeAt(stored).Components();
  bool follows_row_number = false;  // of a matrix that is a vector here
  for (const ExprId step : (*this)[OperandsOf(node, OperandKind::kStep)]) {
    const Type& type = program_.types[place.type];
    const bool is_matrix = type.kind == TypeKind::kMatrix && !part.is_row && !follows_row_number;
    if (type.kind == TypeKind::kStruct) {
      const auto field = static_cast<std::uint32_t>(As<Literal>(step)->bits);
      const Field& to = program_.types.StructOf(place.type).fields[field];
      place.indices.push_back(types_.Int(static_cast<std::int32_t>(field)));
      place.row_major = to.row_major;
      place.type = to.type;
    } else if (type.kind == TypeKind::kArray) {
      place.indices.push_back(Value(step));
      place.type = type.element;
    } else if (is_matrix && ShapeOf(type).HasRows()) {
      place.indices.push_back(Value(step));
      part.is_row = true;
    } else {
      const std::uint32_t size = is_matrix ? type.rows : type.columns;
      if (size > 1 && count < size) {
        part.first = Value(step);
        const auto* number = As<Literal>(step);
        part.known = number ? UintOf(number->bits) : 0;
      }
      follows_row_number = is_matrix;
    }
  }
  return part;
}

// The pointer to the component that comes `number` after the first one of the part.
Ref Writer::ComponentPointer(const StoredPart& part, std::uint32_t number) {
  const Type& type = program_.types[part.place.type];
  const Ref component = types_.Of(Types::InMemory(ShapeOf(type).Component()));
  Words operands{part.place.base};
  operands.insert(operands.end(), part.place.indices.begin(), part.place.indices.end());
  if (part.first != 0)
    operands.push_back(number == 0 ? part.first
                                   : types_.Int(static_cast<std::int32_t>(part.known + number)));
  return Marked(
      Emit(spv::Op::OpAccessChain, types_.Pointer(part.place.storage, component), operands),
      part.place.is_non_uniform);
}

// Several components are stored one by one: other invocations may store those beside them.
void Writer::StoreInBuffer(const clipc::ir::ObjectCall& node) {
  const StoredPart part = PartAlong(node);
  const ExprId stored = OperandOf(program_, node, OperandKind::kValue);
  const Ref value = Value(stored);
  const TypeId type = (*this)[stored].type;
  if (part.first == 0) {
    Place place = part.place;
    place.type = type;  // of a row, that of the row
    return StoreElement(place, value);
  }
  const Shape shape = ShapeOf(program_.types[type]);
  const Shape component = shape.Component();
  for (std::uint32_t i = 0; i < shape.size; ++i) {
    const Ref one = shape.IsScalar() ? value : Part(types_.Of(component), value, i);
    const Ref pointer = ComponentPointer(part, i);
    Do(spv::Op::OpStore, {pointer, Converted(one, component, Types::InMemory(component).scalar)});
  }
}

// An atomic operation, which none of the invocations in `by` interrupts. The comparand is none
// where nothing is compared.
Ref Writer::Atomic(ObjectOp op, Ref pointer, spv::Scope by, ExprId comparand, ExprId operand) {
  const Ref compared = comparand ? Value(comparand) : 0;
  const Ref value = Value(operand);
  const Scalar scalar = ShapeAt(operand).scalar;
  const AtomicInstructions both = InstructionsOf(op);
  const spv::Op instruction = IsUnsigned(scalar) ? both.of_uint : both.of_int;
  const Ref scope = types_.Uint(NumberOf(by)), relaxed = types_.Uint(0);
  if (comparand)
    return Emit(instruction, types_.Of(scalar),
                {pointer, scope, relaxed, relaxed, value, compared});
  return Emit(instruction, types_.Of(scalar), {pointer, scope, relaxed, value});
}

Ref Writer::Atomic(const clipc::ir::ObjectCall& node, Ref pointer) {
  return Atomic(node.op, pointer, spv::Scope::Device,
                OperandOf(program_, node, OperandKind::kComparand),
                OperandOf(program_, node, OperandKind::kValue));
}

// An atomic operation on a variable that the group shares.
Ref Writer::Atomic(const IntrinsicCall& node) {
  const auto arguments = (*this)[node.arguments];
  const Ref pointer = PointerTo(PlaceOf(arguments[0]));
  return Atomic(SameOfObjects(node.op), pointer, spv::Scope::Workgroup,
                arguments.size() > 2 ? arguments[1] : ExprId{}, arguments.back());
}

// The least or greatest int of a word: the instruction alone says that it has a sign.
Ref Writer::AtomicOfWord(ObjectOp op, Ref pointer, ExprId operand) {
  const Shape shape = ShapeAt(operand), word = ShapeOf(Scalar::kUint, 1, 1);
  const Ref value = Converted(Value(operand), shape, word.scalar);
  const Ref scope = types_.Uint(NumberOf(spv::Scope::Device)), relaxed = types_.Uint(0);
  const Ref before =
      Emit(InstructionsOf(op).of_int, types_.Of(word.scalar), {pointer, scope, relaxed, value});
  return Converted(before, word, shape.scalar);
}

// The number of elements.
Ref Writer::BufferLength(TypeId type, ExprId object) {
  const Ref block = ObjectPointer(object);
  const Ref length = Emit(spv::Op::OpArrayLength, types_.Of(Scalar::kUint), {block, 0});
  return Converted(Marked(length, IsNonUniform(object)), ShapeOf(Scalar::kUint, 1, 1),
                   program_.types[type].scalar);
}

Ref Writer::BufferCall(TypeId type, const clipc::ir::ObjectCall& node) {
  if (node.has_texel) return Lack("the status of a read of a structured buffer");
  if (IsAtomic(node.op)) {
    const StoredPart part = PartAlong(node);
    const Scalar memory = Types::InMemory(ShapeOf(program_.types[part.place.type])).scalar;
    const Ref pointer = ComponentPointer(part, 0);
    const ExprId value = OperandOf(program_, node, OperandKind::kValue);
    const bool is_word = memory == Scalar::kUint && ShapeAt(value).scalar == Scalar::kInt;
    return is_word ? AtomicOfWord(node.op, pointer, value) : Atomic(node, pointer);
  }
  if (node.op == ObjectOp::kStore) {
    StoreInBuffer(node);
    return 0;
  }
  if (node.op == ObjectOp::kStructuredLoad) return Load(ElementPlace(node));
  return BufferLength(type, OperandOf(program_, node, OperandKind::kObject));
}

}  // namespace clipc::spirv
