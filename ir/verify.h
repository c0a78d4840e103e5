// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>

#include "ir/program.h"

namespace clipc::ir {

// The first promise of program.h for programs of `form` that `program` breaks, with the function
// and the printed node, for people who work on clipc; none when it keeps all of them. It takes time
// linear in the program and never fails on what Check returns. Ids in nodes may be wrong in any
// way; Lists must be of the program's pools.
//
// * Ids are in range; an expression or statement has one parent; every expression has the type that
//   its node promises.
// * Targets of assignments and out arguments are paths to variables that may be written, without a
//   repeated component. An array of outputs is only the target of statements, or a part of one is.
// * A variable is used in its scope: a local after its Declare, a parameter in its function, a
//   global after its initialiser, an input or output in `main` only; uniforms are members.
// * Statements fit their function: break and continue are in loops, return has its type.
// * No function can reach itself; `main` calls the entry once.
// * Inputs, outputs, cbuffers and clip planes are consistent with their variables, types, limits
//   and with `form`.
std::optional<std::string> Verify(const Program& program, Form form);

}  // namespace clipc::ir
