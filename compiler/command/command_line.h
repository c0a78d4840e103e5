// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "base/stage.h"
#include "compiler/compile/request.h"

namespace clipc {

// The words of -HV.
inline constexpr Named<LanguageVersion> kLanguageNames[] = {{LanguageVersion::k2016, "2016"},
                                                            {LanguageVersion::k2017, "2017"},
                                                            {LanguageVersion::k2018, "2018"},
                                                            {LanguageVersion::k2021, "2021"}};

// The framework whose effects are read: docs/effects.md.
enum class EffectDialect : std::uint8_t { kDirect3D, kMonoGame, kObs };
inline constexpr Named<EffectDialect> kEffectDialects[] = {{EffectDialect::kDirect3D, "direct3d"},
                                                           {EffectDialect::kMonoGame, "monogame"},
                                                           {EffectDialect::kObs, "obs"}};

enum class MessageFormat : std::uint8_t { kText, kMsvc, kJson, kSarif };

// The stages whose shaders may stand between the first shader and the pixel shader, in the order of
// the pipeline. Each has two options, --geometry-entry and --geometry-output.
inline constexpr Stage kMiddleStages[] = {Stage::kHull, Stage::kDomain, Stage::kGeometry};

// A shader of the same file for such a stage. Empty: not given.
struct MiddleShader {
  std::string entry;
  std::string output;  // its GLSL
};

// A command line. Its names of a profile and passes are unchecked; Compile checks them.
struct CommandLine {
  enum class Action : std::uint8_t { kCompile, kHelp, kExplain, kVersion };

  Action action = Action::kCompile;
  std::string help_topic;  // of --help; empty: all
  std::string explained;   // the name of a diagnostic, for --explain
  std::vector<std::string> inputs;
  std::vector<std::string> response_files;
  ProgramRequest request;  // without the path and the text of its first shader
  // What the options say of the shader after the first. Empty: not given.
  ShaderSource pixel_shader = {.entry = {}, .profile = {}};
  // The files to write; empty if not asked for. A value that is only an extension, ".json", names
  // the file after the GLSL.
  std::string output;  // the GLSL: empty is standard output, unless the options ask for others
  std::string pixel_output;  // the GLSL of a pair's pixel shader
  std::array<MiddleShader, std::size(kMiddleStages)> middle = {};  // by kMiddleStages
  std::vector<std::string> tables, reflections;
  std::string struct_prefix;     // of the names of C structs
  std::string header, variable;  // -Fh, -Vn
  // The form of SPIR-V in files: binary, numbers in C, which braces may enclose, or a listing.
  enum class SpirvForm : std::uint8_t { kBinary, kNumbers, kInBraces, kListing };
  SpirvForm spirv_form = SpirvForm::kBinary;
  std::string messages;      // -Fe
  std::string listing;       // -Fc
  std::string preprocessed;  // -P
  std::string fragment;      // a file: the fragment shader for --lower=discard
  bool write_dependencies = false;
  bool only_dependencies = false;  // -M
  std::string dependency_file, dependency_target;
  bool show_includes = false;
  bool syntax_only = false;
  MessageFormat format = MessageFormat::kText;
  std::optional<bool> colour;                   // none: if standard error is a terminal
  unsigned jobs = 1;                            // the number of inputs that are compiled at once
  std::string batch;                            // a manifest
  bool effect = false;                          // the input is an effect: docs/effects.md
  std::string technique, pass;                  // of the effect; empty: all
  std::optional<EffectDialect> effect_dialect;  // none: what the effect's text shows
  bool names_target = false;                    // the options choose the target, or SPIR-V
  std::string index;               // the index of permutations: see docs/permutations.md
  bool keep_going = false;         // go on after a permutation with errors
  bool resume = false;             // leave out what an earlier run of the batch did
  bool merge_shards = false;       // the inputs are indexes of parts, to be one index
  unsigned shard = 1, shards = 1;  // only each `shards`-th permutation, from number `shard` on
  bool watch = false;              // compile again what changes, until an interrupt
  Diagnostics notices;             // warnings about the options
};

}  // namespace clipc
