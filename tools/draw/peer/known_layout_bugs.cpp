// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include <algorithm>

#include "tools/draw/gl.h"
#include "tools/draw/peer/known_bugs.h"
#include "tools/draw/textures.h"

namespace clipc::draw::peer {
namespace {

using ir::TypeKind;

std::uint32_t RoundUp(std::uint32_t value, std::uint32_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

// Where glslang 12 puts things: offsets by Direct3D's rules for vectors, but sizes and alignments
// by GLSL's, of std140 for constant buffers and std430 for structured ones; and in the block of the
// global variables GLSL's alone.
class Glslang {
 public:
  Glslang(const ir::TypeTable& types, std::uint32_t least_alignment, bool packs_vectors)
      : types_(types), least_(least_alignment), packs_vectors_(packs_vectors) {}

  struct Place {
    std::uint32_t size, alignment;
  };
  Place PlaceOf(ir::TypeId id, bool row_major) const {
    const ir::Type& type = types_[id];
    if (type.kind == TypeKind::kArray) {
      const Place element = PlaceOf(type.element, row_major);
      const std::uint32_t alignment = std::max(element.alignment, least_);
      return {RoundUp(element.size, alignment) * type.count, alignment};
    }
    if (type.kind == TypeKind::kStruct) {
      Place all{0, least_};
      for (const ir::Field& field : types_[type.structure].fields) {
        const Place place = PlaceOf(field.type, field.row_major);
        all.size = RoundUp(all.size, place.alignment) + place.size;
        all.alignment = std::max(all.alignment, place.alignment);
      }
      return {RoundUp(all.size, all.alignment), all.alignment};
    }
    if (type.kind != TypeKind::kMatrix) return VectorPlace(type.columns);
    const std::uint32_t registers = row_major ? type.rows : type.columns,
                        length = row_major ? type.columns : type.rows;
    const std::uint32_t stride = std::max(VectorPlace(length).alignment, least_);
    return {registers * stride, stride};
  }

  // The member's own place when the ones before end at `end`.
  std::uint32_t Next(ir::TypeId id, bool row_major, std::uint32_t end) const {
    const ir::Type& type = types_[id];
    const Place place = PlaceOf(id, row_major);
    const bool is_vector = type.kind == TypeKind::kVector || type.kind == TypeKind::kScalar;
    const std::uint32_t at = RoundUp(end, is_vector && packs_vectors_ ? 4 : place.alignment);
    const bool straddles = is_vector && at / 16 != (at + place.size - 1) / 16;
    return straddles ? RoundUp(at, 16) : at;
  }

  void Append(ir::TypeId id, bool row_major, std::uint32_t at,
              std::vector<std::uint32_t>& bytes) const {
    const ir::Type& type = types_[id];
    if (type.kind == TypeKind::kArray) {
      const std::uint32_t stride = PlaceOf(id, row_major).size / type.count;
      for (std::uint32_t i = 0; i < type.count; ++i)
        Append(type.element, row_major, at + i * stride, bytes);
      return;
    }
    if (type.kind == TypeKind::kStruct) {
      // Inside of a struct vectors are packed, wherever it is.
      const Glslang packing(types_, least_, true);
      std::uint32_t end = 0;
      for (const ir::Field& field : types_[type.structure].fields) {
        const std::uint32_t offset = packing.Next(field.type, field.row_major, end);
        packing.Append(field.type, field.row_major, at + offset, bytes);
        end = offset + packing.PlaceOf(field.type, field.row_major).size;
      }
      return;
    }
    const std::uint32_t stride =
        type.kind == TypeKind::kMatrix ? PlaceOf(id, row_major).alignment : 0;
    for (std::uint32_t row = 0; row < type.rows; ++row) {
      for (std::uint32_t column = 0; column < type.columns; ++column) {
        const bool by_row = type.kind != TypeKind::kMatrix || row_major;
        bytes.push_back(at + (by_row ? row * stride + 4 * column : column * stride + 4 * row));
      }
    }
  }

 private:
  Place VectorPlace(std::uint32_t components) const {
    return {4 * components, components == 3 ? 16 : 4 * components};
  }

  const ir::TypeTable& types_;
  std::uint32_t least_;  // of arrays, structs and a matrix's registers
  bool packs_vectors_;
};

}  // namespace

std::string LayoutBug(const ir::Program& program, const ir::Cbuffer& cbuffer, const Member& member,
                      const Block& block) {
  if (cbuffer.kind == ir::CbufferKind::kParams) return "uniform-parameters";
  const bool is_globals = cbuffer.kind == ir::CbufferKind::kGlobals;
  const Glslang glslang(program.types, 16, !is_globals);
  bool has_places = false;
  std::uint32_t end = 0;
  for (const Member& other : MembersOf(program, cbuffer)) {
    if (!block.members.contains(other.name)) continue;
    std::uint32_t at = glslang.Next(other.type, other.row_major, end);
    for (const ir::CbufferMember& declared : cbuffer.members) {
      if (!declared.has_packoffset || program.vars[declared.var].name != other.name) continue;
      at = declared.offset;
      has_places = true;
    }
    end = at + glslang.PlaceOf(other.type, other.row_major).size;
    if (other.name != member.name) continue;
    std::vector<std::uint32_t> bytes;
    glslang.Append(other.type, other.row_major, at, bytes);
    if (bytes != block.members.at(member.name)) return "";
  }
  return !is_globals ? "row-after-aggregate" : has_places ? "register-c" : "globals-std140";
}

std::string StructuredBug(const ir::Program& program, ir::VarId var,
                          const std::vector<std::uint32_t>& peer_bytes) {
  const Glslang glslang(program.types, 4, true);
  const ir::TypeId element = ObjectTypeOf(program, var).element;
  std::vector<std::uint32_t> bytes;
  glslang.Append(element, program.vars[var].row_major, 0, bytes);
  const Glslang::Place place = glslang.PlaceOf(element, program.vars[var].row_major);
  bytes.push_back(RoundUp(place.size, place.alignment));
  return bytes == peer_bytes ? "structured-std430" : "";
}

}  // namespace clipc::draw::peer
