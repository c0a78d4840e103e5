// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "compiler/command/command_line.h"

// Every spelling of every option, and what it does.
namespace clipc {

// The state of reading the arguments: what those read so far say.
struct Reading {
  CommandLine command;
  std::string argument;  // the argument that is being read
  std::string option;    // the option that it begins with
  std::string advice;    // its Option::help
  std::string next;      // the argument after it; empty: none
  Result<> result;       // the first mistake in the arguments
  // The options that clipc does not have, as they are written, with the advice for each.
  std::vector<std::pair<std::string, std::string>> unknown;

  std::optional<bool> validate;        // --validate or --no-validate; none: neither
  std::optional<glsl::Target> target;  // none: the user names none
  glsl::BindingRules bindings;
  bool joins_samplers = false;           // glslang's --auto-sampled-textures
  bool maps_registers = false;           // glslang's --hlsl-iomap
  std::vector<std::string> kind_shifts;  // options for the bindings of images and storage blocks
  bool writes_spirv = false, spirv_for_vulkan = true;
  std::string source_entry;          // glslang's --source-entrypoint
  bool names_profile = false;        // -T
  std::optional<Stage> stage;        // -S
  bool preserves_interface = false;  // dxc's -fspv-preserve-interface
  SpirvRequest spirv;
  std::string vulkan_option;       // the last option that is for target `vulkan` only
  std::string spirv_option;        // the last one that is for SPIR-V only
  bool preprocesses_only = false;  // glslang's -E
  bool preprocess = false;         // -P
  std::string preprocess_name, preprocess_output;  // the values of -P and of -Fi
  struct Ignored {
    std::string option, why;
  };
  std::vector<Ignored> without_effect;  // options of other compilers
  std::vector<std::string> foreign_warnings;
  bool is_of_tool = false;  // an option says that the line was another compiler's

  void Refuse(std::string what) {
    if (result) result = Problem{std::move(what)};
  }
};

// The error that an option which needs a value has none.
std::string NeedsValue(const Reading& reading);

// The bit of a spelling in Option::starts: its first letter, "T" of "-T", or one like it.
constexpr std::uint64_t StartOf(std::string_view spelling) {
  const std::size_t letter = spelling.starts_with("--") ? 2 : 1;
  return std::uint64_t{1} << ((spelling.size() > letter ? spelling[letter] : ' ') & 63);
}
constexpr std::uint64_t StartsOf(std::string_view names) {
  std::uint64_t starts = 0;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (i == 0 || names[i - 1] == ' ') starts |= StartOf(names.substr(i));
  return starts;
}

struct Option {
  enum class Form : std::uint8_t {
    kFlag,
    kJoined,            // -Wno-x
    kSeparate,          // -e main
    kJoinedOrSeparate,  // -Ix or -I x
    kDefinition,        // -Dx or -D x; alone, or before what is not a macro's name, glslang's -D
    kOptional,          // -P or -P x
    kEquals,            // --target=x or --target x
    kTwo,               // -fvk-b-shift 2 0: the value is "2 0"
    kFour,              // -fvk-bind-register b0 0 1 0
    kNumbers,           // --sub 5, --sub=5, --sub 5 0 7 1: also the numbers that follow
    kRegisters,         // --rsb t0 1 2 t1 1 3: also the numbers and the registers
  };

  // The option's spellings, apart by one blank: one where --help lists the option, none where the
  // row begins a topic of --help.
  std::string_view names;
  Form form;
  void (*read)(Reading& reading, const std::string& value);
  // The name of the value in --help, or of the topic; null if --help does not list the option.
  const char* metavar = nullptr;
  // The text in --help, or the title of the topic; for an option that --help does not list, the
  // advice that is added to its message.
  const char* help = "";
  // What the spellings begin with: a search looks at few rows so.
  std::uint64_t starts = StartsOf(names);

  bool IsTopic() const { return names.empty(); }
};

// A row that has no option and begins a topic of --help.
constexpr Option Topic(const char* name, const char* title) {
  return {"", Option::Form::kFlag, nullptr, name, title};
}
// The topic of the other compilers' options, which has a row for each way to read them.
inline constexpr char kCompilersTopic[] = "compilers";

// The options of clipc, in the order of --help, and the other compilers' options.
std::span<const Option> OwnOptions();
std::span<const Option> ForeignOptions();

// The spellings of all options, in the order of the tables.
std::vector<std::string_view> Spellings();

// One spelling of an option.
struct Spelling {
  std::string_view name;
  const Option* option = nullptr;
};
// The option that `argument` is, or begins with: the one with the longest such name. A
// Spelling without an option says that there is none.
Spelling FindOption(std::string_view argument);

}  // namespace clipc
