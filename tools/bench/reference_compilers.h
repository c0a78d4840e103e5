// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>

#include "compiler/compile/compile.h"

// Compiling HLSL to GLSL without clipc, by libraries in this process: glslang's HLSL front end
// makes SPIR-V, and SPIRV-Cross makes GLSL of it.
namespace clipc::bench {

// Set up and free glslang's process-wide state.
void StartReferenceCompilers();
void StopReferenceCompilers();

// Compiles the request's text to GLSL 4.50, between StartReferenceCompilers() and
// StopReferenceCompilers(). Uses its path, stage, entry point, macros and include folders. Returns
// none where the reference compilers fail.
std::optional<std::string> CompileWithReferenceCompilers(const ProgramRequest& request);
// Compiles the file at the request's path in the same way.
std::optional<std::string> CompileFileWithReferenceCompilers(const ProgramRequest& request);

}  // namespace clipc::bench
