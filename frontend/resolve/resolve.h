// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/resolve/names.h"
#include "frontend/resolve/registers.h"
#include "frontend/resolve/resolve_objects.h"
#include "ir/run_passes.h"

namespace clipc::resolve {

// What the text and the request say of a program that the program does not hold.
struct ResolveOptions {
  bool is_specialised = false;  // a technique has given values to the entry's parameters
  bool has_preshader = false;   // an effect has the shader
  std::span<const std::string> shadow_samplers;
  const StructRegisters& struct_registers;
  // Asked once, when registers are chosen; may report errors.
  std::function<std::vector<ReservedRegisters>()> registers_of_unused;
};

// Takes a program from Form::kTyped to Form::kResolved, unless an error or `passes` ends it
// earlier, and checks what only the whole program shows.
void Resolve(Program& program, const ResolveOptions& options, const PassOptions& passes,
             Diagnostics& diagnostics);

// The names of the passes, in the order in which they run.
std::vector<std::string_view> ResolvePasses();

}  // namespace clipc::resolve
