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

// The members of constant buffers of which a language does not say all that is read.
struct MemberReads {
  std::vector<PackedMember> packed;
  // The variables of each ConstantBuffer<T> that is a block, or an array of blocks: it says their
  // fields, but not the T.
  std::vector<ir::VarId> blocks;
};

// Makes calls of functions of the reads of these members, and, where arrays that are values have
// fields, of arrays (Function::is_accessor). Returns the functions that read a packed member, or an
// element of one that is an array, by VarId.
//
//   weights[i]       =>  weights(i) with return buffer_rows[2 + i].x;
//   weights          =>  weights_all() with for (..) result[i] = weights(i);
//   T t = lights[i]  =>  lights_value(i) with return T(lights[i].color, lights[i].place);
std::vector<ir::FunctionId> ReadMembers(ir::Program& program, const Needs& needs,
                                        const MemberReads& reads);
// Whether ReadMembers has anything to do.
bool HasReads(const ir::Program& program, const Needs& needs, const MemberReads& reads);

}  // namespace clipc::legalize
