// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "ir/program.h"
#include "tools/draw/peer/layout.h"
#include "tools/draw/random_inputs.h"

// What glslang 12's HLSL front end is known to do otherwise than Direct3D. docs/peers.md says for
// each why it is the peer that is wrong. A bug excuses a difference only where what it does, done
// by clipc's own means, gives exactly what the peer gives; but for two, which compare.cpp knows by
// the shader's text.
namespace clipc::draw::peer {

// The bug that puts the components of this member where the peer's block has them; empty: none
// does.
std::string LayoutBug(const ir::Program& program, const ir::Cbuffer& cbuffer, const Member& member,
                      const Block& block);
// The same for the components of a structured buffer's element, the next element's first byte
// behind them.
std::string StructuredBug(const ir::Program& program, ir::VarId var,
                          const std::vector<std::uint32_t>& peer_bytes);

// Gives the constants of `random` that the peer has no uniform for the values that the peer
// compiled in: a global variable's initial value, read from `hlsl`. Returns whether there are any.
bool GiveInitialValues(const ir::Program& program, const std::vector<Block>& blocks,
                       const std::string& hlsl, RandomInputs& random);

// Rewrites the shader into what the peer makes of it, bug by bug, and returns their names.
std::set<std::string> ApplyValueBugs(ir::Program& program);

}  // namespace clipc::draw::peer
