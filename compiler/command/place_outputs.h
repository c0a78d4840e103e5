// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/command/command_line.h"

namespace clipc {

// The paths of all outputs for one input. Empty: not asked for. "-": standard output.
struct OutputPaths {
  std::string glsl, fragment, dependencies, header, listing, preprocessed;
  std::array<std::string, std::size(kMiddleStages)> middle;  // by kMiddleStages
  std::vector<std::string> tables, reflections;
  // Of the make rule: what -MT names, or else every file that the command writes from the sources.
  std::vector<std::string> dependency_targets;

  // The outputs that are files: the paths that are neither empty nor "-".
  std::vector<std::string> Named() const;
};

OutputPaths PlaceOutputs(const CommandLine& command, const std::string& input);

// The extension of a shader that is named after its input: ".vert", ".frag" of a pixel shader.
std::string_view ExtensionOf(const ProgramRequest& request);

// "water.vert" => "water"; a dot at the start of a file's name begins no extension.
std::string WithoutExtension(const std::string& path);

// A file that an option names: after `name` if the value is only an extension, ".json".
std::string NameAfter(const std::string& value, const std::string& name);

// "water.2.vert": the shader with two planes.
std::string VariantName(const std::string& path, std::size_t planes);

// Whether the extension of a file's name is that of compiled shaders.
bool SaysOtherThanGlsl(std::string_view path);

// The text of a C header with `glsl` as the string `variable`, for -Fh.
std::string HeaderWith(std::string_view glsl, std::string_view variable);
// The words of SPIR-V as numbers in C, each with a comma after it, in lines that begin with `\n`.
std::string WordsInC(std::span<const std::uint32_t> words);
// The text of a C header with the words of SPIR-V as the array `variable`.
std::string HeaderWith(std::span<const std::uint32_t> words, std::string_view variable);

}  // namespace clipc
