// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include "base/diagnostics.h"
#include "ir/program.h"

namespace clipc::resolve {

// stream.Append(vertex)    =>  append_stream(vertex), which writes the outputs and emits them
// stream.RestartStrip()    =>  an EndPrimitive of the stream's number
//
// Requires that objects are global variables: ResolveObjects. Ensures that no expression is a
// stream. Reports a stream that is not a parameter of the entry point.
void LowerStreams(ir::Program& program, Diagnostics& diagnostics);

}  // namespace clipc::resolve
