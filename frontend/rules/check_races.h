// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/rules/names.h"

namespace clipc::rules {

// Warns of a wait for the group in flow that the threads may decide differently although all read
// one place: another thread may have written it before the last of them reads it. fxc reports X4026
// of every such place ("due to a potential race condition this sync is illegal, consider adding a
// sync after reading any values controlling shader execution at this point"); this looks at the
// order of the text, and is silent where a wait lies between the write and the read.
void CheckRaces(const Program& program, Diagnostics& diagnostics);

}  // namespace clipc::rules
