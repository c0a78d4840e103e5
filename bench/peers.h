// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <optional>
#include <string>

// The way from HLSL to GLSL without clipc, as libraries in this process: glslang's HLSL front end to SPIR-V, SPIRV-Cross
// from there to GLSL.
namespace clipc::bench {

// GLSL 4.50, or nothing where the peers fail. Set up glslang's process-wide state before with StartPeers().
std::optional<std::string> CompileWithPeers(const std::string& hlsl);
void StartPeers();
void StopPeers();

}  // namespace clipc::bench
