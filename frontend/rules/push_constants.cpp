// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "frontend/rules/push_constants.h"

#include <algorithm>

#include "ir/packing.h"

namespace clipc::rules {
namespace {

constexpr std::uint64_t kRow = 16;

struct Std430 {
  std::uint64_t size = 0, alignment = 4;
};

// A member of the buffer, or of a struct in it.
struct PackedMember {
  std::string name;  // for messages
  TypeId type;
  bool row_major = false;
  std::uint64_t offset = 0;            // in Direct3D's packing
  std::optional<std::uint32_t> given;  // the offset that the user gave
  Span span;
};

class Comparison {
 public:
  Comparison(const Program& program, Diagnostics& diagnostics)
      : types_(program.types), diagnostics_(diagnostics) {}

  // Checks the part that comes after `end` in Vulkan's packing, and returns its end there.
  std::uint64_t Check(const PackedMember& part, std::uint64_t end) {
    const std::uint64_t expected = part.given ? *part.given : Place(part.type, part.row_major, end);
    if (expected != part.offset && !is_reported_)
      Misfit(part.name, part.offset, expected, part.span);
    Inside(part.name, part.type, part.row_major, part.span);
    return expected + LayoutOf(part.type, part.row_major).size;
  }

 private:
  void Misfit(const std::string& what, std::uint64_t ours, std::uint64_t vulkan, Span span) {
    is_reported_ = true;
    diagnostics_.Report(span, diag::PushConstantMisfit, what, ours, vulkan);
  }

  std::uint64_t Place(TypeId id, bool row_major, std::uint64_t end) const {
    const Type& type = types_[id];
    if (type.kind != TypeKind::kVector) return RoundUp(end, LayoutOf(id, row_major).alignment);
    const std::uint64_t size = LayoutOf(id, row_major).size;
    const std::uint64_t offset = RoundUp(end, ByteSize(type.scalar));
    const bool crosses = offset / kRow != (offset + size - 1) / kRow;
    return size > kRow || crosses ? RoundUp(offset, kRow) : offset;
  }

  static Std430 VectorOf(std::uint64_t scalar, std::uint64_t components) {
    return {scalar * components, scalar * (components == 3 ? 4 : components)};
  }

  Std430 LayoutOf(TypeId id, bool row_major) const {
    const Type& type = types_[id];
    const std::uint64_t scalar = ByteSize(type.scalar);
    switch (type.kind) {
      case TypeKind::kScalar:
      case TypeKind::kVector: return VectorOf(scalar, type.columns);
      case TypeKind::kMatrix: {
        const Std430 one = VectorOf(scalar, row_major ? type.columns : type.rows);
        const std::uint64_t count = row_major ? type.rows : type.columns;
        return {RoundUp(one.size, one.alignment) * count, one.alignment};
      }
      case TypeKind::kArray: {
        const Std430 one = LayoutOf(type.element, row_major);
        return {RoundUp(one.size, one.alignment) * type.count, one.alignment};
      }
      case TypeKind::kStruct: {
        Std430 all;
        for (const Field& field : types_.StructOf(id).fields) {
          const Std430 one = LayoutOf(field.type, field.row_major);
          all.size = (field.offset ? *field.offset : Place(field.type, field.row_major, all.size)) +
                     one.size;
          all.alignment = std::max(all.alignment, one.alignment);
        }
        all.size = RoundUp(all.size, all.alignment);
        return all;
      }
      default: return {};
    }
  }

  // Checks the distances between the parts of a matrix, an array or a struct.
  void Inside(const std::string& name, TypeId id, bool row_major, Span span) {
    const Type& type = types_[id];
    if (type.kind == TypeKind::kStruct) {
      std::uint64_t end = 0;
      const auto& fields = types_.StructOf(id).fields;
      for (std::uint32_t i = 0; i < fields.size(); ++i) {
        const Field& field = fields[i];
        end = Check({name + "." + field.name, field.type, field.row_major,
                     FieldOffset(types_, type.structure, i), field.offset, field.span},
                    end);
      }
    } else if (type.kind == TypeKind::kArray) {
      const Std430 one = LayoutOf(type.element, row_major);
      Stride(name + "[1]", type.count, ArrayStride(types_, id, row_major),
             RoundUp(one.size, one.alignment), span);
      Inside(name + "[0]", type.element, row_major, span);
    } else if (type.kind == TypeKind::kMatrix) {
      const Std430 one = VectorOf(ByteSize(type.scalar), row_major ? type.columns : type.rows);
      Stride(name + (row_major ? "[1]" : "._m01"), row_major ? type.rows : type.columns,
             RoundUp(one.size, kRow), RoundUp(one.size, one.alignment), span);
    }
  }

  void Stride(const std::string& what, std::uint32_t count, std::uint64_t ours,
              std::uint64_t vulkan, Span span) {
    if (count > 1 && ours != vulkan && !is_reported_) Misfit(what, ours, vulkan, span);
  }

  const TypeTable& types_;
  Diagnostics& diagnostics_;
  bool is_reported_ = false;
};

void CheckPacking(const Program& program, const Cbuffer& buffer, Diagnostics& diagnostics) {
  Comparison comparison(program, diagnostics);
  std::uint64_t end = 0;
  for (const CbufferMember& member : buffer.members) {
    const Var& var = program.vars[member.var];
    const bool is_struct = program.types[var.type].kind == TypeKind::kStruct;
    if (buffer.kind == CbufferKind::kConstantBuffer && !is_struct) {
      diagnostics.Report(var.span, diag::PushConstantNotStruct, var.name,
                         program.types.Name(var.type));
      return;
    }
    end = comparison.Check({var.name, var.type, var.row_major, member.offset, {}, var.span}, end);
  }
}

}  // namespace

void CheckPushConstants(const Program& program, Diagnostics& diagnostics) {
  // Push constants belong to one stage: they are no part of its interface with another.
  if (program.is_interface_only) return;
  const Cbuffer* first = nullptr;
  for (const CbufferId id : program.cbuffers.ids()) {
    const Cbuffer& buffer = program.cbuffers[id];
    if (!buffer.is_push_constant) continue;
    if (first)
      diagnostics.Report(buffer.span, diag::PushConstantTwice, first->name, buffer.name)
          .Note(first->span, diag::DeclaredHere, first->name);
    first = &buffer;
    CheckPacking(program, buffer, diagnostics);
  }
}

}  // namespace clipc::rules
