// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Paths in memory.
#include <algorithm>

#include "backend-spirv/writer.h"
#include "ir/packing.h"

namespace clipc::spirv {

using namespace ir;

namespace {

// The read of an element of a structured buffer that the path starts at; null if it does not.
const ObjectCall* ElementOf(const Program& program, ExprId path) {
  while (const ExprId whole = WholeOf(program, path)) path = whole;
  const auto* call = As<ObjectCall>(program, path);
  return call && call->op == ObjectOp::kStructuredLoad ? call : nullptr;
}

}  // namespace

// Notes what an expression says of variables and functions.
void Writer::FindMemoryOf(ExprId expr) {
  const auto keep = [&](ExprId path) {
    if (const VarId root = RootOf(program_, path)) in_memory_[root.index] = true;
  };
  if (const auto* ref = As<VarRef>(expr); ref && !is_read_[ref->var.index]) {
    is_read_[ref->var.index] = true;
    if ((*this)[ref->var].storage == Storage::kOutput) mentioned_outputs_.push_back(ref->var);
    const Var& var = (*this)[ref->var];
    const bool is_global = var.storage == Storage::kStatic || var.storage == Storage::kConstant;
    if (is_global && var.init)
      ForEachExpr(program_, var.init, [&](ExprId part) { FindMemoryOf(part); });
  }
  ForEachWrite(program_, expr, keep);
  if (const auto* index = As<Index>(expr)) {
    const Type& type = TypeAt(index->base);
    const bool is_vector = type.IsNumeric() && !ShapeOf(type).HasRows();
    if (!As<Literal>(index->index) && !is_vector) keep(index->base);
  }
  const auto* asked = As<IntrinsicCall>(expr);
  if (asked && (asked->op == ir::CommonIntrinsic::kAttributeAtVertex ||
                asked->op == ir::CommonIntrinsic::kInputOfVertex))
    per_vertex_.insert(RootOf(program_, (*this)[asked->arguments][0]).index);
  const auto* call = As<Call>(expr);
  if (call && std::ranges::find(functions_, call->function) == functions_.end())
    functions_.push_back(call->function);
}

// Finds the variables of the function that need memory, and the functions that it calls.
void Writer::FindMemory(FunctionId id) {
  const StmtId body = program_.functions[id].body;
  ForEachExpr(program_, body, [&](ExprId expr) { FindMemoryOf(expr); });
  ForEachStmt(program_, body, [&](StmtId stmt) {
    if (const auto* declare = As<Declare>(stmt)) {
      if (!declare->init && !(*this)[declare->var].init) in_memory_[declare->var.index] = true;
    }
    // A variable of an arm lives on in the next one, which control may enter past its value.
    const auto* choice = As<Switch>(stmt);
    if (!choice) return;
    for (const SwitchCase& arm : program_.switch_cases[choice->cases]) {
      for (const StmtId part : program_.stmt_lists[arm.body]) {
        if (const auto* declare = As<Declare>(part)) in_memory_[declare->var.index] = true;
      }
    }
  });
}

// Whether the path starts at a variable in memory or at an element of a structured buffer.
bool Writer::HasPlace(ExprId path) const {
  const VarId root = RootOf(program_, path);
  if (!root && !ElementOf(program_, path)) return false;
  if (root && (values_[root.index] != 0 || builtin_inputs_.contains(root.index))) return false;
  // A component of components has no place.
  for (ExprId part = WholeOf(program_, path); part; part = WholeOf(program_, part)) {
    if (const auto* swizzle = As<Swizzle>(part); swizzle && swizzle->count > 1) return false;
    if (As<MatrixSwizzle>(part)) return false;
  }
  return !As<MatrixSwizzle>(path);
}

bool Writer::IsOnlyElement(const Index& node) const {
  const Type& type = TypeAt(node.base);
  return type.IsNumeric() && (type.kind == TypeKind::kMatrix ? type.rows == 1 : type.columns == 1);
}

Place Writer::PlaceOfVariable(VarId id) {
  const Var& var = (*this)[id];
  if (var.storage == Storage::kUniform) {
    Place place{.base = BlockVariable(var.cbuffer),
                .storage = spv::StorageClass::Uniform,
                .type = var.type,
                .layout = Layout::kConstants,
                .row_major = var.row_major};
    const Cbuffer& cbuffer = program_.cbuffers[var.cbuffer];
    if (cbuffer.is_push_constant) place.storage = spv::StorageClass::PushConstant;
    place.is_buffer = cbuffer.kind == CbufferKind::kConstantBuffer;
    const auto& [variable, kept, is_rows] = blocks_[var.cbuffer.index];
    const auto member = std::ranges::find(cbuffer.members, id, &CbufferMember::var);
    if (is_rows) {
      place.layout = Layout::kRows;
      place.offset = member->offset;
    }
    if (place.is_buffer || is_rows) return place;
    const auto number = std::ranges::find(
        kept, id, [&](std::uint32_t member) { return cbuffer.members[member].var; });
    if (number == kept.end()) {
      Lack("a member of a constant buffer that no block has at its place");
      return place;
    }
    place.indices.push_back(types_.Int(static_cast<std::int32_t>(number - kept.begin())));
    return place;
  }
  if (pointers_[id.index] == 0) Lack("a variable before its declaration");
  Place place{pointers_[id.index], storages_[id.index], {}, var.type};
  const auto part = part_indices_.find(id.index);
  if (part != part_indices_.end()) place.indices = part->second;
  return place;
}

Place Writer::PlaceOf(ExprId path) {
  if (const auto* ref = As<VarRef>(path)) return PlaceOfVariable(ref->var);
  if (const auto* element = As<clipc::ir::ObjectCall>(path)) return ElementPlace(*element);
  if (const auto* field = As<FieldRef>(path)) {
    return PlaceOfField(PlaceOf(field->base), field->field);
  }
  if (const auto* index = As<Index>(path)) {
    Place place = PlaceOf(index->base);
    if (place.is_buffer)
      ChooseBuffer(place, Converted(Value(index->index), ShapeAt(index->index), Scalar::kInt));
    else if (place.layout == Layout::kRows)
      ElementInRows(place, index->index);
    else if (!IsOnlyElement(*index))
      place.indices.push_back(Value(index->index));
    if (place.is_buffer && IsNonUniform(path)) {
      place.is_non_uniform = true;
      RequireNonUniform(spv::Capability::UniformBufferArrayNonUniformIndexing);
    }
    place.type = (*this)[path].type;
    return place;
  }
  const auto* swizzle = As<Swizzle>(path);
  if (!swizzle) {
    Lack("a place of another kind");
    Place nowhere;
    nowhere.type = (*this)[path].type;
    return nowhere;
  }
  Place place = PlaceOf(swizzle->base);
  const Shape shape = ShapeAt(swizzle->base);
  if (swizzle->count == 1) {
    if (place.layout == Layout::kRows)
      place.offset +=
          swizzle->components[0] * (place.stride != 0 ? place.stride : ByteSize(shape.scalar));
    else if (!shape.IsScalar())
      place.indices.push_back(types_.Int(swizzle->components[0]));
    place.type = (*this)[path].type;
    return place;
  }
  place.vector = place.type;
  place.type = (*this)[path].type;
  place.components = swizzle->components;
  place.count = swizzle->count;
  return place;
}

Ref Writer::PointerTo(const Place& place) {
  if (place.indices.empty()) return place.base;
  const TypeId type = place.count > 0 ? place.vector : place.type;
  const Ref pointee = types_.InMemory(type, place.row_major, place.layout);
  Words operands{place.base};
  operands.insert(operands.end(), place.indices.begin(), place.indices.end());
  return Marked(Emit(spv::Op::OpAccessChain, types_.Pointer(place.storage, pointee), operands),
                place.is_non_uniform);
}

// The value of a type that one layout has as the type that another has.
Ref Writer::Recast(Ref value, TypeId id, bool row_major, Layout from, Layout to) {
  if (from == to || !types_.DiffersInMemory(id)) return value;
  const Type& type = program_.types[id];
  std::vector<Ref> parts;
  if (type.IsNumeric()) {
    const auto shape_in = [&](Layout layout) {
      return layout == Layout::kValue ? ShapeOf(type) : Types::InMemory(ShapeOf(type));
    };
    const Shape shape = shape_in(from);
    const Scalar scalar = shape_in(to).scalar;
    if (!shape.HasRows()) return Converted(value, shape, scalar);
    for (std::uint32_t i = 0; i < shape.rows; ++i)
      parts.push_back(Converted(Part(types_.Of(shape.Row()), value, i), shape.Row(), scalar));
  } else if (type.kind == TypeKind::kArray) {
    const Ref element = types_.InMemory(type.element, row_major, from);
    for (std::uint32_t i = 0; i < type.count; ++i)
      parts.push_back(Recast(Part(element, value, i), type.element, row_major, from, to));
  } else {
    std::uint32_t number = 0;
    for (const Field& field : program_.types[type.structure].fields) {
      const Ref part = Part(types_.InMemory(field.type, field.row_major, from), value, number++);
      parts.push_back(Recast(part, field.type, field.row_major, from, to));
    }
  }
  return Compose(types_.InMemory(id, row_major, to), parts);
}

Ref Writer::Load(const Place& place) {
  const TypeId type = place.count > 0 ? place.vector : place.type;
  if (place.is_buffer) return LoadBuffer(place);
  const bool is_memory = place.layout == Layout::kConstants || place.layout == Layout::kElements;
  if (is_memory && place.count == 0 && IsLong(type)) return LoadLong(place);
  Ref value = 0;
  if (place.layout == Layout::kRows) {
    Place whole = place;
    whole.type = type;
    value = LoadInRows(whole);
  } else {
    const Ref pointer = PointerTo(place),
              memory = types_.InMemory(type, place.row_major, place.layout);
    value = Recast(Emit(spv::Op::OpLoad, memory, {pointer}), type, place.row_major, place.layout,
                   Layout::kValue);
  }
  if (place.count == 0) return value;
  return Components(value, ShapeOf(program_.types[type]),
                    std::span(place.components).first(place.count));
}

// Chooses an element of an array of constant buffers, whose dimensions are one in the module.
void Writer::ChooseBuffer(Place& place, Ref index) {
  const Type& array = program_.types[place.type];
  if (!place.indices.empty()) {
    const Ref type = types_.Of(Scalar::kInt);
    const Ref count = types_.Int(static_cast<std::int32_t>(array.count));
    const Ref first = Emit(spv::Op::OpIMul, type, {place.indices[0], count});
    index = Emit(spv::Op::OpIAdd, type, {first, index});
  }
  place.indices = {index};
  place.type = array.element;
}

// The whole of a ConstantBuffer<T>, whose block is a type of its own, or of an array of them.
Ref Writer::LoadBuffer(const Place& place) {
  const Type& type = program_.types[place.type];
  std::vector<Ref> parts;
  if (type.kind == TypeKind::kArray) {
    for (std::uint32_t i = 0; i < type.count; ++i) {
      Place element = place;
      ChooseBuffer(element, types_.Int(static_cast<std::int32_t>(i)));
      parts.push_back(LoadBuffer(element));
    }
    return Compose(types_.Of(place.type), parts);
  }
  if (place.layout == Layout::kRows) return LoadInRows(place);
  return LoadLong(place);
}

void Writer::Store(const Place& place, Ref value) {
  const Ref pointer = PointerTo(place);
  if (place.count > 0) {
    const Ref type = types_.Of(place.vector);
    const Ref old = Emit(spv::Op::OpLoad, type, {pointer});
    const std::uint32_t size = ShapeOf(program_.types[place.vector]).size;
    Words operands{old, value};
    for (std::uint32_t i = 0; i < size; ++i) {
      const auto* end = place.components.data() + place.count;
      const auto* found = std::find(place.components.data(), end, i);
      operands.push_back(
          found == end ? i : size + static_cast<std::uint32_t>(found - place.components.data()));
    }
    value = Emit(spv::Op::OpVectorShuffle, type, operands);
  }
  Do(spv::Op::OpStore, {pointer, value});
}

Place Writer::NewLocal(TypeId type, std::string_view name) {
  const Ref variable = module_.NewRef();
  const auto storage = spv::StorageClass::Function;
  Put(locals_, spv::Op::OpVariable,
      {types_.Pointer(storage, types_.Of(type)), variable, static_cast<std::uint32_t>(storage)});
  module_.Name(variable, name);
  Relax(variable, type);
  return {variable, storage, {}, type};
}

}  // namespace clipc::spirv
