// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <vector>

#include "base/kept_blocks.h"
#include "ir/program.h"

namespace clipc::glsl {

// The parts of a program that `main` reaches. The writer writes no others but helper functions, of
// which only accessors reach anything themselves, a buffer.
struct Reached {
  KeptVector<ir::FunctionId> functions;  // callees before callers, `main` last; no helpers
  KeptVector<ir::VarId> globals;         // kStatic and kConstant, in order of declaration
  std::vector<bool> vars;                // by VarId: mentioned anywhere
  std::vector<bool> cbuffers;            // by CbufferId
  // The operations on objects, and calls of intrinsic functions that not every target has.
  KeptVector<ir::ExprId> asked;

  bool Has(ir::VarId var) const { return vars[var.index]; }
  bool Has(ir::CbufferId cbuffer) const { return cbuffers[cbuffer.index]; }
};
// `keeps_bindings`: objects and constant buffers that nothing reads are reached too.
Reached Reach(const ir::Program& program, bool keeps_bindings = false);

}  // namespace clipc::glsl
