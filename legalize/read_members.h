// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ir/program.h"
#include "legalize/needs.h"

namespace clipc::legalize {

// A member of a constant buffer that a language cannot declare at its place, and the variables of
// the buffer that it can declare there.
struct PackedMember {
  ir::VarId var;
  std::uint32_t offset = 0;  // bytes from the first row
  // An array of rows of four floats or uints, in which the member lies. In an array of buffers, an
  // array of structs of one field, these rows. None of a member that takes no room.
  ir::VarId rows = {};
  bool in_buffers = false;
  // Of a vector, its first component in place of rows: the others are the variables after it.
  ir::VarId component = {};
};

// Makes calls of functions of the reads of these members (Function::is_accessor). Returns the
// functions that read a member, or an element of one that is an array, by VarId.
//
//   weights[i]  =>  weights(i) with return buffer_rows[2 + i].x;
//   weights     =>  weights_all() with for (..) result[i] = weights(i);
std::vector<ir::FunctionId> ReadMembers(ir::Program& program, const Needs& needs,
                                        std::span<const PackedMember> members);

}  // namespace clipc::legalize
