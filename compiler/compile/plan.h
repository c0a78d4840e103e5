// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <string>

#include "backend-glsl/write_options.h"
#include "base/diagnostics.h"
#include "compiler/compile/check_lowering.h"
#include "compiler/compile/request.h"
#include "frontend/check/check.h"
#include "frontend/lex/source.h"

namespace clipc {

// What is done with one shader of a program: its part of the request, with the names resolved and
// the defaults settled.
struct Plan {
  CheckOptions check;
  LoweringRequest lowering;
  glsl::WriteOptions write;           // without comments
  bool keeps_matrices_whole = false;  // link/whole.h
  std::string stop_after;             // DebugOptions::stop_after, if it is about this shader
};

// Makes the plan of ProgramRequest::shaders[number]. Reports names that nothing has, and parts of
// the request that do not go together whatever the shader is; those of the whole request with the
// first shader. After errors, only the profile has a meaning, for InputOf.
Plan Resolve(const ProgramRequest& request, std::size_t number, Diagnostics& diagnostics);

// The text of that shader, and how it is lexed. Reports a text that the caller does not give.
SourceInput InputOf(const ProgramRequest& request, std::size_t number, const Plan& plan,
                    Diagnostics& diagnostics);

// How the HLSL of the neighbour is read, as far as its interface needs it.
CheckOptions NeighboursCheck(const ProgramRequest& request);
SourceInput NeighboursInput(const ProgramRequest& request, std::string text,
                            const CheckOptions& check);

}  // namespace clipc
