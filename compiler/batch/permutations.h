// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/command/command_line.h"

namespace clipc {

// A macro that has several values in turn.
struct MacroAxis {
  std::string macro;
  std::vector<std::optional<std::string>> values;  // none: the macro is not defined
};

// A shader with everything settled but the values of its axes.
struct ShaderGroup {
  CommandLine command;  // its inputs and its output are those of the whole run
  std::string source;
  std::string name;  // the start of the names of its files, which a permutation adds to
  std::vector<MacroAxis> axes;
  std::string label;  // what tells it from others of the source, in messages; may be empty

  // The product of the numbers of values; SIZE_MAX if that is too large.
  std::size_t Count() const;
};

// The most permutations that one run compiles.
inline constexpr std::size_t kMaxPermutations = std::size_t{1} << 18;

// Moves the macros with a list of values, "A={0,1,2}", out of `defines`. A value is the text
// between two commas outside brackets; "A={{1,2}}" has the one value "{1,2}".
std::vector<MacroAxis> TakeAxes(std::vector<std::string>& defines);

// The beginning of a text, with `_` for characters that are not for names of files.
std::string AsFileName(std::string_view text);

// The index of each axis' value in the permutation with this number. The last axis varies first.
std::vector<std::size_t> ChoicesOf(const ShaderGroup& group, std::size_t number);

// The definitions of a permutation, "A=0".
std::vector<std::string> DefinesOf(const ShaderGroup& group, std::size_t number);

// The name of a permutation's files, without an extension: "water.A0.B1", where A and B have
// several values. Characters that are not for names of files become `_`, so that two permutations
// may have one name.
std::string FileNameOf(const ShaderGroup& group, std::size_t number);

// "water.hlsl A=0 B=1", for people.
std::string TitleOf(const ShaderGroup& group, std::size_t number);

}  // namespace clipc
