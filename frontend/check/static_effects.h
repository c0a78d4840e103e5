// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "frontend/check/context.h"

// Static variables that nothing names, and whose initial values change what the shader reads.
namespace clipc::check {

// Reaches the static variables outside of functions that have an initial value with an effect: it
// changes a static variable that was reached, `groupshared` memory or an object, itself or in a
// function that it calls. In DXC every one gets its value, in the order of the text: "Initialize
// all global variables at the beginning of the wrapper", emitEntryFunctionWrapper of its
// SpirvEmitter.cpp. The bodies of functions must have been checked; those that are reached here
// are, too. A variable without an effect is not reached, so that what it calls may have errors.
void ReachStaticEffects(Context& context);

}  // namespace clipc::check
