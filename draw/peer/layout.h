// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "draw/peer/module.h"
#include "ir/program.h"

// Where clipc and a peer put the members of constant buffers.
namespace clipc::draw::peer {

// A cbuffer's variable, or a field of a ConstantBuffer<T>.
struct Member {
  std::string name;
  ir::TypeId type;
  bool row_major = false;
  std::uint32_t offset = 0;
};
std::vector<Member> MembersOf(const ir::Program& program, const ir::Cbuffer& cbuffer);

// The bytes of a member's components, in the order of the value.
std::vector<std::uint32_t> BytesOf(const ir::Program& program, const Member& member);

// The peer's block of that cbuffer; null when it has none.
const Block* Find(const std::vector<Block>& blocks, const ir::Cbuffer& cbuffer);

// The cbuffer's bytes as the peer's shader reads them. Throws DrawError when the two disagree on what the members are.
std::vector<std::uint8_t> Relocated(const ir::Program& program, const ir::Cbuffer& cbuffer, const Block& block,
                                    const std::uint8_t* bytes);

// One member that lies elsewhere.
struct Moved {
  std::string member;           // "Lights.color"
  std::uint32_t component = 0;  // the first one
  std::uint32_t byte = 0, peer_byte = 0;
  std::string bug;  // the known bug of the peer that explains it; empty: none does
};
struct LayoutComparison {
  long members = 0;
  std::vector<Moved> moved;
};
LayoutComparison CompareLayout(const ir::Program& program, const std::vector<Block>& blocks);

}  // namespace clipc::draw::peer
