// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ir/program.h"
#include "tools/draw/buffers.h"
#include "tools/draw/peer/module.h"

// Where clipc and a peer put the members of constant buffers and the parts of a structured buffer's
// elements.
namespace clipc::draw::peer {

// A variable of a cbuffer, or a field of a ConstantBuffer<T>, and where clipc has it.
struct Member {
  std::string name;
  ir::TypeId type;
  bool row_major = false;
  std::uint32_t offset = 0;
};
std::vector<Member> MembersOf(const ir::Program& program, const ir::Cbuffer& cbuffer);

// The peer's block of that cbuffer; null when it has none. $Globals and the `uniform` parameters
// are one block.
const Block* Find(const std::vector<Block>& blocks, const ir::Cbuffer& cbuffer);

// Puts the members of the cbuffer, whose bytes are `from`, where the peer reads them. Throws
// DrawError when the two disagree on what the members are.
void Relocate(const ir::Program& program, const ir::Cbuffer& cbuffer, const Block& block,
              const std::uint8_t* from, std::vector<std::uint8_t>& to);
// The elements of a structured buffer.
Buffer Relocated(const ir::Program& program, ir::VarId var, const Elements& elements,
                 const Buffer& buffer);

// One member that lies elsewhere.
struct Moved {
  std::string member;           // "Lights.color"
  std::uint32_t component = 0;  // the first one
  std::uint32_t byte = 0, peer_byte = 0;
  std::string bug;  // the known bug of the peer that explains it; empty: none does
};
struct LayoutComparison {
  long members = 0;  // compared
  std::vector<Moved> moved;
};
LayoutComparison CompareLayout(const ir::Program& program, const std::vector<Block>& blocks,
                               const std::vector<Elements>& elements);

}  // namespace clipc::draw::peer
