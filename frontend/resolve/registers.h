// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <map>
#include <span>
#include <vector>

#include "frontend/resolve/names.h"

namespace clipc::resolve {

// The registers, one of a letter, from which the objects in a uniform struct take theirs in order.
using StructRegisters = std::map<VarId, std::vector<Register>>;

// Registers in a row that are not chosen for anything: `count` from `first` on, or all if `count`
// is 0.
struct ReservedRegisters {
  Register first;
  std::uint32_t count = 1;
};

// The number of registers that an object or an array of objects needs; 0: all from its first on.
std::uint32_t RegisterCount(const TypeTable& types, TypeId type);

// Gives a register to every cbuffer and resource to which the user gave none. Buffers take the free
// registers in the order of their declarations, after $Globals and $Params; textures and samplers
// follow the same rule. `reserved` are left alone. Reports two explicit bindings of one register,
// and numbers out of range. Requires that only buffers that the shader reaches are in the program.
void AssignRegisters(Program& program, std::span<const ReservedRegisters> reserved,
                     Diagnostics& diagnostics);

}  // namespace clipc::resolve
