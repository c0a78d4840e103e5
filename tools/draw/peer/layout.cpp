// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "tools/draw/peer/layout.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "ir/packing.h"
#include "tools/draw/memory.h"
#include "tools/draw/peer/known_bugs.h"
#include "tools/draw/textures.h"

namespace clipc::draw::peer {
namespace {

std::vector<std::uint32_t> BytesOf(const ir::Program& program, const Member& member) {
  std::vector<std::uint32_t> bytes;
  ForEachComponent(program.types, member.type, member.row_major, member.offset,
                   [&](ir::Scalar, std::uint32_t byte) { bytes.push_back(byte); });
  return bytes;
}

// Of an element of a structured buffer.
std::vector<std::uint32_t> BytesOf(const ir::Program& program, ir::VarId var) {
  std::vector<std::uint32_t> bytes;
  ForEachStructured(
      program.types, ObjectTypeOf(program, var).element, program.vars[var].row_major, 0,
      [&](ir::Scalar kind, std::uint32_t byte) {
        const ir::Scalar base = ir::BaseOf(kind);
        if (base == ir::Scalar::kDouble || base == ir::Scalar::kInt64 ||
            base == ir::Scalar::kUint64) {
          throw DrawError("64-bit parts of a structured buffer, which no test lets a peer read");
        }
        bytes.push_back(byte);
      });
  return bytes;
}

const std::vector<std::uint32_t>& PeerBytes(const Block& block, const Member& member,
                                            std::size_t count) {
  const auto found = block.members.find(member.name);
  if (found == block.members.end())
    throw DrawError("the peer's " + block.name + " has no `" + member.name + "`");
  if (found->second.size() != count)
    throw DrawError("the peer's `" + member.name + "` has another number of components");
  return found->second;
}

// A global constant that is no uniform to the peer.
bool IsCompiledIn(const ir::Cbuffer& cbuffer, const Block& block, const Member& member) {
  return cbuffer.kind == ir::CbufferKind::kGlobals && !block.members.contains(member.name);
}

// The first component that lies elsewhere.
std::optional<Moved> Compare(std::string name, const std::vector<std::uint32_t>& ours,
                             const std::vector<std::uint32_t>& theirs) {
  const auto [own, other] = std::ranges::mismatch(ours, theirs);
  if (own == ours.end()) return std::nullopt;
  return Moved{std::move(name), static_cast<std::uint32_t>(own - ours.begin()), *own, *other, ""};
}

}  // namespace

std::vector<Member> MembersOf(const ir::Program& program, const ir::Cbuffer& cbuffer) {
  std::vector<Member> members;
  if (cbuffer.kind != ir::CbufferKind::kConstantBuffer) {
    for (const ir::CbufferMember& member : cbuffer.members) {
      const ir::Var& var = program.vars[member.var];
      members.push_back({var.name, var.type, var.row_major, member.offset});
    }
    return members;
  }
  ir::TypeId type = program.vars[cbuffer.members.at(0).var].type;
  while (program.types[type].kind == ir::TypeKind::kArray) type = program.types[type].element;
  const ir::StructId structure = program.types[type].structure;
  const auto& fields = program.types[structure].fields;
  for (std::uint32_t i = 0; i < fields.size(); ++i) {
    members.push_back({fields[i].name, fields[i].type, fields[i].row_major,
                       ir::FieldOffset(program.types, structure, i)});
  }
  return members;
}

const Block* Find(const std::vector<Block>& blocks, const ir::Cbuffer& cbuffer) {
  const bool is_loose =
      cbuffer.kind == ir::CbufferKind::kGlobals || cbuffer.kind == ir::CbufferKind::kParams;
  // glslang cuts this one name short.
  const std::string name = is_loose                           ? "$Global"
                           : cbuffer.name == "ConstantBuffer" ? "C"
                                                              : cbuffer.name;
  const auto found = std::ranges::find(blocks, name, &Block::name);
  return found == blocks.end() ? nullptr : &*found;
}

void Relocate(const ir::Program& program, const ir::Cbuffer& cbuffer, const Block& block,
              const std::uint8_t* from, std::vector<std::uint8_t>& to) {
  for (const Member& member : MembersOf(program, cbuffer)) {
    if (IsCompiledIn(cbuffer, block, member)) continue;
    const std::vector<std::uint32_t> ours = BytesOf(program, member);
    const std::vector<std::uint32_t>& theirs = PeerBytes(block, member, ours.size());
    for (std::size_t i = 0; i < ours.size(); ++i)
      std::memcpy(&to.at(theirs[i] + 3) - 3, from + ours[i], 4);
  }
}

Buffer Relocated(const ir::Program& program, ir::VarId var, const Elements& elements,
                 const Buffer& buffer) {
  const std::vector<std::uint32_t> ours = BytesOf(program, var);
  if (ours.size() != elements.bytes.size())
    throw DrawError("the peer's `" + elements.name + "` has other elements");
  const std::size_t stride =
      StructuredPlaceOf(program.types, ObjectTypeOf(program, var).element).size;
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

LayoutComparison CompareLayout(const ir::Program& program, const std::vector<Block>& blocks,
                               const std::vector<Elements>& elements) {
  LayoutComparison found;
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    const Block* block = Find(blocks, cbuffer);
    if (!block) continue;
    for (const Member& member : MembersOf(program, cbuffer)) {
      if (IsCompiledIn(cbuffer, *block, member)) continue;
      ++found.members;
      const std::vector<std::uint32_t> ours = BytesOf(program, member);
      const std::vector<std::uint32_t>& theirs = PeerBytes(*block, member, ours.size());
      if (auto moved = Compare(cbuffer.name + "." + member.name, ours, theirs)) {
        moved->bug = LayoutBug(program, cbuffer, member, *block);
        found.moved.push_back(std::move(*moved));
      }
    }
  }
  for (const ir::Resource& resource : program.resources) {
    const ir::Type& type = ObjectTypeOf(program, resource.var);
    const auto peer = std::ranges::find(elements, program.vars[resource.var].name, &Elements::name);
    if (!ir::IsStructured(type.object) || peer == elements.end()) continue;
    ++found.members;
    std::vector<std::uint32_t> ours = BytesOf(program, resource.var), theirs = peer->bytes;
    ours.push_back(
        StructuredPlaceOf(program.types, type.element).size);  // where the next element begins
    theirs.push_back(peer->stride);
    if (auto moved = Compare(peer->name, ours, theirs)) {
      moved->bug = StructuredBug(program, resource.var, theirs);
      found.moved.push_back(std::move(*moved));
    }
  }
  return found;
}

}  // namespace clipc::draw::peer
