// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>

#include "compiler/compile.h"

// The way from HLSL to GLSL without clipc, as libraries in this process: glslang's HLSL front end
// to SPIR-V, SPIRV-Cross from there to GLSL.
namespace clipc::bench {

// GLSL 4.50, or nothing where the peers fail. Set up glslang's process-wide state before with
// StartPeers().
std::optional<std::string> CompileWithPeers(const std::string& hlsl);
// The shader of a file; of the request counts what says where it is and what to compile.
std::optional<std::string> CompileFileWithPeers(const CompileRequest& request);
void StartPeers();
void StopPeers();

}  // namespace clipc::bench
