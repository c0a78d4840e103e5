// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ir/program.h"
#include "tools/draw/buffers.h"
#include "tools/reference-compiler/module.h"

// Moves constants from the places where clipc has them to those where a reference compiler reads
// them, so that the values are compared wherever the reference compiler puts its constants.
namespace clipc::draw::reference_compiler {

// A variable of a cbuffer, or a field of a ConstantBuffer<T>, with its place in clipc's layout.
struct PlacedMember {
  std::string name;
  ir::TypeId type;
  bool row_major = false;
  std::uint32_t offset = 0;
};
std::vector<PlacedMember> MembersOf(const ir::Program& program, const ir::Cbuffer& cbuffer);

// The reference compiler's block of that cbuffer; null when the reference compiler has none.
// $Globals and the `uniform` parameters are one block.
const ReferenceBlock* Find(const std::vector<ReferenceBlock>& blocks, const ir::Cbuffer& cbuffer);

// Copies the members of the cbuffer, whose bytes are `from`, to where the reference compiler reads
// them. Throws DrawError when the two disagree on what the members are.
void Relocate(const ir::Program& program, const ir::Cbuffer& cbuffer, const ReferenceBlock& block,
              const std::uint8_t* from, Bytes& to);
// The elements of a structured buffer, laid out as the reference compiler reads them.
Buffer Relocated(const ir::Program& program, ir::VarId var, const ReferenceElements& elements,
                 const Buffer& buffer);

}  // namespace clipc::draw::reference_compiler
