// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/resolve/names.h"

namespace clipc::resolve {

// Gives each structured buffer whose counter the shader changes a hidden buffer, counter_var_NAME,
// with the counter as its one element, as "Counter variable" in DXC's docs/SPIR-V.rst has it, and
// makes the changes atomic operations on that. An array of buffers has an array of counters.
// Reports a counter that is both incremented and decremented: INSTR.ONLYONEALLOCCONSUME in DXC's
// docs/DXIL.rst. Requires that objects are resolved.
void MakeCounters(Program& program, Diagnostics& diagnostics);

}  // namespace clipc::resolve
