// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/span.h"
#include "ir/program.h"
#include "link/interface.h"

// Readers of pixel shaders. Each takes a whole file and reads nothing else. Whatever the bytes are,
// a reader returns: with an interface, or with problems.
namespace clipc::link {

enum class Language : std::uint8_t { kSpirv, kGlsl, kHlsl };

// Returns the language of a pixel shader by its content: SPIR-V has its magic number, in either
// order of bytes; GLSL has #version, or names of GLSL's vectors and variables and none of HLSL's.
// The rest is HLSL.
Language LanguageOf(std::string_view bytes);

struct ReadResult {
  Interface interface = {};
  bool is_glsl = false;  // its names are those that the driver sees
  // The problems, as in "water.frag:12: ..."; empty if the interface is right.
  std::vector<std::string> problems = {};
};

// Reads SPIR-V 1.0 to 1.6. `entry` names a fragment entry point; empty: the only one.
ReadResult ReadSpirv(std::string_view bytes, std::string_view path, std::string_view entry);

// Reads GLSL and GLSL ES of any version, for OpenGL or for Vulkan, in glslang's judgement.
// `expected` decides the version of a text without #version, GLSL 1.10 or GLSL ES 1.00, and the
// rules by which mistakes are reported.
enum class Dialect : std::uint8_t { kDesktop, kEs, kVulkan };
ReadResult ReadGlsl(std::string_view text, const std::string& path,
                    Dialect expected = Dialect::kDesktop);

// Describes the mistake in an interface that a reader made: two inputs in one place, an input that
// is too large or too high a location, or a location for some inputs only. Empty: there is none.
std::string Problem(const Interface& interface);

// Reads a program that Check returned for a pixel profile. `place` returns the place of a span, for
// messages.
Interface ReadProgram(const ir::Program& program, const std::function<std::string(Span)>& place);

// Reads what a pixel shader that clipc writes itself declares: the inputs that it reads, each row
// of a matrix by itself, and no blocks. The layout of the program names them.
Interface ReadInputs(const ir::Program& program, const std::function<std::string(Span)>& place);

}  // namespace clipc::link
