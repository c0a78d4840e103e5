// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/reference-compiler/relocate.h"

#include <algorithm>
#include <cstring>

#include "ir/packing.h"
#include "tools/draw/memory.h"
#include "tools/draw/textures.h"

namespace clipc::draw::reference_compiler {
namespace {

using namespace ir;

Offsets BytesOf(const Program& program, const PlacedMember& member) {
  Offsets bytes;
  ForEachComponent(program.types, member.type, member.row_major, member.offset,
                   [&](Scalar, std::uint32_t byte) { bytes.push_back(byte); });
  return bytes;
}

// The offsets in an element of a structured buffer.
Offsets BytesOf(const Program& program, VarId var) {
  Offsets bytes;
  ForEachComponent(
      program.types, ObjectTypeOf(program, var).element, program.vars[var].row_major, 0,
      [&](Scalar kind, std::uint32_t byte) {
        if (ByteSize(kind) == 8)
          throw DrawError(
              "64-bit parts of a structured buffer, which no test lets a reference compiler read");
        bytes.push_back(byte);
      },
      Packing::kStructured);
  return bytes;
}

const Offsets& ReferenceBytes(const ReferenceBlock& block, const PlacedMember& member,
                              std::size_t count) {
  const auto found = block.members.find(member.name);
  if (found == block.members.end())
    throw DrawError("the reference compiler's " + block.name + " has no `" + member.name + "`");
  if (found->second.size() != count)
    throw DrawError("the reference compiler's `" + member.name +
                    "` has another number of components");
  return found->second;
}

// Whether the reference compiler made a global constant of the member, and not a uniform.
bool IsCompiledIn(const Cbuffer& cbuffer, const ReferenceBlock& block, const PlacedMember& member) {
  return cbuffer.kind == CbufferKind::kGlobals && !block.members.contains(member.name);
}

}  // namespace

std::vector<PlacedMember> MembersOf(const Program& program, const Cbuffer& cbuffer) {
  std::vector<PlacedMember> members;
  if (cbuffer.kind != CbufferKind::kConstantBuffer) {
    for (const CbufferMember& member : cbuffer.members) {
      const Var& var = program.vars[member.var];
      members.push_back({var.name, var.type, var.row_major, member.offset});
    }
    return members;
  }
  const TypeId type = program.types.Innermost(program.vars[cbuffer.members.at(0).var].type);
  const StructId structure = program.types[type].structure;
  const auto& fields = program.types[structure].fields;
  for (std::uint32_t i = 0; i < fields.size(); ++i) {
    members.push_back({fields[i].name, fields[i].type, fields[i].row_major,
                       FieldOffset(program.types, structure, i)});
  }
  return members;
}

const ReferenceBlock* Find(const std::vector<ReferenceBlock>& blocks, const Cbuffer& cbuffer) {
  const bool is_loose =
      cbuffer.kind == CbufferKind::kGlobals || cbuffer.kind == CbufferKind::kParams;
  // The block of loose constants is called $Global by glslang, and `ConstantBuffer` is cut short.
  const std::string name = is_loose                           ? "$Global"
                           : cbuffer.name == "ConstantBuffer" ? "C"
                                                              : cbuffer.name;
  const auto found = std::ranges::find(blocks, name, &ReferenceBlock::name);
  return found == blocks.end() ? nullptr : &*found;
}

void Relocate(const Program& program, const Cbuffer& cbuffer, const ReferenceBlock& block,
              const std::uint8_t* from, Bytes& to) {
  for (const PlacedMember& member : MembersOf(program, cbuffer)) {
    if (IsCompiledIn(cbuffer, block, member)) continue;
    const Offsets ours = BytesOf(program, member);
    const Offsets& theirs = ReferenceBytes(block, member, ours.size());
    for (std::size_t i = 0; i < ours.size(); ++i)
      std::memcpy(&to.at(theirs[i] + 3) - 3, from + ours[i], 4);
  }
}

Buffer Relocated(const Program& program, VarId var, const ReferenceElements& elements,
                 const Buffer& buffer) {
  const Offsets ours = BytesOf(program, var);
  if (ours.size() != elements.bytes.size())
    throw DrawError("the reference compiler's `" + elements.name + "` has other elements");
  const std::size_t stride =
      StructuredSizeOf(program.types, ObjectTypeOf(program, var).element).size;
  const std::size_t count = buffer.size() / stride;
  Buffer relocated(count * elements.stride);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < ours.size(); ++k) {
      std::memcpy(&relocated.at(i * elements.stride + elements.bytes[k] + 3) - 3,
                  &buffer.at(i * stride + ours[k] + 3) - 3, 4);
    }
  }
  return relocated;
}

}  // namespace clipc::draw::reference_compiler
