// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// Long arrays of a buffer as values: they are copied by a loop, element by element.
#include "backend-spirv/writer.h"
#include "ir/packing.h"

namespace clipc::spirv {

using namespace ir;

// Whether the value takes more than 1,024 registers of a constant buffer.
bool Writer::IsLong(TypeId type) const {
  constexpr std::uint32_t kLong = 1024 * kRow;
  return PackedExtent(program_.types, type, false).size > kLong;
}

Place Writer::PlaceOfField(Place place, std::uint32_t number) {
  const Field& field = program_.types.StructOf(place.type).fields[number];
  if (place.layout != Layout::kValue) place.row_major = field.row_major;
  if (place.layout == Layout::kRows)
    place.offset += FieldOffset(program_.types, program_.types[place.type].structure, number);
  else
    place.indices.push_back(types_.Int(static_cast<std::int32_t>(number)));
  place.type = field.type;
  place.is_buffer = false;
  return place;
}

// An element of an array that is not an array of constant buffers.
Place Writer::PlaceOfElement(Place place, Ref number) {
  if (place.layout == Layout::kRows)
    StepInRows(place, number, ArrayStride(program_.types, place.type, place.row_major));
  else
    place.indices.push_back(number);
  place.type = program_.types[place.type].element;
  return place;
}

Ref Writer::LoadLong(const Place& place) {
  const Type& type = program_.types[place.type];
  if (type.kind == TypeKind::kStruct) {
    std::vector<Ref> parts;
    const auto count = program_.types.StructOf(place.type).fields.size();
    for (std::uint32_t i = 0; i < count; ++i) parts.push_back(Load(PlaceOfField(place, i)));
    return Compose(types_.Of(place.type), parts);
  }
  const Place copy = NewLocal(place.type);
  Repeat(type.count, [&](Ref number) {
    const Ref element = Load(PlaceOfElement(place, number));
    Store(PlaceOfElement(copy, number), element);
  });
  return Load(copy);
}

// Stores a value in an element of a structured buffer, or in a part of it.
void Writer::StoreElement(const Place& place, Ref value) {
  const Type& type = program_.types[place.type];
  if (!IsLong(place.type)) {
    const Ref pointer = PointerTo(place);
    Do(spv::Op::OpStore,
       {pointer, Recast(value, place.type, place.row_major, Layout::kValue, place.layout)});
    return;
  }
  if (type.kind == TypeKind::kStruct) {
    std::uint32_t number = 0;
    for (const Field& field : program_.types.StructOf(place.type).fields) {
      const Ref part = Part(types_.Of(field.type), value, number);
      StoreElement(PlaceOfField(place, number++), part);
    }
    return;
  }
  const Place copy = NewLocal(place.type);
  Store(copy, value);
  Repeat(type.count, [&](Ref number) {
    const Ref element = Load(PlaceOfElement(copy, number));
    StoreElement(PlaceOfElement(place, number), element);
  });
}

}  // namespace clipc::spirv
