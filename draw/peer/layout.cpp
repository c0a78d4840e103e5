// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#include "draw/peer/layout.h"

#include <algorithm>
#include <cstring>

#include "draw/gl.h"
#include "draw/memory.h"
#include "ir/packing.h"

namespace clipc::draw::peer {

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
    members.push_back({fields[i].name, fields[i].type, fields[i].row_major, ir::FieldOffset(program.types, structure, i)});
  }
  return members;
}

std::vector<std::uint32_t> BytesOf(const ir::Program& program, const Member& member) {
  std::vector<std::uint32_t> bytes;
  ForEachComponent(program.types, member.type, member.row_major, member.offset,
                   [&](ir::Scalar, std::uint32_t byte) { bytes.push_back(byte); });
  return bytes;
}

const Block* Find(const std::vector<Block>& blocks, const ir::Cbuffer& cbuffer) {
  const std::string name = cbuffer.kind == ir::CbufferKind::kGlobals ? "$Global" : cbuffer.name;
  const auto found = std::ranges::find(blocks, name, &Block::name);
  return found == blocks.end() ? nullptr : &*found;
}

namespace {

const std::vector<std::uint32_t>& PeerBytes(const Block& block, const Member& member, std::size_t count) {
  const auto found = block.members.find(member.name);
  if (found == block.members.end()) throw DrawError("the peer's " + block.name + " has no `" + member.name + "`");
  if (found->second.size() != count) throw DrawError("the peer's `" + member.name + "` has another number of components");
  return found->second;
}

}  // namespace

std::vector<std::uint8_t> Relocated(const ir::Program& program, const ir::Cbuffer& cbuffer, const Block& block,
                                    const std::uint8_t* bytes) {
  std::vector<std::uint8_t> relocated(block.size);
  for (const Member& member : MembersOf(program, cbuffer)) {
    const std::vector<std::uint32_t> from = BytesOf(program, member);
    const std::vector<std::uint32_t>& to = PeerBytes(block, member, from.size());
    for (std::size_t i = 0; i < from.size(); ++i) std::memcpy(&relocated.at(to[i] + 3) - 3, bytes + from[i], 4);
  }
  return relocated;
}

LayoutComparison CompareLayout(const ir::Program& program, const std::vector<Block>& blocks) {
  LayoutComparison found;
  for (const ir::CbufferId id : program.cbuffers.ids()) {
    const ir::Cbuffer& cbuffer = program.cbuffers[id];
    const Block* block = Find(blocks, cbuffer);
    if (!block) continue;
    for (const Member& member : MembersOf(program, cbuffer)) {
      ++found.members;
      const std::vector<std::uint32_t> ours = BytesOf(program, member);
      const std::vector<std::uint32_t>& theirs = PeerBytes(*block, member, ours.size());
      const auto [own, other] = std::ranges::mismatch(ours, theirs);
      if (own == ours.end()) continue;
      found.moved.push_back({cbuffer.name + "." + member.name, static_cast<std::uint32_t>(own - ours.begin()), *own, *other, ""});
    }
  }
  return found;
}

}  // namespace clipc::draw::peer
